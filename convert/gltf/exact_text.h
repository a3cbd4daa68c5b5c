// Parts of a scene as lines of the scene language, and back to the last bit.
#pragma once

#include "yarte/scene/scene.h"

#include <optional>
#include <string>

namespace yarte::convert::gltf {

std::string settingsText(const Scene&); ///< resolution, background, recursion, gamma
std::string text(const Camera&);
std::string text(const Light&);
std::string text(const Material&);
/// With its back colours and axes, without its material. A mesh is called by `meshName`, whatever its path.
std::string text(const Body&);

inline constexpr const char* meshName = "mesh.pmf";

/// A scene with what `lines` say and no more (made up where the language asks for more); nothing, and the
/// reason in `why`, if they are not good. The mesh `meshName` is a stand-in.
std::optional<Scene> sceneOf(const std::string& lines, std::string& why);

std::string meshText(const MeshData&); ///< as .pmf
std::optional<MeshData> meshOf(const std::string& pmf, std::string& why);

} // namespace yarte::convert::gltf
