// Binary PGM and PPM files (netpbm's P5 and P6, up to 16 bits). Read here because OpenImageIO 2.4 reads half
// of all 16-bit values one too small: it scales by 65535/65535 in single precision and truncates.
#pragma once

#include "validate/picture.h"

#include <stdexcept>
#include <string_view>

namespace yarte::validate {

/// What() says what is wrong with the file.
class PnmError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// True if the file with these bytes is one for readPnm.
bool isBinaryPnm(std::string_view bytes);

/// Values divided by the file's largest; grey has three equal channels. Only the first picture of several.
/// Throws PnmError.
Picture readPnm(std::string_view bytes);

} // namespace yarte::validate
