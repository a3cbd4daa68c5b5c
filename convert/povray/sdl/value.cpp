#include "convert/povray/sdl/value.h"

#include <fmt/format.h>

namespace yarte::convert::povray::sdl {

Vector Vector::promoted(int n) const {
    Vector v = *this;
    for (int i = size; i < n; ++i) v.at[static_cast<std::size_t>(i)] = size == 1 ? at[0] : 0;
    v.size = n;
    return v;
}

namespace {

struct Kind {
    std::string operator()(std::monostate) const { return "which has no value yet"; }
    std::string operator()(const Vector& v) const {
        return v.size == 1 ? "a number" : v.size == 5 ? "a colour" : fmt::format("a vector of {}", v.size);
    }
    std::string operator()(const std::string&) const { return "a string"; }
    std::string operator()(const ArrayPtr&) const { return "an array"; }
    std::string operator()(const Shared<Function>&) const { return "a function"; }
    std::string operator()(const Shared<Spline>&) const { return "a spline"; }
    std::string operator()(const ObjectPtr&) const { return "an object"; }
    std::string operator()(const Shared<Layers>&) const { return "a texture"; }
    std::string operator()(const Shared<Pigment>&) const { return "a pigment"; }
    std::string operator()(const Shared<Finish>&) const { return "a finish"; }
    std::string operator()(const Shared<Interior>&) const { return "an interior"; }
    std::string operator()(const Shared<Appearance>&) const { return "a material"; }
    std::string operator()(const Shared<Affine>&) const { return "a transformation"; }
    std::string operator()(const Shared<CameraModel>&) const { return "a camera"; }
    std::string operator()(const Shared<ColourMap>&) const { return "a colour map"; }
    std::string operator()(const Shared<TextureMap>&) const { return "a map of textures"; }
    std::string operator()(const std::shared_ptr<DataFile>&) const { return "an open file"; }
    std::string operator()(const Shared<OpaqueValue>& v) const { return "a " + v->kind; }
};

} // namespace

std::string kindOf(const Value& value) { return std::visit(Kind{}, value); }

} // namespace yarte::convert::povray::sdl
