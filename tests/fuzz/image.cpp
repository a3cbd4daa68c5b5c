// Image files, as the validator reads them: most of what is tried is OpenImageIO's, so it is what we make of
// its answers that counts, and how it is kept within bounds.
#include "tests/fuzz/target.h"

#include "validate/image_file.h"
#include "yarte/base/file.h"

#include <filesystem>
#include <unistd.h>

namespace {

/// In memory, with the name that a format is known by.
std::filesystem::path scratch(const char* extension) {
    return "/dev/shm/yarte-fuzz-" + std::to_string(::getpid()) + extension;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr const char* extensions[] = {".png", ".exr", ".ppm", ".pfm", ".tif"};
    if (size == 0) return 0;
    const std::filesystem::path file = scratch(extensions[data[0] % std::size(extensions)]);
    yarte::writeFile(file, yarte::fuzz::textOf(data + 1, size - 1));
    try {
        yarte::validate::readPicture(file);
    } catch (const yarte::validate::ImageError&) {
    }
    try {
        yarte::validate::readLayers(file);
    } catch (const yarte::validate::ImageError&) {
    }
    std::filesystem::remove(file);
    return 0;
}
