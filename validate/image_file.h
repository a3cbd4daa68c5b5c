// Image files: reading any format that OpenImageIO knows, and making PNGs.
#pragma once

#include "validate/display.h"
#include "validate/picture.h"

#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

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

/// A file of named channels in floating point, as `yarte --aov` writes.
struct Layers {
    int width = 0, height = 0;
    std::map<std::string, std::vector<float>> channels; ///< width * height values each, row 0 on top
    std::string scene; ///< the header's attribute "yarte.scene"; may be empty
};

/// All channels in `file`. Throws ImageError.
Layers readLayers(const std::filesystem::path& file);

/// The bytes of a PNG file, 8 bits a channel. Throws ImageError.
std::string encodePng(const DisplayPicture&);

} // namespace yarte::validate
