// Image files: reading any format that OpenImageIO knows, and making PNGs.
#pragma once

#include "validate/display.h"
#include "validate/picture.h"

#include <filesystem>
#include <stdexcept>
#include <string>

namespace yarte::validate {

/// What() is "FILE: reason".
class ImageError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// How the integers of a file are meant. Floating-point files are always linear.
enum class Encoding { linear, srgb };

/// The picture in `file`. Integers become value / largest value, and are decoded if they are `srgb`. A grey
/// picture has three equal channels; alpha and further channels are left out. Throws ImageError.
Picture readPicture(const std::filesystem::path& file, Encoding integers = Encoding::linear);

/// The bytes of a PNG file, 8 bits a channel. Throws ImageError.
std::string encodePng(const DisplayPicture&);

} // namespace yarte::validate
