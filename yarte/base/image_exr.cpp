#include "yarte/base/image_file.h"
#include "yarte/base/image_layers.h"

#include <OpenEXR/openexr.h>

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

namespace yarte {

namespace {

void require(exr_result_t result) {
    if (result != EXR_ERR_SUCCESS)
        throw std::runtime_error(std::string("exr: ") + exr_get_default_error_message(result));
}

/// A file of float samples in scan lines, made in memory. OpenEXR's core library is used, not the C++ one,
/// whose start alone takes longer than rendering a small picture.
class ExrFile {
public:
    struct Channel {
        std::string name;
        const float* first;      ///< sample of the block's first line
        std::size_t pixelStride; ///< in samples
        std::size_t lineStride;
    };

    ExrFile(int width, int height) : height_(height) {
        exr_context_initializer_t settings = EXR_DEFAULT_CONTEXT_INITIALIZER;
        settings.user_data = this;
        settings.write_fn = append;
        settings.error_handler_fn = [](exr_const_context_t, exr_result_t, const char*) {}; // results tell
        require(exr_start_write(&context_, "image", EXR_WRITE_FILE_DIRECTLY, &settings));
        int part = 0;
        require(exr_add_part(context_, nullptr, EXR_STORAGE_SCANLINE, &part));
        require(exr_initialize_required_attr_simple(context_, 0, width, height, EXR_COMPRESSION_ZIP));
        require(exr_set_longname_support(context_, 1));
    }
    ~ExrFile() {
        if (isEncoding_) exr_encoding_destroy(context_, &encoder_);
        exr_finish(&context_);
    }
    ExrFile(const ExrFile&) = delete;
    ExrFile& operator=(const ExrFile&) = delete;

    void addChannel(const std::string& name, exr_pixel_type_t type) {
        require(exr_add_channel(context_, 0, name.c_str(), type, EXR_PERCEPTUALLY_LOGARITHMIC, 1, 1));
    }
    void setText(const std::string& name, const std::string& text) {
        require(exr_attr_set_string(context_, 0, name.c_str(), text.c_str()));
    }

    /// `block(y, lines)` gives the channels of `lines` lines from `y` on. Returns the file's bytes.
    template <class Block>
    std::string write(Block&& block) {
        require(exr_write_header(context_));
        int linesPerBlock = 0;
        require(exr_get_scanlines_per_chunk(context_, 0, &linesPerBlock));
        for (int y = 0; y < height_; y += linesPerBlock)
            encode(y, block(y, std::min(linesPerBlock, height_ - y)));
        exr_encoding_destroy(context_, &encoder_), isEncoding_ = false;
        require(exr_finish(&context_));
        return std::move(bytes_);
    }

private:
    static int64_t append(exr_const_context_t, void* self, const void* data, uint64_t size, uint64_t offset,
                          exr_stream_error_func_ptr_t) {
        std::string& bytes = static_cast<ExrFile*>(self)->bytes_;
        try {
            if (bytes.size() < offset + size) bytes.resize(offset + size);
        } catch (const std::exception&) { // may not pass through a C library
            return -1;
        }
        std::copy_n(static_cast<const char*>(data), size,
                    bytes.begin() + static_cast<std::ptrdiff_t>(offset));
        return static_cast<int64_t>(size);
    }

    void encode(int y, const std::vector<Channel>& channels) {
        exr_chunk_info_t chunk{};
        require(exr_write_scanline_chunk_info(context_, 0, y, &chunk));
        const bool isFirst = !isEncoding_;
        require(isFirst ? exr_encoding_initialize(context_, 0, &chunk, &encoder_)
                        : exr_encoding_update(context_, 0, &chunk, &encoder_));
        isEncoding_ = true;
        for (int i = 0; i < encoder_.channel_count; ++i) {
            exr_coding_channel_info_t& to = encoder_.channels[i];
            const auto from = std::ranges::find(channels, to.channel_name, &Channel::name);
            to.user_data_type = EXR_PIXEL_FLOAT, to.user_bytes_per_element = sizeof(float);
            to.user_pixel_stride = static_cast<int32_t>(from->pixelStride * sizeof(float));
            to.user_line_stride = static_cast<int32_t>(from->lineStride * sizeof(float));
            to.encode_from_ptr = reinterpret_cast<const uint8_t*>(from->first);
        }
        if (isFirst) require(exr_encoding_choose_default_routines(context_, 0, &encoder_));
        require(exr_encoding_run(context_, 0, &encoder_));
    }

    int height_;
    std::string bytes_;
    exr_context_t context_ = nullptr;
    exr_encode_pipeline_t encoder_ = EXR_ENCODE_PIPELINE_INITIALIZER;
    bool isEncoding_ = false;
};

} // namespace

std::string encodeExr(const ImageRows& image, const ImageEncoding& encoding) {
    ExrFile file(image.width, image.height);
    const char* names[] = {"R", "G", "B"};
    for (const char* name : names) file.addChannel(name, encoding.half ? EXR_PIXEL_HALF : EXR_PIXEL_FLOAT);
    std::vector<float> samples;
    return file.write([&](int y0, int lines) {
        samples.clear();
        for (int y = y0; y < y0 + lines; ++y) {
            const Colour* const row = image.row(y);
            for (int x = 0; x < image.width; ++x)
                for (const double v : {row[x].r, row[x].g, row[x].b})
                    samples.push_back(static_cast<float>(v));
        }
        std::vector<ExrFile::Channel> channels;
        for (std::size_t i = 0; i < 3; ++i)
            channels.push_back({names[i], &samples[i], 3, 3 * static_cast<std::size_t>(image.width)});
        return channels;
    });
}

std::string encodeExrLayers(const LayeredImage& image) {
    ExrFile file(image.width, image.height);
    for (const auto& [name, text] : image.attributes) file.setText(name, text);
    for (const ImageLayer& layer : image.layers) file.addChannel(layer.name, EXR_PIXEL_FLOAT);
    const auto width = static_cast<std::size_t>(image.width);
    return file.write([&](int y, int) {
        std::vector<ExrFile::Channel> channels;
        for (const ImageLayer& layer : image.layers)
            channels.push_back({layer.name, &layer.values[static_cast<std::size_t>(y) * width], 1, width});
        return channels;
    });
}

} // namespace yarte
