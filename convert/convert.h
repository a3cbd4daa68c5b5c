// convert: one run from reading to the files to write. Writing them, printing and exiting are main's.
#pragma once

#include "convert/options.h"

#include <vector>

namespace yarte::convert {

/// The files that the conversion makes, the main one first; none after an error was reported. Losses are in
/// the ledger, and warnings. Throws FileError if the input cannot be read.
std::vector<OutputFile> convert(const Options&, Sources&, Diagnostics&, Ledger&);

} // namespace yarte::convert
