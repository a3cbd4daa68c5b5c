// Output: a glTF file in the making: its lists, its binary data, and both as files.
#pragma once

#include "convert/format.h"
#include "convert/gltf/write_json.h"
#include "convert/tessellate.h"

#include <map>
#include <set>

namespace yarte::convert::gltf {

class Output {
public:
    /// Appends to a list of the root ("nodes"); the element's index.
    std::size_t add(const std::string& list, Json element);
    /// The same for a list in an extension of the root.
    std::size_t add(const std::string& extension, const std::string& list, Json element);
    /// Every extension that is written must be named here.
    void use(const std::string& extension) { extensions_.insert(extension); }

    std::size_t addPositions(const std::vector<Vec3f>&); ///< an accessor, with its bounds
    std::size_t addNormals(const std::vector<Vec3f>&);
    std::size_t addIndices(const std::vector<std::array<std::uint32_t, 3>>&);

    /// JSON with the binary data in a file beside it, or within it where there is no file but standard
    /// output.
    std::vector<OutputFile> asGltf(const std::filesystem::path& file) const;
    /// Nothing if it would be beyond the 4 GiB of that format.
    std::vector<OutputFile> asGlb(const std::filesystem::path& file) const;

private:
    std::size_t addAccessor(const void* data, std::size_t size, Json accessor, double target);
    std::string jsonText(const std::string& bufferUri) const;

    std::map<std::string, Json::Array> lists_;
    std::map<std::string, std::map<std::string, Json::Array>> extensionLists_;
    std::set<std::string> extensions_;
    std::string binary_;
};

} // namespace yarte::convert::gltf
