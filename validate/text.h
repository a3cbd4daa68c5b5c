// Text from outside (what programs print, names of files), made fit for reports.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace yarte::validate {

/// Valid UTF-8 without control characters other than line feed and tab: what is not becomes U+FFFD.
std::string cleanText(std::string_view bytes);

/// Without white space at its end.
std::string_view trimmedEnd(std::string_view text);

/// For text of XML and HTML, and for attributes of one line in double quotes.
std::string markupText(std::string_view text);

/// A command line that a POSIX shell reads as these arguments.
std::string shellCommand(const std::vector<std::string>& arguments);

} // namespace yarte::validate
