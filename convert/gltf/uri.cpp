#include "convert/gltf/uri.h"

#include "convert/gltf/percent.h"
#include "yarte/base/base64.h"
#include "yarte/base/text.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

namespace yarte::convert::gltf {
namespace {

Resource refuse(std::string problem) { return {{}, std::move(problem)}; }

/// What we do with the bytes does not depend on their media type.
Resource readData(std::string_view uri) {
    const std::size_t comma = uri.find(',');
    if (comma == uri.npos || !uri.substr(0, comma).ends_with(";base64"))
        return refuse("only base64 data can be read");
    auto bytes = base64Decoded(uri.substr(comma + 1));
    if (!bytes) return refuse("the data are not base64");
    return {std::move(*bytes), {}};
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
