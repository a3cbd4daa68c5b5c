#include "convert/gltf/read_body.h"

#include "convert/gltf/accessor.h"
#include "convert/gltf/mesh_table.h"
#include "convert/gltf/ordered.h"
#include "yarte/scene/check.h"

#include <fmt/format.h>

#include <algorithm>

namespace yarte::convert::gltf {
namespace {

GeometryPrint printOf(const MeshData& mesh) {
    GeometryPrint print;
    const auto corner = [&](std::uint32_t vertex) {
        const Vec3 v = mesh.vertices[vertex];
        return GeometryPrint::Corner{static_cast<float>(v.x), static_cast<float>(v.y),
                                     static_cast<float>(v.z)};
    };
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        const auto face = mesh.face(f);
        print.add(corner(face[0]), corner(face[1]), corner(face[2]));
    }
    return print;
}

Tint averageOf(const std::vector<double>& colours, std::size_t components) {
    std::array<double, 4> sum{};
    for (std::size_t i = 0; i < colours.size(); ++i) sum[i % components] += colours[i];
    const double count = static_cast<double>(colours.size() / components);
    return {{sum[0] / count, sum[1] / count, sum[2] / count}, components == 4 ? sum[3] / count : 1};
}

class BodyReader {
public:
    BodyReader(Asset& asset, Materials& materials, const std::vector<ExactMesh>& known, Ledger& ledger)
        : asset_(asset), materials_(materials), ledger_(ledger), meshes_(asset, known) {}

    std::optional<ReadBodies> read() {
        for (const std::uint32_t node : asset_.hierarchy().shown())
            if (!readNode(node)) return std::nullopt;
        ReadBodies result;
        result.bodies = sorted(std::move(bodies_));
        result.meshes = meshes_.finish(result.bodies);
        result.extent = extent_;
        return result;
    }

private:
    bool readNode(std::uint32_t id) {
        const Node& node = asset_.document().nodes[id];
        if (!node.mesh) return readWithoutMesh(id);
        const auto places = instancesOf(id, asset_.hierarchy(), asset_.content());
        const auto pose = asset_.poseOf(id);
        if (!places || !pose) return false;
        const Mesh& mesh = asset_.document().meshes[*node.mesh];
        for (std::uint32_t p = 0; p < mesh.primitives.size(); ++p) {
            const Primitive& primitive = mesh.primitives[p];
            if (!isShown(primitive)) continue;
            const auto material = materialOf(primitive);
            if (!material) return false;
            if (!asset_.takeRoom(places->size() * sizeof(Ordered<Body>), *node.json)) return false;
            const bool canBeExact = mesh.primitives.size() == 1 && !node.instances;
            const Exact<Body> exact = canBeExact ? exactOf(id, primitive, *pose) : Exact<Body>();
            for (const Transform& world : *places)
                if (!add({*node.mesh, p, &primitive, &*pose, world, node.json}, *material, exact))
                    return false;
        }
        return true;
    }

    /// A body that has no triangles may be in the extras alone.
    bool readWithoutMesh(std::uint32_t id) {
        const Json* extras = asset_.document().nodes[id].json->find("extras");
        const Exact<Body> exact = exactBody(extras, asset_.hierarchy().world(id), {});
        if (exact.state == Stored::valid) bodies_.push_back({exact.order, exact.value});
        return true;
    }

    /// False after telling why not.
    bool isShown(const Primitive& primitive) {
        const char* why = !primitive.hasTriangles() ? "points and lines have no area"
                          : !primitive.position     ? "a primitive without POSITION has no shape"
                                                    : nullptr;
        if (!why) return true;
        const std::string where = jsonPointer(asset_.root(), *primitive.json);
        if (!std::exchange(isTold_[&primitive], true))
            ledger_.add({where, "primitive", Action::dropped, why, {}});
        return false;
    }

    std::optional<std::size_t> materialOf(const Primitive& primitive) {
        const auto [entry, isNew] = tints_.try_emplace(&primitive);
        Tint& tint = entry->second;
        if (primitive.colour && isNew) {
            const auto colours = readNumbers(asset_.content(), *primitive.colour);
            if (!colours) return std::nullopt;
            const int components = asset_.document().accessors[*primitive.colour].components;
            tint = averageOf(*colours, static_cast<std::size_t>(components));
            primitive.json->find("attributes")->find("COLOR_0")->mark(Fate::approximated);
        }
        return materials_.indexOf(primitive.material, tint);
    }

    Exact<Body> exactOf(std::uint32_t id, const Primitive& primitive, const Pose& pose) {
        const Node& node = asset_.document().nodes[id];
        const Json* extras = node.json->find("extras");
        if (!extras || !extras->find("yarte")) return {};
        const auto mesh = readPrimitive(asset_.content(), primitive, pose);
        if (!mesh) return {};
        Exact<Body> exact = exactBody(extras, asset_.hierarchy().world(id), printOf(*mesh));
        if (!exact.why.empty())
            ledger_.add(
                {fmt::format("/nodes/{}", id), "exact shape in extras", Action::dropped, exact.why, {}});
        return exact;
    }

    bool add(const Placing& placing, std::size_t material, const Exact<Body>& exact) {
        Body body = exact.state == Stored::valid ? exact.value : Body{};
        body.material = {static_cast<std::uint32_t>(material)};
        auto* mesh = std::get_if<yarte::Mesh>(&body.shape);
        const bool isExact =
            exact.state == Stored::valid && (!mesh || meshes_.takeKnown(placing, mesh->mesh));
        if (!isExact) {
            const auto placed = meshes_.place(placing);
            if (!placed) return !asset_.errors().any();
            body.shape = *placed;
            body.referential.reset();
            for (const Problem& problem : check(body.shape))
                asset_.errors().report(problem.code, problem.message, *placing.nodeJson);
        }
        extent_.addPlaced(meshes_.extentOf(placing), placing.isPosed() ? Transform() : placing.world);
        bodies_.push_back({exact.order, std::move(body)});
        return true;
    }

    Asset& asset_;
    Materials& materials_;
    Ledger& ledger_;
    MeshTable meshes_;
    std::vector<Ordered<Body>> bodies_;
    Extent extent_;
    std::map<const Primitive*, Tint> tints_; ///< of their vertices
    std::map<const Primitive*, bool> isTold_;
};

} // namespace

std::optional<ReadBodies> readBodies(Asset& asset, Materials& materials, const std::vector<ExactMesh>& known,
                                     Ledger& ledger) {
    return BodyReader(asset, materials, known, ledger).read();
}

} // namespace yarte::convert::gltf
