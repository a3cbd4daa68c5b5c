// Bodies as SDL objects, in the order of the scene and with its numbers.
#pragma once

#include "convert/ledger.h"
#include "yarte/base/source.h"
#include "yarte/scene/scene.h"

#include <cstddef>
#include <string>

namespace yarte::convert::povray {

struct BodyWriting {
    const Scene& scene;
    const Sources& sources;
    bool plain = false; ///< the fastest forms, see WriteOptions
    Ledger& ledger;
};

/// The body's object, with a comment before it; `material` names its SDL material.
std::string bodyText(std::size_t index, const std::string& material, const BodyWriting&);

} // namespace yarte::convert::povray
