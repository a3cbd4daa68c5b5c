// Image files: one way in for all formats. What each holds is in yarte/README.md, "Outputs".
#pragma once

#include "yarte/base/image.h"

#include <filesystem>
#include <optional>
#include <string>

namespace yarte {

/// How colours become numbers in a file. Each format uses what applies to it.
struct ImageEncoding {
    double gamma = 1;       ///< png, ppm, dmp: display value = linear^(1/gamma)
    int depth = 8;          ///< png, ppm: bits a sample, 8 or 16
    bool linear = false;    ///< png, ppm: no gamma
    bool half = false;      ///< exr: 16-bit samples instead of 32-bit
    bool bigEndian = false; ///< dmp: byte order of width and height

    /// Of png and ppm.
    double displayGamma() const { return linear ? 1 : gamma; }
};

enum class ImageFormat { png, ppm, pfm, exr, dmp };

/// By the file's extension, in either case; nothing for an unknown one.
std::optional<ImageFormat> imageFormat(const std::filesystem::path& file);

/// The extensions, for messages: ".png .ppm .pfm .exr .dmp".
std::string imageExtensions();

/// True if a file of this format can hold an image of this size.
bool canHold(ImageFormat, int width, int height);

/// The bytes of a file. The same image gives the same bytes: no time stamps, no program names.
std::string encodeImage(ImageFormat, const ImageRows&, const ImageEncoding&);

// One function per format; the format's own header is all that differs.
std::string encodePng(const ImageRows&, const ImageEncoding&); ///< RGB, no gAMA chunk
std::string encodePpm(const ImageRows&, const ImageEncoding&); ///< binary, 16-bit samples big-endian
std::string encodePfm(const ImageRows&); ///< linear float32, little-endian, rows from the bottom
std::string encodeExr(const ImageRows&,
                      const ImageEncoding&); ///< linear, channels R G B, scan lines in ZIP blocks
std::string encodeDmp(const ImageRows&,
                      const ImageEncoding&); ///< the paper's raw dump, at most 65535 pixels a side

/// One row of png's and ppm's samples, R G B a pixel, in one byte or in two, the high one first.
void appendDisplayRow(std::string& bytes, const ImageRows&, int y, const ImageEncoding&);

} // namespace yarte
