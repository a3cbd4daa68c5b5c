// POV-Ray's meshes and triangles as meshes of YARTE's. A triangle's front is by the left-hand rule there and
// by the right-hand rule here: two corners change places, unless the transformation mirrors.
#pragma once

#include "convert/povray/sdl/materials.h"

#include <map>
#include <unordered_map>

namespace yarte::convert::povray::sdl {

/// Meshes that are being placed. One that is only moved, turned and evenly scaled is kept once.
class Meshes {
public:
    explicit Meshes(const Model& model) : all_(model.exactMeshes) {}

    /// The faces of `mesh` whose texture is `texture`, all of them if it has no textures. Nothing if none of
    /// them has an area; `flat` counts those that have not.
    std::optional<Mesh> place(const std::shared_ptr<const MeshShape>& mesh, std::uint32_t texture,
                              const Affine&, std::size_t& flat);
    /// As it is.
    Mesh add(MeshData);

    std::size_t size() const { return all_.size(); }
    const MeshData& operator[](MeshId id) const { return all_[id.index]; }
    std::vector<MeshData> take() && { return std::move(all_); }

private:
    struct Kept {
        std::shared_ptr<const MeshShape> alive; ///< so that no other one gets its address
        std::optional<MeshId> id;
        std::size_t flat = 0;
    };
    using Key = std::tuple<const MeshShape*, std::uint32_t, bool>;

    std::vector<MeshData> all_;
    std::map<Key, Kept> kept_;
};

/// Triangles that become one mesh.
class TriangleRun {
public:
    bool isEmpty() const { return data_.faceCount() == 0; }
    /// A single triangle without normals.
    bool isPolygon() const { return data_.faceCount() == 1 && data_.normals.empty(); }
    /// False, and nothing added, if it has no area.
    bool add(const TriangleShape&, const Affine&);
    MeshData take();

private:
    std::uint32_t vertex(Vec3);
    std::uint32_t normal(Vec3);
    void makeSmooth();

    struct Bits {
        std::size_t operator()(Vec3) const;
    };
    MeshData data_;
    std::unordered_map<Vec3, std::uint32_t, Bits> vertices_, normals_;
};

} // namespace yarte::convert::povray::sdl
