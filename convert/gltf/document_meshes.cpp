// Meshes with their primitives, and skins.
#include "convert/gltf/document_parts.h"

#include <fmt/format.h>

namespace yarte::convert::gltf {
namespace {

class PrimitiveReader {
public:
    PrimitiveReader(const Object& object, const Document& document, std::size_t materialCount)
        : object_(object), document_(document), materialCount_(materialCount) {}

    Primitive read() {
        Primitive primitive;
        primitive.json = &object_.json();
        readMode(primitive);
        primitive.material = object_.index("material", materialCount_);
        object_.require("attributes");
        const auto attributes = object_.object("attributes");
        if (!attributes) return primitive;
        primitive.position = attribute(*attributes, "POSITION", 3, 3);
        if (primitive.position) vertexCount_ = document_.accessors[*primitive.position].count;
        primitive.normal = attribute(*attributes, "NORMAL", 3, 3);
        primitive.colour = attribute(*attributes, "COLOR_0", 3, 4);
        for (std::size_t set = 0;; ++set) {
            const auto joints = attribute(*attributes, fmt::format("JOINTS_{}", set), 4, 4);
            const auto weights = attribute(*attributes, fmt::format("WEIGHTS_{}", set), 4, 4);
            if (!joints || !weights) break;
            primitive.joints.push_back(*joints), primitive.weights.push_back(*weights);
        }
        for (const Object& target : object_.objects("targets"))
            primitive.targets.push_back(
                {attribute(target, "POSITION", 3, 3), attribute(target, "NORMAL", 3, 3)});
        readIndices(primitive);
        refuseDraco(primitive);
        return primitive;
    }

private:
    void readMode(Primitive& primitive) {
        const std::size_t mode = object_.count("mode", 4);
        if (mode > 6)
            object_.error("gltf.out-of-range", fmt::format("must be from 0 to 6, got {}", mode), "mode");
        else
            primitive.mode = static_cast<Mode>(mode);
    }

    /// With a number of components from `least` to `most`, and one element for each vertex.
    std::optional<AccessorId> attribute(const Object& attributes, std::string_view name, int least,
                                        int most) {
        const auto id = attributes.index(name, document_.accessors.size());
        if (!id) return std::nullopt;
        const Accessor& accessor = document_.accessors[*id];
        if (accessor.components < least || accessor.components > most) {
            attributes.error("gltf.bad-attribute",
                             fmt::format("must have {} components, got {}", least, accessor.components),
                             name);
            return std::nullopt;
        }
        if (accessor.type == ComponentType::uint32) {
            attributes.error("gltf.bad-attribute", "must not be of 32-bit integers", name);
            return std::nullopt;
        }
        if (vertexCount_ && accessor.count != *vertexCount_) {
            attributes.error("gltf.bad-attribute",
                             fmt::format("must have as many elements as POSITION, {}, got {}", *vertexCount_,
                                         accessor.count),
                             name);
            return std::nullopt;
        }
        return id;
    }

    void readIndices(Primitive& primitive) {
        primitive.indices = object_.index("indices", document_.accessors.size());
        if (!primitive.indices) return;
        const Accessor& accessor = document_.accessors[*primitive.indices];
        const bool isUnsigned = accessor.type == ComponentType::uint8 ||
                                accessor.type == ComponentType::uint16 ||
                                accessor.type == ComponentType::uint32;
        if (accessor.components != 1 || !isUnsigned || accessor.normalised)
            object_.error("gltf.bad-attribute", "must be unsigned scalars, not normalised", "indices");
    }

    /// Where there is no uncompressed form to fall back to.
    void refuseDraco(const Primitive& primitive) {
        const Json* extensions = object_.find("extensions");
        if (!extensions || !extensions->find("KHR_draco_mesh_compression")) return;
        const auto isMissing = [&](const std::optional<AccessorId>& id) {
            return id && !document_.accessors[*id].view && !document_.accessors[*id].sparse;
        };
        if (isMissing(primitive.position) || isMissing(primitive.indices))
            object_.error("gltf.extension-required",
                          "the content is compressed by KHR_draco_mesh_compression, which is not supported",
                          "extensions");
    }

    const Object& object_;
    const Document& document_;
    std::size_t materialCount_;
    std::optional<std::size_t> vertexCount_;
};

std::size_t countOf(const Object& root, std::string_view name) {
    const Json* array = root.find(name);
    return array ? array->items().size() : 0;
}

} // namespace

void readMeshes(const Object& root, Document& document) {
    const std::size_t materialCount = countOf(root, "materials");
    for (const Object& object : root.objects("meshes")) {
        Mesh mesh;
        mesh.json = &object.json();
        mesh.weights = object.numbers("weights");
        object.require("primitives");
        for (const Object& primitive : object.objects("primitives")) {
            mesh.primitives.push_back(PrimitiveReader(primitive, document, materialCount).read());
            if (mesh.primitives.back().targets.size() != mesh.primitives.front().targets.size())
                primitive.error("gltf.bad-attribute", "all primitives of a mesh must have as many targets");
        }
        if (!mesh.weights.empty() && !mesh.primitives.empty() &&
            mesh.weights.size() != mesh.primitives.front().targets.size())
            object.error("gltf.bad-reference", "must be as many as there are morph targets", "weights");
        document.meshes.push_back(std::move(mesh));
    }
}

void readSkins(const Object& root, Document& document) {
    const std::size_t nodeCount = countOf(root, "nodes");
    for (const Object& object : root.objects("skins")) {
        object.require("joints");
        Skin skin;
        skin.json = &object.json();
        skin.joints = object.indices("joints", nodeCount);
        skin.inverseBindMatrices = object.index("inverseBindMatrices", document.accessors.size());
        if (skin.inverseBindMatrices) {
            const Accessor& matrices = document.accessors[*skin.inverseBindMatrices];
            if (matrices.components != 16 || matrices.type != ComponentType::float32 ||
                matrices.count < skin.joints.size())
                object.error("gltf.bad-attribute", "must be a float32 matrix for each joint",
                             "inverseBindMatrices");
        }
        document.skins.push_back(std::move(skin));
    }
}

} // namespace yarte::convert::gltf
