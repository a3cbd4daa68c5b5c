#include "convert/format.h"

#include "convert/gltf/read.h"
#include "convert/gltf/write.h"
#include "convert/pmf_format.h"
#include "convert/povray/sdl/read.h"
#include "convert/povray/write.h"
#include "convert/yarte_format.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace yarte::convert {

std::span<const Format> formats() {
    static const Format table[] = {
        {"yarte", {".yarte"}, readYarteScene, writeYarteScene},
        {"pmf", {".pmf"}, readMeshAsScene, writeMesh},
        {"gltf", {".gltf"}, gltf::readScene, gltf::writeGltf},
        {"glb", {".glb"}, gltf::readScene, gltf::writeGlb},
        {"pov", {".pov"}, povray::readScene, povray::writeScene},
    };
    return table;
}

const Format* formatNamed(std::string_view name) {
    const auto found = std::ranges::find(formats(), name, &Format::name);
    return found == formats().end() ? nullptr : &*found;
}

const Format* formatOf(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    // ASCII only: file names follow no locale.
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    for (const Format& format : formats())
        if (std::ranges::find(format.extensions, extension) != format.extensions.end()) return &format;
    return nullptr;
}

std::string listFormats() {
    std::string text;
    for (const Format& format : formats()) {
        const std::string_view use = format.read && format.write ? "read, write"
                                     : format.read               ? "read"
                                                                 : "write";
        text += fmt::format("{:8}{:14}{}\n", format.name, fmt::join(format.extensions, " "), use);
    }
    return text;
}

} // namespace yarte::convert
