// Image files, as the validator reads them: most of what is tried is OpenImageIO's, so it is what we make of
// its answers that counts, and how it is kept within bounds.
#include "tests/fuzz/scratch.h"
#include "tests/fuzz/target.h"

#include "validate/image_file.h"

#include <OpenImageIO/imageio.h>
#include <iterator>

namespace {

using namespace std::string_view_literals;

/// The name that its format is known by, so that files are seeds as they are; another begins as one likes.
std::string_view nameFor(std::string_view bytes) {
    constexpr std::pair<std::string_view, std::string_view> formats[] = {
        {"\x89PNG"sv, "a.png"}, {"\x76\x2f\x31\x01"sv, "a.exr"},
        {"P"sv, "a.ppm"},       {"II*"sv, "a.tif"},
        {"MM\0*"sv, "a.tif"},   {"#?"sv, "a.hdr"}};
    if (bytes.starts_with("PF") || bytes.starts_with("Pf")) return "a.pfm";
    for (const auto& [magic, name] : formats)
        if (bytes.starts_with(magic)) return name;
    return bytes.empty() ? "a.png"
                         : formats[static_cast<unsigned char>(bytes[0]) % std::size(formats)].second;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const yarte::fuzz::Scratch scratch;
    // What is large takes long, and goes the same ways.
    [[maybe_unused]] static const bool areSmall = OIIO::attribute("limits:imagesize_MB", 1);
    const std::string_view bytes = yarte::fuzz::textOf(data, size);
    const std::filesystem::path file = scratch.put(nameFor(bytes), bytes);
    try {
        const yarte::validate::Picture picture = yarte::validate::readPicture(file);
        if (picture.pixels.size() !=
            static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height))
            std::abort();
    } catch (const yarte::validate::ImageError&) {
    }
    if (file.extension() != ".exr") return 0; // what has layers
    try {
        yarte::validate::readLayers(file);
    } catch (const yarte::validate::ImageError&) {
    }
    return 0;
}
