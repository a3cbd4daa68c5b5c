#include "validate/digest.h"

#include <OpenImageIO/hash.h>

namespace yarte::validate {

std::string digest(std::string_view bytes) { return OIIO::SHA1(bytes.data(), bytes.size()).digest(); }

} // namespace yarte::validate
