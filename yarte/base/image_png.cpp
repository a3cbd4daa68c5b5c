#include "yarte/base/image_file.h"

#include <png.h>

#include <csetjmp>
#include <new>
#include <stdexcept>
#include <utility>

namespace yarte {

namespace {

/// What libpng's callbacks share with us. No exception may pass through libpng, a C library: they are kept as
/// words.
struct PngTarget {
    std::string bytes;
    std::string row;
    std::string error = "not enough memory";
};

void appendBytes(png_structp png, png_bytep data, png_size_t size) {
    auto& target = *static_cast<PngTarget*>(png_get_io_ptr(png));
    bool good = true;
    try {
        target.bytes.append(reinterpret_cast<const char*>(data), size);
    } catch (const std::exception&) {
        good = false;
    }
    if (!good) png_error(png, "not enough memory");
}

[[noreturn]] void keepError(png_structp png, png_const_charp message) {
    auto& target = *static_cast<PngTarget*>(png_get_error_ptr(png));
    try {
        target.error = message;
    } catch (const std::exception&) {
        target.error = "memory";
    } // short enough to need none
    png_longjmp(png, 1);
}

void ignoreWarning(png_structp, png_const_charp) {}

/// libpng's part. Objects with destructors live with the caller: an error jumps back to setjmp past them.
bool writePng(png_structp png, png_infop info, const ImageRows& image, const ImageEncoding& encoding,
              PngTarget& target) {
    if (setjmp(png_jmpbuf(png))) return false;
    png_set_write_fn(png, &target, appendBytes, nullptr);
    png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    // Measured on a smooth picture of 1024 x 1024, 16 bits: the fastest pair is also among the smallest (0.07
    // s, 0.95 MB; libpng's own choice of filters 0.11 s, 1.14 MB).
    png_set_compression_level(png, 1);
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_UP);
    png_set_IHDR(png, info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height),
                 encoding.depth, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    for (int y = 0; y < image.height; ++y) {
        target.row.clear();
        appendDisplayRow(target.row, image, y, encoding);
        png_write_row(png, reinterpret_cast<png_const_bytep>(target.row.data()));
    }
    png_write_end(png, nullptr);
    return true;
}

} // namespace

std::string encodePng(const ImageRows& image, const ImageEncoding& encoding) {
    PngTarget target;
    target.row.reserve(static_cast<std::size_t>(image.width) *
                       6); // so that no row allocates, and throws, in writePng
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &target, keepError, ignoreWarning);
    if (!png) throw std::bad_alloc();
    png_infop info = png_create_info_struct(png);
    const bool good = info && writePng(png, info, image, encoding, target);
    png_destroy_write_struct(&png, &info);
    if (!good) throw std::runtime_error("png: " + target.error);
    return std::move(target.bytes);
}

} // namespace yarte
