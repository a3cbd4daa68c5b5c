// mesh, mesh2.

#include "convert/povray/sdl/parser.h"

#include "yarte/base/huge_pages.h"

#include <fmt/format.h>

#include <map>

namespace yarte::convert::povray::sdl {
namespace {

std::size_t listSize(Interpreter& in) {
    in.expect('{');
    const Span where = in.peek().span;
    const int count = in.integer();
    if (count < 0) in.fail("sdl.mesh", "a list of negative length", where);
    in.comma();
    return static_cast<std::size_t>(count);
}

/// A list is as long as its text, whatever it says of itself: memory is not taken on its word alone.
std::size_t toReserve(std::size_t count) { return std::min<std::size_t>(count, 10'000'000); }

std::vector<Vec3> vectors(Interpreter& in) {
    std::vector<Vec3> list;
    const std::size_t count = listSize(in);
    reserveWhole(list, toReserve(count));
    for (std::size_t i = 0; i < count; ++i) list.push_back(in.listedPoint());
    in.expect('}');
    return list;
}

/// Three, and the comma that may follow them.
MeshShape::Indices indices(Interpreter& in, std::size_t count, const char* of) {
    const Span where = in.peekSpan();
    const Vec3 v = in.listedPoint();
    const auto index = [&](double d) {
        if (!(d >= 0 && d < static_cast<double>(count)))
            in.fail("sdl.mesh", fmt::format("index {} of {} {}", d, count, of), where);
        return static_cast<std::uint32_t>(d);
    };
    return {index(v.x), index(v.y), index(v.z)};
}

} // namespace

MeshShape Parser::mesh2(Interpreter& in) {
    MeshShape mesh;
    for (;;) {
        if (in.accept("vertex_vectors")) {
            mesh.vertices = vectors(in);
        } else if (in.accept("normal_vectors")) {
            mesh.normals = vectors(in);
        } else if (in.accept("uv_vectors") || in.accept("uv_indices")) {
            in.skipBraces();
        } else if (in.accept("texture_list")) {
            const std::size_t count = listSize(in);
            for (std::size_t i = 0; i < count; ++i) {
                if (auto named = in.acceptNamed<Shared<Layers>>()) {
                    mesh.textures.push_back(**named);
                } else {
                    if (!in.accept("texture")) in.failExpected("a texture");
                    mesh.textures.push_back(texture(in));
                }
                takeObjects(in, mesh.textures.back().size() - 1, in.peekSpan());
                in.comma();
            }
            in.expect('}');
        } else if (in.accept("face_indices")) {
            const std::size_t count = listSize(in);
            reserveWhole(mesh.faces, toReserve(count));
            for (std::size_t i = 0; i < count; ++i) {
                mesh.faces.push_back(indices(in, mesh.vertices.size(), "vertices"));
                // A texture for the face, or one for each corner: the first stands for all.
                bool hasTexture = false;
                for (int t = 0; t < 3 && !in.isAtListedPoint() && in.peek().kind == TokenKind::number; ++t) {
                    const Span where = in.peek().span;
                    const int texture = in.integer();
                    in.comma();
                    if (texture < 0 || static_cast<std::size_t>(texture) >= mesh.textures.size())
                        in.fail("sdl.mesh", fmt::format("texture {} of {}", texture, mesh.textures.size()),
                                where);
                    if (hasTexture) continue;
                    hasTexture = true;
                    mesh.faceTextures.resize(mesh.faces.size(), MeshShape::none);
                    mesh.faceTextures.back() = static_cast<std::uint32_t>(texture);
                }
            }
            if (!mesh.faceTextures.empty()) mesh.faceTextures.resize(mesh.faces.size(), MeshShape::none);
            in.expect('}');
        } else if (in.accept("normal_indices")) {
            const std::size_t count = listSize(in);
            reserveWhole(mesh.faceNormals, toReserve(count));
            for (std::size_t i = 0; i < count; ++i)
                mesh.faceNormals.push_back(indices(in, mesh.normals.size(), "normals"));
            in.expect('}');
        } else if (in.accept("inside_vector")) {
            in.vector3();
        } else {
            break;
        }
    }
    // As many normals as vertices and no list of their own: each vertex has its own.
    if (mesh.faceNormals.empty() && !mesh.normals.empty() && mesh.normals.size() == mesh.vertices.size())
        mesh.faceNormals = mesh.faces;
    if (mesh.faceNormals.size() != mesh.faces.size()) {
        if (!mesh.faceNormals.empty())
            in.fail("sdl.mesh",
                    fmt::format("{} normal_indices for {} faces", mesh.faceNormals.size(), mesh.faces.size()),
                    in.peek().span);
        mesh.normals.clear();
    }
    return mesh;
}

MeshShape Parser::mesh(Interpreter& in) {
    MeshShape mesh;
    std::map<std::array<double, 3>, std::uint32_t> known; // corners that are shared
    std::map<const Layers*, std::uint32_t> textures;
    std::vector<Shared<Layers>> kept;
    const auto vertex = [&](Vec3 v) {
        const auto [at, isNew] =
            known.try_emplace({v.x, v.y, v.z}, static_cast<std::uint32_t>(mesh.vertices.size()));
        if (isNew) mesh.vertices.push_back(v);
        return at->second;
    };
    bool anySmooth = false;
    std::vector<std::optional<std::array<Vec3, 3>>> normals; // as faces
    while (in.peek().isWord("triangle") || in.peek().isWord("smooth_triangle")) {
        const bool isSmooth = in.next().text == "smooth_triangle";
        in.expect('{');
        MeshShape::Indices face{};
        std::array<Vec3, 3> n{};
        for (std::size_t i = 0; i < 3; ++i) {
            face[i] = vertex(in.point());
            in.comma();
            if (isSmooth) n[i] = in.point(), in.comma();
        }
        mesh.faces.push_back(face);
        normals.push_back(isSmooth ? std::optional(n) : std::nullopt);
        anySmooth |= isSmooth;
        while (!in.accept('}')) {
            if (in.accept("uv_vectors")) {
                while (in.startsExpression()) in.expression(), in.comma();
                continue;
            }
            const bool isList = in.accept("texture_list");
            if (!isList && !in.accept("texture")) in.failExpected("a texture or '}'");
            in.expect('{');
            auto named = in.acceptNamed<Shared<Layers>>();
            if (!named) in.failExpected("the name of a texture");
            while (in.accept(',')) in.acceptNamed<Shared<Layers>>();
            in.expect('}');
            const auto [at, isNew] =
                textures.try_emplace(named->get(), static_cast<std::uint32_t>(mesh.textures.size()));
            if (isNew) {
                mesh.textures.push_back(**named);
                takeObjects(in, (*named)->size() - 1, in.peekSpan());
                kept.push_back(*named); // its address is the key
            }
            mesh.faceTextures.resize(mesh.faces.size(), MeshShape::none);
            mesh.faceTextures.back() = at->second;
        }
    }
    if (!mesh.faceTextures.empty()) mesh.faceTextures.resize(mesh.faces.size(), MeshShape::none);
    for (std::size_t f = 0; anySmooth && f < mesh.faces.size(); ++f) {
        const auto& face = mesh.faces[f];
        const Vec3 flat = cross(mesh.vertices[face[2]] - mesh.vertices[face[0]], // by the left-hand rule
                                mesh.vertices[face[1]] - mesh.vertices[face[0]]);
        MeshShape::Indices corners{};
        for (std::size_t i = 0; i < 3; ++i) {
            corners[i] = static_cast<std::uint32_t>(mesh.normals.size());
            mesh.normals.push_back(normals[f] ? (*normals[f])[i] : flat);
        }
        mesh.faceNormals.push_back(corners);
    }
    return mesh;
}

} // namespace yarte::convert::povray::sdl
