// Asset: an open glTF file, with all that its parts need of each other.
#pragma once

#include "convert/gltf/content.h"
#include "convert/gltf/hierarchy.h"
#include "convert/gltf/primitive.h"

#include <memory>

namespace yarte::convert::gltf {

/// Of a mesh of triangles.
struct MeshSize {
    std::size_t vertices = 0, corners = 0;
    bool smooth = false;
};

class Asset {
public:
    /// Nothing after reporting what is wrong. `bytes` must outlive it; `name` stands before errors.
    static std::unique_ptr<Asset> open(std::string_view bytes, const std::string& name, UriBase,
                                       Diagnostics&);

    Asset(const Asset&) = delete;
    Asset& operator=(const Asset&) = delete;

    const Json& root() const { return root_; }
    const Document& document() const { return *document_; }
    const Hierarchy& hierarchy() const { return *hierarchy_; }
    Content& content() { return *content_; }
    Errors& errors() { return errors_; }

    /// How the mesh of the node is deformed; nothing after reporting an error.
    std::optional<Pose> poseOf(std::uint32_t node);

    /// False after reporting that this and what came before is too much for a file of its size: a few bytes
    /// can ask for much, by many nodes with one mesh or by accessors without bytes.
    bool takeRoom(std::size_t bytes, const Json& at);
    bool takeRoom(const MeshSize&, const Json& at);

private:
    Asset(Json root, const std::string& name, Diagnostics& diagnostics)
        : root_(std::move(root)), errors_(name, root_, diagnostics) {}

    Json root_;
    Errors errors_;
    std::optional<Document> document_;
    std::optional<Content> content_;
    std::optional<Hierarchy> hierarchy_;
    std::size_t room_ = 0; ///< bytes left
};

} // namespace yarte::convert::gltf
