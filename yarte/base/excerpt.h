// Excerpt: the line of a source that a diagnostic is about, with the place marked below it.
#pragma once

#include "yarte/base/source.h"

#include <string>

namespace yarte {

/// Two lines without indentation. Tabs are expanded, so that the marks stand under their characters wherever
/// the text is shown (a character is taken to be one column wide); a long line is cut around the place.
struct Excerpt {
    std::string text;
    std::string marks; ///< "^~~~", as long as the span or the rest of its first line
};

Excerpt excerpt(const Source&, Span);

} // namespace yarte
