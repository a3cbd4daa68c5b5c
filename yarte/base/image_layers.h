// LayeredImage: named float32 channels of one size, for OpenEXR.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace yarte {

struct ImageLayer {
    std::string name;          ///< as OpenEXR has it: "depth.Z"
    std::vector<float> values; ///< width * height, row 0 on top
};

struct LayeredImage {
    int width = 0, height = 0;
    std::vector<ImageLayer> layers;                              ///< names are unique
    std::vector<std::pair<std::string, std::string>> attributes; ///< name and text in the file's header
};

/// The bytes of a file: float32 scan lines in ZIP blocks. The same image gives the same bytes.
std::string encodeExrLayers(const LayeredImage&);

} // namespace yarte
