#include "convert/povray/sdl/build_body.h"

#include "convert/povray/sdl/build_exact.h"
#include "convert/povray/sdl/build_polygon.h"
#include "convert/povray/sdl/in_units.h"
#include "convert/povray/sdl/round_mesh.h"
#include "convert/povray/sdl/stretch.h"
#include "yarte/scene/check.h"
#include "yarte/scene/mesh_placement.h"
#include "yarte/scene/planarity.h"
#include "yarte/scene/referential.h"

#include <fmt/format.h>

#include <map>
#include <utility>

namespace yarte::convert::povray::sdl {
namespace {

struct KindOf {
    const char* operator()(const SphereShape&) const { return "sphere"; }
    const char* operator()(const BoxShape&) const { return "box"; }
    const char* operator()(const ConeShape& c) const { return c.radiusA == c.radiusB ? "cylinder" : "cone"; }
    const char* operator()(const DiscShape&) const { return "disc"; }
    const char* operator()(const TorusShape&) const { return "torus"; }
    const char* operator()(const PlaneShape&) const { return "plane"; }
    const char* operator()(const PolygonShape&) const { return "polygon"; }
    const char* operator()(const TriangleShape& t) const {
        return t.normals ? "smooth_triangle" : "triangle";
    }
    const char* operator()(const std::shared_ptr<const MeshShape>&) const { return "mesh"; }
    const char* operator()(const UnionShape& u) const { return u.isMerge ? "merge" : "union"; }
    const char* operator()(const LightShape&) const { return "light_source"; }
    const char* operator()(const UnsupportedShape& u) const { return u.kind.c_str(); }
    const char* operator()(const ExactShape&) const { return "object"; }
};

const char* kindOf(const Object& object) { return std::visit(KindOf(), object.shape); }

/// Of all meshes: those of round shapes, and copies of the file's where a transformation needs one. A few
/// words can ask for any number.
constexpr std::size_t maxFaces = 50'000'000;

class ObjectBuilder {
public:
    ObjectBuilder(const Model& model, bool isMirrored, Tolerance tolerance, Report& report,
                  Diagnostics& diagnostics)
        : model_(model), isMirrored_(isMirrored), tolerance_(tolerance), report_(report),
          diagnostics_(diagnostics), materials_(model, report), meshes_(model) {}

    BuiltObjects build() {
        const Affine mirror{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {}};
        for (const ObjectPtr& object : model_.objects) add(*object, isMirrored_ ? mirror : Affine{}, {});
        endRun();
        for (const auto& [medium, count] : parts_)
            if (count > 1)
                tell(*medium,
                     {"interior", Action::approximated,
                      fmt::format(
                          "each of its {} parts is a medium of its own: where they overlap they differ",
                          count)});
        return {std::move(bodies_), std::move(lights_), std::move(materials_).take(),
                std::move(meshes_).take()};
    }

private:
    /// An object in its place.
    struct Placed {
        const Object& object;
        const Affine& map;
        const Style& style;
    };

    void tell(const Object& object, const Loss& loss) { report_.tell(kindOf(object), object.span, loss); }
    void drop(const Object& object, std::string why) {
        tell(object, {"everything", Action::dropped, std::move(why)});
    }

    void add(const Object& object, const Affine& outer, const Style& outerStyle) {
        if (hasTooManyFaces_) return;
        for (const std::string& word : object.ignored)
            tell(object, {word, Action::dropped, "has no counterpart"});
        if (object.isHidden) return drop(object, "it is not in the picture, though mirrors may show it");
        const Affine map = then(object.transform, outer);
        const Style style = styleOf(object, outerStyle);
        if (!std::holds_alternative<TriangleShape>(object.shape)) endRun();
        std::visit([&](const auto& shape) { addShape(shape, Placed{object, map, style}); }, object.shape);
    }

    void addShape(const SphereShape& s, const Placed& p) { addRound(s, p); }
    void addShape(const BoxShape& b, const Placed& p) {
        Built built = sdl::build(b, p.map);
        if (isOnlyTurned(p) && std::holds_alternative<Shape>(built.what)) {
            // Versors whose length is off by rounding change no side.
            std::get<Box>(std::get<Shape>(built.what)).sides = b.b - b.a;
            built.referential = p.object.exactAxes;
        }
        addBuilt(std::move(built), p);
    }
    void addShape(const ConeShape& c, const Placed& p) { addRound(c, p); }
    void addShape(const DiscShape& d, const Placed& p) { addRound(d, p); }
    void addShape(const TorusShape& t, const Placed& p) { addRound(t, p); }
    void addShape(const PlaneShape& s, const Placed& p) { addBuilt(sdl::build(s, p.map), p); }
    void addShape(const PolygonShape& s, const Placed& p) { addBuilt(sdl::build(s, p.map), p); }

    void addShape(const UnionShape& u, const Placed& p) {
        const std::size_t first = bodies_.size();
        for (const ObjectPtr& part : u.parts) add(*part, p.map, p.style);
        endRun();
        bool isTransmissive = false;
        for (std::size_t i = first; i < bodies_.size(); ++i)
            isTransmissive |= transmits(materials_[bodies_[i].material]);
        if (u.isMerge && isTransmissive)
            tell(p.object, {"merge", Action::approximated, "a union: surfaces inside other parts are kept"});
    }

    void addShape(const LightShape& light, const Placed& p) {
        std::optional<BuiltLight> built = buildLight(light, p.map, p.object.span, report_);
        if (!built) return;
        built->light.position = built->light.position / model_.unit;
        if (isGood(check(built->light), p.object)) lights_.push_back(*built);
    }

    void addShape(const UnsupportedShape&, const Placed& p) { drop(p.object, "there is no such shape"); }

    void addShape(const ExactShape& s, const Placed& p) {
        const std::optional<ExactBody> exact =
            place(s.shape, p.map, isOnlyTurned(p) ? p.object.exactAxes : std::nullopt, model_.unit);
        const auto* mesh = std::get_if<Mesh>(&s.shape);
        if (!exact && mesh) return addMesh(bent(*mesh, p.map), p, lookOf(p), &p.style);
        if (!exact)
            return drop(p.object, "its transformation was changed to one that its shape cannot follow");
        addBody(exact->shape, exact->referential, p, lookOf(p));
    }

    /// A copy of an exact mesh for a map that mirrors or bends, in the file's lengths.
    MeshData bent(const Mesh& mesh, const Affine& a) const {
        MeshData data = meshes_[mesh.mesh];
        const Frame axes = resolveReferential(mesh.axes);
        data.vertices = placedVertices(data, mesh);
        for (Vec3& v : data.vertices) v = v * model_.unit;
        for (Vec3& n : data.normals) n = axes.toWorld(n);
        map(data, a);
        return data;
    }

    void addShape(const std::shared_ptr<const MeshShape>& mesh, const Placed& p) {
        std::vector<bool> isUsed(mesh->textures.size() + 1, mesh->faceTextures.empty());
        if (mesh->faceTextures.empty()) std::fill(isUsed.begin(), isUsed.end() - 1, false);
        for (const std::uint32_t t : mesh->faceTextures)
            isUsed[std::min<std::size_t>(t, mesh->textures.size())] = true;
        std::size_t flat = 0;
        const Style whole = withMedium(p);
        for (std::size_t t = 0; t < isUsed.size(); ++t) {
            if (!isUsed[t]) continue;
            const bool isOwn = t < mesh->textures.size();
            Style style = whole;
            if (isOwn) style.layers = &mesh->textures[t], style.exact = nullptr;
            const auto index = isOwn ? static_cast<std::uint32_t>(t) : MeshShape::none;
            const std::size_t known = meshes_.size();
            const auto placed = meshes_.place(mesh, index, p.map, flat);
            if (!placed) continue;
            const bool isNew = meshes_.size() > known;
            if (isNew && !takeFaces(meshes_[placed->mesh].faceCount(), p.object)) return;
            if (!isNew || isGood(check(meshes_[placed->mesh]), p.object))
                addBody(inUnits(*placed, model_.unit), {}, p, lookOf({p.object, p.map, style}), &style);
        }
        if (!mesh->faceNormals.empty() && similarityOf(p.map).error > rounding)
            tell(p.object,
                 {"normals", Action::approximated,
                  "interpolated after the transformation; POV-Ray transforms what it has interpolated"});
        if (flat > 0)
            tell(p.object,
                 {"faces", Action::dropped, fmt::format("{} have no area: POV-Ray drops them too", flat)});
    }

    /// Found by trying: POV-Ray calls a smooth_triangle degenerate, and drops it, if its normals are not all
    /// on the same side of it. In a mesh it does not.
    static bool hasStrayNormals(const TriangleShape& t) {
        if (!t.normals) return false;
        const Vec3 flat = cross(t.corners[1] - t.corners[0], t.corners[2] - t.corners[0]);
        bool above = true, below = true; // all of them are
        for (const Vec3 n : *t.normals) above &= dot(n, flat) > 0, below &= dot(n, flat) < 0;
        return !above && !below;
    }

    /// Triangles follow one another by the thousand: those that look alike are one mesh.
    void addShape(const TriangleShape& triangle, const Placed& p) {
        if (hasStrayNormals(triangle))
            return tell(p.object, {"everything", Action::dropped,
                                   "its normals are not on one side of it: POV-Ray drops it too"});
        const Look look = lookOf(p);
        const bool isOneMedium = !look.isTransmissive || (p.style.medium && p.style.medium != &p.object);
        const Object* medium = look.isTransmissive ? p.style.medium : nullptr;
        if (!run_.isEmpty() && (!isOneMedium || look != runLook_ || medium != runMedium_)) endRun();
        if (run_.isEmpty()) runLook_ = look, runMedium_ = medium, runFirst_ = &p.object;
        if (!run_.add(triangle, p.map))
            return tell(p.object, {"everything", Action::dropped, "it has no area: POV-Ray drops it too"});
        if (look.back && p.object.transform != Affine{})
            tell(p.object,
                 {"interior_texture", Action::approximated,
                  "on the back before the transformation; POV-Ray may change the sides of such triangles"});
        if (!isOneMedium) endRun();
    }

    void endRun() {
        if (run_.isEmpty()) return;
        const bool isPolygon = run_.isPolygon();
        MeshData data = run_.take();
        Style style;
        style.medium = runMedium_;
        const Placed first{*runFirst_, {}, style};
        if (isPolygon) {
            Polygon polygon;
            for (const std::uint32_t corner : data.corners) polygon.vertices.push_back(data.vertices[corner]);
            if (!planarity(polygon.vertices)) return drop(*runFirst_, "it has hardly any area");
            return addBody(inUnits(std::move(polygon), model_.unit), {}, first, runLook_, &style);
        }
        addMesh(std::move(data), first, runLook_, &style);
    }

    /// True if the transformation is just what a Yarte_Turn and a move made of it.
    bool isOnlyTurned(const Placed& p) const { return p.object.exactAxes && p.map == p.object.transform; }

    /// Objects in a union that is used more than once are met again. What became triangles is kept once for
    /// those that are only moved, turned and scaled against the first.
    template <class S>
    void addRound(const S& shape, const Placed& p) {
        if (const auto kept = roundMeshes_.find(&p.object); kept != roundMeshes_.end())
            if (const auto mesh = placedAgain(kept->second, p.map)) {
                tell(p.object, {"shape", Action::approximated, kept->second.why + ", in the scene's units",
                                kept->second.deviation * mesh->scale / model_.unit});
                return addBody(inUnits(*mesh, model_.unit), {}, p, lookOf(p), &p.style);
            }
        Built built = sdl::build(shape, p.map, tolerance_);
        if constexpr (std::is_same_v<S, ConeShape> || std::is_same_v<S, DiscShape>)
            built = turned(std::move(built), shape, p);
        const bool isMesh = std::holds_alternative<MeshData>(built.what);
        RoundMesh round{p.map, {static_cast<std::uint32_t>(meshes_.size())}, built.deviation, built.why};
        addBuilt(std::move(built), p);
        if (isMesh && meshes_.size() > round.id.index) roundMeshes_.try_emplace(&p.object, std::move(round));
    }

    struct RoundMesh {
        Affine map; ///< under which it was made
        MeshId id;
        double deviation = 0;
        std::string why;
    };

    std::optional<Mesh> placedAgain(const RoundMesh& mesh, const Affine& map) const {
        const auto back = inverse(mesh.map);
        if (!back) return std::nullopt;
        const Affine change = then(*back, map);
        const Similarity similarity = similarityOf(change);
        const double s = similarity.scale;
        const bool keepsChordError = !tolerance_.chordError || std::abs(s - 1) <= rounding;
        if (similarity.error > rounding || determinant(change) < 0 || !keepsChordError) return std::nullopt;
        return Mesh{mesh.id, s, {change.x / s, change.y / s, change.z / s}, change.t};
    }

    /// A body of revolution whose axes are as written: built unturned, for versors off by rounding.
    template <class S>
    Built turned(Built built, const S& shape, const Placed& p) {
        if (!isOnlyTurned(p)) return built;
        Built unturned = sdl::build(shape, translation(p.map.t), tolerance_);
        if (unturned.referential || !std::holds_alternative<Shape>(unturned.what)) return built;
        unturned.referential = p.object.exactAxes;
        return unturned;
    }

    Look lookOf(const Placed& p) { return materials_.lookOf(p.style, kindOf(p.object), p.object.span); }

    /// The parts of a mesh are one medium even if nothing says so.
    static Style withMedium(const Placed& p) {
        Style style = p.style;
        if (!style.medium) style.medium = &p.object;
        return style;
    }

    void addBuilt(Built built, const Placed& p) {
        if (std::holds_alternative<std::monostate>(built.what)) return drop(p.object, built.why);
        if (built.deviation > 0)
            tell(p.object, {"shape", Action::approximated, built.why + ", in the scene's units",
                            built.deviation / model_.unit});
        if (auto* shape = std::get_if<Shape>(&built.what))
            return addBody(inUnits(std::move(*shape), model_.unit), std::move(built.referential), p,
                           lookOf(p));
        addMesh(std::move(std::get<MeshData>(built.what)), p, lookOf(p), &p.style);
    }

    /// In the file's lengths.
    void addMesh(MeshData data, const Placed& p, const Look& look, const Style* style) {
        if (!takeFaces(data.faceCount(), p.object) || !isGood(check(data), p.object)) return;
        addBody(inUnits(meshes_.add(std::move(data)), model_.unit), {}, p, look, style);
    }

    /// False after an error.
    bool takeFaces(std::size_t count, const Object& object) {
        hasTooManyFaces_ = count > facesLeft_;
        if (hasTooManyFaces_)
            diagnostics_.error("sdl.too-many-faces", fmt::format("meshes of more than {} faces", maxFaces),
                               object.span);
        else
            facesLeft_ -= count;
        return !hasTooManyFaces_;
    }

    void addBody(Shape shape, std::optional<Referential> referential, const Placed& p, const Look& look,
                 const Style* style = nullptr) {
        Problems problems = check(shape);
        if (referential)
            for (Problem& problem : check(*referential)) problems.push_back(std::move(problem));
        if (!isGood(problems, p.object)) return;
        Body body{std::move(shape), look.material, std::move(referential), {}, p.object.span};
        if (takesBackColours(body.shape))
            body.back = look.back;
        else if (look.back && look.isTransmissive)
            tell(p.object, {"interior_texture", Action::dropped, "its inside looks as its outside"});
        if (look.isTransmissive) countPart(style ? style->medium : p.style.medium);
        bodies_.push_back(std::move(body));
    }

    void countPart(const Object* medium) {
        if (!medium) return;
        const auto [entry, isNew] = partIndex_.try_emplace(medium, parts_.size());
        if (isNew) parts_.emplace_back(medium, 0);
        ++parts_[entry->second].second;
    }

    /// Numbers that are not finite are errors. What else YARTE refuses no ray would meet.
    bool isGood(const Problems& problems, const Object& object) {
        for (const Problem& problem : problems)
            if (problem.code == "scene.not-finite") {
                diagnostics_.error(problem.code, problem.message, object.span);
                return false;
            }
        if (!problems.empty()) drop(object, problems.front().message);
        return problems.empty();
    }

    const Model& model_;
    bool isMirrored_;
    Tolerance tolerance_;
    Report& report_;
    Diagnostics& diagnostics_;
    Materials materials_;
    Meshes meshes_;
    std::map<const Object*, RoundMesh> roundMeshes_;
    std::vector<Body> bodies_;
    std::vector<BuiltLight> lights_;

    std::size_t facesLeft_ = maxFaces;
    bool hasTooManyFaces_ = false;

    TriangleRun run_;
    Look runLook_;
    const Object* runMedium_ = nullptr;
    const Object* runFirst_ = nullptr;

    /// How many bodies have an interior in common, in the order of the file.
    std::vector<std::pair<const Object*, std::size_t>> parts_;
    std::map<const Object*, std::size_t> partIndex_;
};

} // namespace

BuiltObjects buildObjects(const Model& model, bool isMirrored, Tolerance tolerance, Report& report,
                          Diagnostics& diagnostics) {
    return ObjectBuilder(model, isMirrored, tolerance, report, diagnostics).build();
}

} // namespace yarte::convert::povray::sdl
