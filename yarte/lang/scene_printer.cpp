#include "yarte/lang/scene_printer.h"

#include "yarte/base/number.h"
#include "yarte/lang/directive.h"
#include "yarte/lang/lexer.h"

#include <algorithm>
#include <concepts>

namespace yarte {
namespace {

/// Quoted where the lexer would not read it back as one file name.
std::string fileName(const std::string& name) {
    double ignored = 0;
    const bool isWord = !name.empty() && name[0] != '"' && findDirective(name) == nullptr &&
                        std::none_of(name.begin(), name.end(), [](char c) { return isSpace(c) || c == ';'; });
    if (isWord) {
        const TokenKind kind = kindOfWord(name, ignored);
        if (kind == TokenKind::word || kind == TokenKind::badNumber) return name;
    }
    std::string quoted = "\"";
    for (const char c : name) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + '"';
}

class Printer {
public:
    explicit Printer(const Scene& scene) : scene_(scene) {}

    std::string print() && {
        printSettings();
        for (const Light& light : scene_.lights) printLight(light);
        for (const Body& body : scene_.bodies) printBody(body);
        while (materialsPrinted_ < scene_.materials.size()) printNextMaterial();
        return std::move(text_);
    }

private:
    template <class... Values>
    void line(Keyword keyword, const Values&... values) {
        text_ += directive(keyword).name;
        (put(values), ...);
        text_ += '\n';
    }

    void put(const std::string& word) { text_ += ' ' + word; }
    void put(std::floating_point auto number) { put(printNumber(number)); }
    void put(std::integral auto number) { put(std::to_string(number)); }
    void put(Vec3 v) { put(v.x), put(v.y), put(v.z); }
    void put(Colour c) { put(c.r), put(c.g), put(c.b); }
    void put(const BackColours& b) { put(b.ambient), put(b.diffuse), put(b.specular); }
    void put(const Referential& r) {
        put(r.x), put(r.y);
        if (r.z) put(*r.z);
    }
    void put(const std::vector<Vec3>& vertices) {
        put(vertices.size());
        for (const Vec3 v : vertices) put(v);
    }

    void printSettings() {
        const Camera& camera = scene_.camera;
        line(Keyword::imageResolution, scene_.resolution.width, scene_.resolution.height);
        line(Keyword::cameraPosition, camera.position);
        line(Keyword::cameraApertures, camera.horizontalApertureDegrees, camera.verticalApertureDegrees);
        line(Keyword::focusPoint, camera.focus);
        line(Keyword::upVector, camera.up);
        line(Keyword::backgroundColour, scene_.background);
        line(Keyword::maxRecurseLevel, scene_.maxRecursion);
        line(Keyword::gammaCorrectionFactor, scene_.gamma);
        if (!scene_.lights.empty()) text_ += '\n';
    }

    void printLight(const Light& light) {
        const std::string r = printNumber(light.brightness.r); // as text: 0 and -0 differ
        if (r == printNumber(light.brightness.g) && r == printNumber(light.brightness.b))
            line(Keyword::lightSource, light.position, r);
        else
            line(Keyword::lightSource, light.position, light.brightness);
    }

    void printMaterial(const Material& m) {
        text_ += '\n';
        line(Keyword::material, m.ambient, m.diffuse, m.specular, m.exponent, m.reflection, m.transmission,
             m.index);
        if (m.tint != Material{}.tint) line(Keyword::tint, m.tint);
    }

    void printNextMaterial() { printMaterial(scene_.materials[materialsPrinted_++]); }

    /// Makes `id` the current material. One printed before is printed again: that happens only to scenes that
    /// were not read from text, whose ids never decrease.
    void useMaterial(MaterialId id) {
        if (id.index + 1 == current_) return;
        if (id.index < materialsPrinted_) printMaterial(scene_.materials[id.index]);
        while (materialsPrinted_ <= id.index) printNextMaterial();
        current_ = id.index + 1;
    }

    void printBody(const Body& body) {
        useMaterial(body.material);
        std::visit([this](const auto& shape) { printShape(shape); }, body.shape);
        if (body.back) line(Keyword::backfaceColour, *body.back);
        if (body.referential) line(Keyword::instanceReferential, *body.referential);
    }

    void printShape(const Sphere& s) { line(Keyword::sphere, s.centre, s.radius); }
    void printShape(const Box& b) { line(Keyword::box, b.centre, b.sides); }
    void printShape(const Cone& c) { line(Keyword::cone, c.centre, c.radius, c.height); }
    void printShape(const TruncatedCone& c) {
        line(Keyword::truncatedCone, c.centre, c.radius, c.coneHeight, c.height);
    }
    void printShape(const Disc& d) { line(Keyword::disc, d.centre, d.radius); }
    void printShape(const Polygon& p) { line(Keyword::polygon, p.vertices); }
    void printShape(const Mesh& m) {
        line(Keyword::mesh, fileName(scene_.meshes[m.mesh.index].path), m.scale, m.axes.x, m.axes.y,
             m.axes.z.value_or(Vec3{}), m.translation);
    }

    void printShape(const Cylinder& c) { line(Keyword::cylinder, c.centre, c.radius, c.height); }
    void printShape(const OpenCylinder& c) { line(Keyword::openCylinder, c.centre, c.radius, c.height); }
    void printShape(const Frustum& f) {
        line(Keyword::frustum, f.centre, f.baseRadius, f.topRadius, f.height);
    }
    void printShape(const Plane& p) { line(Keyword::plane, p.normal, p.distance); }

    const Scene& scene_;
    std::string text_;
    std::size_t materialsPrinted_ = 0;
    std::size_t current_ = 0; ///< material in force, plus 1; 0: none
};

} // namespace

std::string printScene(const Scene& scene) { return Printer(scene).print(); }

} // namespace yarte
