// Embree's answers: its own triangles, spheres and discs, in float.
#pragma once

#include "tests/hard/check.h"
#include "tests/hard/others/other_answer.h"

namespace yarte::hard {

/// The case with all its numbers rounded to float: what Embree can be asked.
Case roundedToFloat(Case);

enum class EmbreeMode { fast, robust };

/// Of a case in floats. Not asked: what has other bodies than spheres, discs and triangles, or starts beyond
/// 1e18.
OtherAnswer askEmbree(const Case&, EmbreeMode);

} // namespace yarte::hard
