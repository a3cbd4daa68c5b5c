#include "yarte/base/image_file.h"
#include "yarte/base/image_layers.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <half.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace yarte {

namespace {

class StringStream : public Imf::OStream {
public:
    StringStream() : Imf::OStream("image") {}
    void write(const char c[], int n) override {
        const auto count = static_cast<std::size_t>(n);
        if (bytes_.size() < position_ + count) bytes_.resize(position_ + count);
        bytes_.replace(position_, count, c, count);
        position_ += count;
    }
    std::uint64_t tellp() override { return position_; }
    void seekp(std::uint64_t position) override { position_ = position; } // back, to fill in the line offsets
    std::string take() { return std::move(bytes_); }

private:
    std::string bytes_;
    std::size_t position_ = 0;
};

template <class Sample>
void writeRows(Imf::OutputFile& file, ImageView image, Imf::PixelType type) {
    std::vector<Sample> row(3 * static_cast<std::size_t>(image.width));
    Imf::FrameBuffer rows;
    const char* names[] = {"R", "G", "B"};
    for (std::size_t channel = 0; channel < 3; ++channel) // a y stride of 0: every line is written from `row`
        rows.insert(names[channel],
                    Imf::Slice(type, reinterpret_cast<char*>(&row[channel]), 3 * sizeof(Sample), 0));
    file.setFrameBuffer(rows);
    for (int y = 0; y < image.height; ++y) {
        std::size_t i = 0;
        for (int x = 0; x < image.width; ++x) {
            const Colour& colour = image.at(x, y);
            for (const double v : {colour.r, colour.g, colour.b})
                row[i++] = static_cast<Sample>(static_cast<float>(v));
        }
        file.writePixels();
    }
}

} // namespace

std::string encodeExr(ImageView image, const ImageEncoding& encoding) {
    const Imf::PixelType type = encoding.half ? Imf::HALF : Imf::FLOAT;
    Imf::Header header(image.width, image.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const char* channel : {"R", "G", "B"}) header.channels().insert(channel, Imf::Channel(type));

    StringStream stream;
    {
        Imf::OutputFile file(stream, header, 0 /* threads */);
        encoding.half ? writeRows<half>(file, image, type) : writeRows<float>(file, image, type);
    } // the destructor writes the line offsets
    return stream.take();
}

std::string encodeExrLayers(const LayeredImage& image) {
    Imf::Header header(image.width, image.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const auto& [name, text] : image.attributes) header.insert(name, Imf::StringAttribute(text));

    Imf::FrameBuffer planes;
    for (const ImageLayer& layer : image.layers) {
        header.channels().insert(layer.name, Imf::Channel(Imf::FLOAT));
        char* const base = reinterpret_cast<char*>(const_cast<float*>(layer.values.data())); // only read from
        planes.insert(layer.name, Imf::Slice(Imf::FLOAT, base, sizeof(float),
                                             sizeof(float) * static_cast<std::size_t>(image.width)));
    }
    StringStream stream;
    {
        Imf::OutputFile file(stream, header, 0 /* threads */);
        file.setFrameBuffer(planes);
        file.writePixels(image.height);
    } // the destructor writes the line offsets
    return stream.take();
}

} // namespace yarte
