// The macros of YARTE's own .pov files. Their arguments are the scene's numbers to the last bit, which what
// they expand to is not; so where all of them read as we write them, the arguments are taken. In a file where
// one was edited, all are run like any others: the file means what it shows.

#include "convert/povray/library.h"
#include "convert/povray/sdl/parser.h"
#include "yarte/scene/referential.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace yarte::convert::povray::sdl {
namespace {

/// An argument, or an element of an array, is not what it should be: the macro is run after all.
struct NotKnown {};

const Vector& vectorOf(const Value& value, int size) {
    const auto* v = std::get_if<Vector>(&value);
    if (!v || v->size != size) throw NotKnown{};
    return *v;
}

double numberOf(const Value& value) { return vectorOf(value, 1).at[0]; }
Vec3 vec3Of(const Value& value) { return vectorOf(value, 3).vec3(); }
Colour colourOf(const Value& value) {
    const Vec3 v = vec3Of(value);
    return {v.x, v.y, v.z};
}

double globalNumber(const Interpreter& in, std::string_view name) {
    const Value* value = in.global(name);
    if (!value) throw NotKnown{};
    return numberOf(*value);
}

const Array& arrayOf(const Value& value) {
    const auto* array = std::get_if<ArrayPtr>(&value);
    if (!array || (*array)->sizes.size() != 1) throw NotKnown{};
    return **array;
}

std::vector<Vec3> vectorsOf(const Value& value) {
    std::vector<Vec3> list;
    for (const Value& element : arrayOf(value).elements) list.push_back(vec3Of(element));
    return list;
}

std::uint32_t indexOf(const Value& value, std::size_t count) {
    const double v = numberOf(value);
    if (!(v >= 0 && v < static_cast<double>(count) && v == std::floor(v))) throw NotKnown{};
    return static_cast<std::uint32_t>(v);
}

/// Of "Mesh_N_File", where "Mesh_N_Vertices" is the array `vertices`.
std::string pathOf(const Interpreter& in, const Value& vertices) {
    for (int i = 1;; ++i) {
        const Value* file = in.global(fmt::format("Mesh_{}_File", i));
        const Value* array = in.global(fmt::format("Mesh_{}_Vertices", i));
        if (!file || !array) return {};
        if (*std::get_if<ArrayPtr>(array) == *std::get_if<ArrayPtr>(&vertices) &&
            std::holds_alternative<std::string>(*file))
            return std::get<std::string>(*file);
    }
}

MeshData meshOf(const Interpreter& in, const Value& vertices, const Value& faces) {
    MeshData mesh;
    mesh.path = pathOf(in, vertices);
    mesh.vertices = vectorsOf(vertices);
    const std::vector<Value>& list = arrayOf(faces).elements;
    for (std::size_t at = 0; at < list.size();) {
        const std::uint32_t corners = indexOf(list[at], list.size() - at);
        ++at;
        for (std::uint32_t i = 0; i < corners; ++i)
            mesh.corners.push_back(indexOf(list[at++], mesh.vertices.size()));
        mesh.faceStarts.push_back(static_cast<std::uint32_t>(mesh.corners.size()));
    }
    return mesh;
}

Value exactObject(ExactShape shape, Span call) {
    auto made = std::make_shared<Object>();
    made->shape = std::move(shape);
    made->span = call;
    return ObjectPtr(made);
}

bool sameRotation(const Referential& written, const Frame& meant) {
    const Frame axes = resolveReferential(written);
    return axes.x == meant.x && axes.y == meant.y && axes.z == meant.z;
}

} // namespace

bool Parser::isKnown(const Interpreter&, const Macro& macro) { return macro.name.starts_with("Yarte_"); }

bool Parser::libraryIsIntact(const Interpreter& in) const {
    for (const std::string_view name : libraryMacroNames()) {
        const SymbolPtr symbol = in.find(name);
        if (!symbol) continue;
        const Macro* macro = symbol->macro();
        if (macro && !isLibraryMacro(name, macro->text)) return false;
    }
    return true;
}

std::optional<Referential> Parser::writtenAxes(const Interpreter& in, const Frame& meant) const {
    const Value* value = in.global(fmt::format("Axes_{}", bodies_ + 1));
    const auto* array = value ? std::get_if<ArrayPtr>(value) : nullptr;
    if (!array || (*array)->elements.size() < 2) return std::nullopt;
    const std::vector<Vec3> axes = vectorsOf(*value);
    Referential written{axes[0], axes[1], {}};
    if (axes.size() > 2) written.z = axes[2];
    if (!sameRotation(written, meant)) return std::nullopt;
    return written;
}

ObjectPtr Parser::withWrittenAxes(const Interpreter& in, const Object& object) const {
    auto copy = std::make_shared<Object>(object);
    try {
        const Affine& t = object.transform;
        if (const auto written = writtenAxes(in, {t.x, t.y, t.z})) copy->exactAxes = written;
    } catch (const NotKnown&) { // the array is the user's own
    }
    return copy;
}

std::optional<Value> Parser::callKnown(Interpreter& in, const Macro& macro, const std::vector<Value>& a,
                                       Span call) {
    if (!isLibraryMacro(macro.name, macro.text) || !libraryIsIntact(in)) return std::nullopt;
    const std::string_view name = macro.name;
    try {
        const double unit = globalNumber(in, "World_Scale"), exposure = globalNumber(in, "Exposure");
        int exponent = 0;
        if (!(std::frexp(unit, &exponent) == 0.5)) return std::nullopt; // not a power of two
        if (hasUnit_ && unit != model_.unit) return std::nullopt;
        model_.unit = unit;
        hasUnit_ = true;
        const auto lit = [&](const Value& v) {
            const Colour c = colourOf(v);
            return exposure == 1 ? c : Colour{c.r * exposure, c.g * exposure, c.b * exposure};
        };
        if (name.ends_with("_Material") || name.ends_with("_Two_Sided")) {
            const bool isTwoSided = name.ends_with("_Two_Sided");
            const std::size_t n = isTwoSided ? 6 : 3;
            Material material{lit(a[0]),          colourOf(a[1]),     colourOf(a[2]),    numberOf(a[n]),
                              numberOf(a[n + 1]), numberOf(a[n + 2]), numberOf(a[n + 3])};
            if (name.starts_with("Yarte_Tinted_")) material.tint = colourOf(a[n + 4]);
            Appearance look;
            auto& known = model_.exactMaterials;
            // A two-sided one follows the material that it belongs to.
            const auto last =
                isTwoSided ? std::ranges::find(known.rbegin(), known.rend(), material) : known.rend();
            if (last == known.rend()) {
                look.exact = {{static_cast<std::uint32_t>(known.size())}, {}};
                known.push_back(material);
            } else {
                look.exact = {{static_cast<std::uint32_t>(known.rend() - last - 1)}, {}};
            }
            if (isTwoSided) look.exact->back = {lit(a[3]), colourOf(a[4]), colourOf(a[5])};
            return std::make_shared<const Appearance>(look);
        }
        if (name == "Yarte_Camera") {
            CameraModel camera;
            camera.exact = {vec3Of(a[0]), vec3Of(a[1]), vec3Of(a[2]), numberOf(a[3]), numberOf(a[4])};
            camera.span = call;
            const double width = globalNumber(in, "Image_Width"), height = globalNumber(in, "Image_Height");
            if (width >= 1 && height >= 1 && width < 1e9 && height < 1e9)
                model_.resolution = {static_cast<int>(width), static_cast<int>(height)};
            model_.gamma = globalNumber(in, "Display_Gamma");
            return std::make_shared<const CameraModel>(camera);
        }
        if (name == "Yarte_Turn")
            return std::make_shared<const Affine>(Affine{vec3Of(a[0]), vec3Of(a[1]), vec3Of(a[2])});
        if (name == "Yarte_Polygon") return exactObject({Polygon{vectorsOf(a[0])}}, call);
        if (name == "Yarte_Truncated_Cone")
            return exactObject({TruncatedCone{{}, numberOf(a[0]), numberOf(a[1]), numberOf(a[2])}}, call);
        if (name == "Yarte_Inside")
            return std::make_shared<const OpaqueValue>(OpaqueValue{"inside of a mesh"});
        if (name == "Yarte_Faces" || name == "Yarte_Smooth_Faces") {
            const bool isSmooth = name == "Yarte_Smooth_Faces";
            const std::size_t n = isSmooth ? 4 : 2;
            const Array* vertices = &arrayOf(a[0]);
            const auto [at, isNew] = exactMeshes_.try_emplace(
                vertices, MeshId{static_cast<std::uint32_t>(model_.exactMeshes.size())});
            if (isNew) {
                MeshData data = meshOf(in, a[0], a[1]);
                if (isSmooth) {
                    data.normals = vectorsOf(a[2]);
                    for (const Value& v : arrayOf(a[3]).elements)
                        data.cornerNormals.push_back(indexOf(v, data.normals.size()));
                    if (data.cornerNormals.size() != data.corners.size()) throw NotKnown{};
                }
                model_.exactMeshes.push_back(std::move(data));
            }
            const Frame meant{vec3Of(a[n + 1]), vec3Of(a[n + 2]), vec3Of(a[n + 3])};
            Mesh mesh{at->second, numberOf(a[n]), {meant.x, meant.y, meant.z}, vec3Of(a[n + 4])};
            if (const auto written = writtenAxes(in, meant)) mesh.axes = *written;
            return exactObject({mesh}, call);
        }
    } catch (const NotKnown&) {
    }
    return std::nullopt;
}

} // namespace yarte::convert::povray::sdl
