#include "convert/gltf/uri.h"

#include "convert/gltf/percent.h"
#include "yarte/base/text.h"

#include <fmt/format.h>

// tinygltf brings the decoder of base64.
#include <tiny_gltf.h>

#include <limits>
#include <optional>
#include <vector>

namespace yarte::convert::gltf {
namespace {

Resource refuse(std::string problem) { return {{}, std::move(problem)}; }

/// tinygltf takes some media types only, and what we do with the bytes does not depend on them.
Resource readData(std::string_view uri) {
    const std::size_t comma = uri.find(',');
    if (comma == uri.npos || !uri.substr(0, comma).ends_with(";base64"))
        return refuse("only base64 data can be read");
    if (uri.size() > std::numeric_limits<int>::max()) return refuse("the data are longer than 2 GiB");
    const std::string known = "data:application/octet-stream;base64," + std::string(uri.substr(comma + 1));
    std::vector<unsigned char> bytes;
    std::string mediaType;
    if (!tinygltf::DecodeDataURI(&bytes, mediaType, known, 0, false))
        return refuse("the data are not base64");
    return {{bytes.begin(), bytes.end()}, {}};
}

bool hasScheme(std::string_view uri) {
    const std::size_t end = uri.find_first_of(":/?#");
    return end != uri.npos && uri[end] == ':';
}

} // namespace

UriBase uriBase(const std::filesystem::path& file, ReadableFolders readable) {
    const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
    readable.folders.push_back(folder);
    return {folder, std::move(readable)};
}

Resource readUri(std::string_view uri, const UriBase& base) {
    if (uri.starts_with("data:")) return readData(uri);
    if (hasScheme(uri)) return refuse(fmt::format("{} is not a relative path", inQuotes(uri)));
    const std::string path = percentDecoded(uri);
    if (path.empty() || path.find('\0') != path.npos) return refuse("it is no file's name");
    const std::filesystem::path file = (base.folder / path).lexically_normal();
    if (!base.readable.contain(file))
        return refuse(fmt::format("{} must lie in the file's folder or one that is allowed", inQuotes(path)));
    if (const auto reason = whyUnreadable(file))
        return refuse(fmt::format("cannot read {}: {}", inQuotes(path), *reason));
    try {
        return {readFile(file), {}};
    } catch (const FileError& error) {
        return refuse(fmt::format("cannot read {}: {}", inQuotes(path), error.reason()));
    }
}

} // namespace yarte::convert::gltf
