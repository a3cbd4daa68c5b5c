// Parser: the statements of SDL, into a Model. What the language is besides, the Interpreter knows.
#pragma once

#include "convert/povray/sdl/interpreter.h"
#include "convert/povray/sdl/model.h"
#include "yarte/base/frame.h"

#include <map>
#include <optional>
#include <span>
#include <string>

namespace yarte::convert::povray::sdl {

class Parser : public Statements {
public:
    /// Up to the end of the text. Throws SyntaxError.
    Model parse(Interpreter&);

    // For the interpreter
    std::optional<Value> value(Interpreter&) override;
    void defaults(Interpreter&) override;
    void versionChanged(Interpreter& in) override { model_.languageVersion = in.languageVersion(); }
    bool isKnown(const Interpreter&, const Macro&) override;
    std::optional<Value> callKnown(Interpreter&, const Macro&, const std::vector<Value>&, Span call) override;
    std::optional<std::array<Vec3, 2>> extent(const Object&) override;

private:
    void statement(Interpreter&);
    /// One that has no part in YARTE's pictures: read past, and told.
    void dropStatement(Interpreter&, const Token& word);

    // parse_object.cpp
    ObjectPtr object(Interpreter&);
    ObjectShape shape(Interpreter&, const Token& keyword);
    void modifiers(Interpreter&, Object&);
    bool modifier(Interpreter&, Object&);
    void parts(Interpreter&, UnionShape&);
    PolygonShape polygon(Interpreter&);
    void addObject(Interpreter&, ObjectPtr);
    /// Sets its count and depth, which must be within the limits.
    void measure(Interpreter&, Object&);
    void takeObjects(Interpreter&, std::size_t count, Span where);

    // parse_mesh.cpp
    MeshShape mesh(Interpreter&);
    MeshShape mesh2(Interpreter&);

    // parse_texture.cpp: from the opening brace on
    Layers texture(Interpreter&);
    void pigment(Interpreter&, Pigment&);
    ColourMap colourMap(Interpreter&);
    TextureMap textureMap(Interpreter&);
    void finish(Interpreter&, Finish&);
    void interior(Interpreter&, Interior&);
    void material(Interpreter&, Appearance&);
    Texture defaultTexture() const { return model_.defaultTexture; }

    // parse_view.cpp
    LightShape light(Interpreter&);
    CameraModel camera(Interpreter&, Span);
    void globalSettings(Interpreter&);

    // known_macros.cpp
    bool libraryIsIntact(const Interpreter&) const;
    ObjectPtr withWrittenAxes(const Interpreter&, const Object&) const;
    std::optional<Referential> writtenAxes(const Interpreter&, const Frame& meant) const;

    Model model_;
    std::size_t objects_ = 0; ///< made so far, in unions and declarations, too
    std::size_t shown_ = 0;   ///< objects of the scene, with their parts
    std::size_t bodies_ = 0;  ///< objects of the scene that are no lights
    bool hasUnit_ = false;    ///< a known macro has been met, with model_.unit
    std::map<const Array*, MeshId>
        exactMeshes_; ///< by their array of vertices, which lives as long as its name
};

[[noreturn]] void failTooManyObjects(const Interpreter&, Span where);

/// Layers put on `layers`: POV-Ray adds them on top.
void putOn(Interpreter&, std::optional<Layers>& layers, Layers more);

/// A transformation (translate, rotate, scale, matrix, transform), if one comes next: read.
std::optional<Affine> acceptTransformation(Interpreter&);
/// A flag that may have a value: "hollow", "hollow on". Its word has been read.
bool optionalFlag(Interpreter&);

} // namespace yarte::convert::povray::sdl
