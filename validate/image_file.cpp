#include "validate/image_file.h"

#include "validate/exr_header.h"
#include "validate/png_chunks.h"
#include "validate/pnm.h"
#include "yarte/base/deflate.h"
#include "yarte/base/file.h"
#include "yarte/base/srgb.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <algorithm>
#include <fmt/format.h>
#include <memory>
#include <new>

namespace yarte::validate {

namespace {

/// A picture as its file stores it.
struct Stored {
    Picture picture;
    bool integers = false;
};

Colour decoded(Colour colour) {
    return {linearFromSrgb(colour.r), linearFromSrgb(colour.g), linearFromSrgb(colour.b)};
}

/// A few bytes can claim any size. So many values any file may hold, and so many more for each of its bytes:
/// of one bit each in deflate.
constexpr double anyValues = 1 << 22, valuesPerByte = 8 * mostFromDeflatedByte;

void checkSize(const OIIO::ImageSpec& spec, std::size_t bytes) {
    const double values = static_cast<double>(spec.width) * spec.height * spec.depth * spec.nchannels;
    if (values > anyValues + valuesPerByte * static_cast<double>(bytes))
        throw ImageError(
            fmt::format("{}x{} pixels are too many for a file of {} bytes", spec.width, spec.height, bytes));
}

/// The file with these bytes open, by the reader that its name's extension stands for and no other:
/// OpenImageIO's own way is to let each of its thirty libraries have a try at a file that the first one
/// refuses. Its size is checked.
std::unique_ptr<OIIO::ImageInput> openImage(const std::filesystem::path& file, std::string_view bytes,
                                            const OIIO::ImageSpec& settings = {}) {
    const std::string extension = file.extension().string();
    auto input = extension.empty() ? nullptr : OIIO::ImageInput::create(extension.substr(1));
    if (!input)
        throw ImageError(fmt::format("'{}' is not the extension of a format that can be read", extension));
    if (!exrAttributesFit(bytes) || !pngChunksFit(bytes))
        throw ImageError("it says that it has more than there is");
    OIIO::ImageSpec spec;
    if (!input->open(file.string(), spec, settings)) throw ImageError(input->geterror());
    checkSize(spec, bytes.size());
    return input;
}

/// All channels of all pixels as numbers of the type T.
template <class T>
std::vector<T> readChannels(OIIO::ImageInput& input, OIIO::TypeDesc type) {
    const OIIO::ImageSpec& spec = input.spec();
    std::vector<T> values(spec.image_pixels() * static_cast<std::size_t>(spec.nchannels));
    // Unknown stands for "as stored", which needs no buffer of 64 MB to convert from.
    const bool isStored = spec.format == type && spec.channelformats.empty();
    if (!input.read_image(0, 0, 0, spec.nchannels, isStored ? OIIO::TypeDesc() : type, values.data()))
        throw ImageError(input.geterror());
    return values;
}

/// The first three channels, or the first one three times.
template <class T>
Picture toPicture(const OIIO::ImageSpec& spec, const std::vector<T>& values, double white) {
    const auto channels = static_cast<std::size_t>(spec.nchannels);
    const std::size_t green = channels < 3 ? 0 : 1, blue = channels < 3 ? 0 : 2;
    Picture picture{spec.width, spec.height, {}};
    picture.pixels.reserve(spec.image_pixels());
    for (std::size_t i = 0; i < values.size(); i += channels)
        picture.pixels.push_back({static_cast<double>(values[i]) / white,
                                  static_cast<double>(values[i + green]) / white,
                                  static_cast<double>(values[i + blue]) / white});
    return picture;
}

Stored readByOpenImageIO(const std::filesystem::path& file, std::string_view bytes) {
    OIIO::ImageSpec asStored;
    asStored.attribute("oiio:UnassociatedAlpha", 1); // else colours are multiplied by alpha
    const auto input = openImage(file, bytes, asStored);
    const OIIO::ImageSpec& spec = input->spec();
    // As they are stored: OpenImageIO's own conversion of integers goes through single precision.
    if (spec.format == OIIO::TypeDesc::UINT8)
        return {toPicture(spec, readChannels<std::uint8_t>(*input, spec.format), 255), true};
    if (spec.format == OIIO::TypeDesc::UINT16)
        return {toPicture(spec, readChannels<std::uint16_t>(*input, spec.format), 65535), true};
    if (spec.format == OIIO::TypeDesc::FLOAT)
        return {toPicture(spec, readChannels<float>(*input, spec.format), 1), false};
    return {toPicture(spec, readChannels<double>(*input, OIIO::TypeDesc::DOUBLE), 1),
            !spec.format.is_floating_point()};
}

Stored readStored(const std::filesystem::path& file) {
    const std::string bytes = readFile(file);
    if (isBinaryPnm(bytes)) return {readPnm(bytes), true};
    return readByOpenImageIO(file, bytes);
}

Layers readLayersByOpenImageIO(const std::filesystem::path& file) {
    const auto input = openImage(file, readFile(file));
    const OIIO::ImageSpec& spec = input->spec();
    Layers layers{spec.width, spec.height, {}, spec.get_string_attribute("yarte.scene")};
    const std::vector<float> values = readChannels<float>(*input, OIIO::TypeDesc::FLOAT);
    const auto channels = static_cast<std::size_t>(spec.nchannels);
    for (std::size_t c = 0; c < channels; ++c) {
        std::vector<float>& channel = layers.channels[spec.channelnames[c]];
        channel.reserve(spec.image_pixels());
        for (std::size_t i = c; i < values.size(); i += channels) channel.push_back(values[i]);
    }
    return layers;
}

/// What `read` gives; whatever goes wrong becomes an ImageError that names the file.
template <class Read>
auto orImageError(const std::filesystem::path& file, Read read) {
    try {
        return read();
    } catch (const FileError& error) {
        throw ImageError(error.what());
    } catch (const std::runtime_error& error) {
        throw ImageError(fmt::format("{}: {}", file.string(), error.what()));
    } catch (const std::bad_alloc&) {
        throw ImageError(fmt::format("{}: does not fit into memory", file.string()));
    }
}

} // namespace

Picture readPicture(const std::filesystem::path& file, Encoding integers) {
    Stored stored = orImageError(file, [&] { return readStored(file); });
    if (stored.integers && integers == Encoding::srgb)
        std::transform(stored.picture.pixels.begin(), stored.picture.pixels.end(),
                       stored.picture.pixels.begin(), decoded);
    return std::move(stored.picture);
}

Layers readLayers(const std::filesystem::path& file) {
    return orImageError(file, [&] { return readLayersByOpenImageIO(file); });
}

std::string encodePng(const DisplayPicture& picture) {
    const auto output = OIIO::ImageOutput::create("png");
    if (!output) throw ImageError(OIIO::geterror());
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const OIIO::ImageSpec spec(picture.width, picture.height, 3, OIIO::TypeDesc::UINT8);
    output->set_ioproxy(&memory);
    if (!output->open("memory.png", spec) ||
        !output->write_image(OIIO::TypeDesc::UINT8, picture.rgb.data()) || !output->close())
        throw ImageError(fmt::format("a PNG: {}", output->geterror()));
    return {bytes.begin(), bytes.end()};
}

} // namespace yarte::validate
