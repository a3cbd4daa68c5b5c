// SceneBuilder: makes a Scene of statements and checks it on the way.
#pragma once

#include "yarte/lang/mesh_files.h"
#include "yarte/lang/statement.h"
#include "yarte/scene/check.h"

#include <array>

namespace yarte {

/// A statement with errors still adds what it names (a light, a body), so that one mistake is one error.
class SceneBuilder {
public:
    SceneBuilder(MeshFiles meshes, Diagnostics& diagnostics)
        : meshes_(std::move(meshes)), diagnostics_(diagnostics) {}

    void add(const Statement&);

    /// What only the whole scene can tell; `text` is the scene's. Nothing if there was an error.
    std::optional<Scene> finish(const Source& text) &&;

private:
    struct Given {
        Span span;
        bool good = false;
    };

    /// Of a setting: an error otherwise.
    bool isFirst(const Statement&);
    void setResolution(const Statement&);
    void setRecursion(const Statement&);
    void addLight(const Statement&);
    void addMaterial(const Statement&);
    void addTint(const Statement&);
    void addBody(const Statement&);
    void addBackColours(const Statement&);
    void addReferential(const Statement&);

    Shape shapeOf(const Statement&);
    /// The body that an attachment belongs to, if it takes one and has none yet.
    Body* bodyFor(const Statement&, bool (*takes)(const Shape&), std::optional<Span>& place);
    /// Nothing after reporting why the argument is none.
    std::optional<int> wholeNumber(const Argument&);
    /// Each problem at its argument.
    void report(const Problems&, const Statement&);
    void checkCamera();

    std::optional<Given>& given(Keyword keyword) { return given_[static_cast<std::size_t>(keyword)]; }

    MeshFiles meshes_;
    Diagnostics& diagnostics_;
    Scene scene_;
    std::array<std::optional<Given>, keywordCount> given_; ///< settings
    std::optional<Span> back_, referential_;               ///< attachments of the last body
    std::optional<Span> tint_;                             ///< of the last material
    bool isMaterialUsed_ = true;                           ///< the last material by a body, or there is none
    // An unknown word may have been any directive: what depends on it is not reported.
    bool unknownMaterial_ = false; ///< also after reporting that there is none
    bool unknownBody_ = false;     ///< since the last body
    bool unknownTint_ = false;     ///< since the last material or body
};

} // namespace yarte
