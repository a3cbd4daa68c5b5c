// Value: what an SDL identifier can stand for.
#pragma once

#include "convert/povray/sdl/model.h"
#include "convert/povray/sdl/token.h"

#include <array>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace yarte::convert::povray::sdl {

/// A number (one component), a vector of two to five, or a colour: five, as red, green, blue, filter,
/// transmit.
struct Vector {
    int size = 1;
    std::array<double, 5> at{};

    static Vector number(double v) { return {1, {v}}; }
    static Vector of(Vec3 v) { return {3, {v.x, v.y, v.z}}; }
    static Vector of(const Rgbft& c) { return {5, {c.r, c.g, c.b, c.filter, c.transmit}}; }
    /// As where a vector of `n` is wanted: a number fills all, a shorter one is filled up with zeros.
    Vector promoted(int n) const;
    Vec3 vec3() const { return {at[0], at[1], at[2]}; }
    Rgbft rgbft() const { return {at[0], at[1], at[2], at[3], at[4]}; }
    friend bool operator==(const Vector&, const Vector&) = default;
};

struct Array;
struct Function;
struct Spline;
struct DataFile;

/// colour_map and the like: what is left of it is the mean of its colours.
struct ColourMap {
    Rgbft mean;
};
/// pigment_map, texture_map: what is left of it is its first entry.
struct TextureMap {
    Layers first;
};
/// What has no part in YARTE's picture but a name: "normal", "media", "density", "fog", "sky_sphere", ...
struct OpaqueValue {
    std::string kind;
};

template <typename T>
using Shared = std::shared_ptr<const T>;
using ArrayPtr = std::shared_ptr<Array>;

/// monostate: named, but without a value yet. What is large is shared, so that arrays of numbers stay small.
using Value = std::variant<std::monostate, Vector, std::string, ArrayPtr, Shared<Function>, Shared<Spline>,
                           ObjectPtr, Shared<Layers>, Shared<Pigment>, Shared<Finish>, Shared<Interior>,
                           Shared<Appearance>, Shared<Affine>, Shared<CameraModel>, Shared<ColourMap>,
                           Shared<TextureMap>, Shared<OpaqueValue>, std::shared_ptr<DataFile>>;

/// "a number", "a vector of 3", "a string", "an object", ...
std::string kindOf(const Value&);

/// What the elements of an array take, as long as it lives, of those that there may be.
class ArrayRoom {
public:
    ArrayRoom() = default;
    ArrayRoom(std::shared_ptr<std::size_t> left, std::size_t taken) : left_(std::move(left)), taken_(taken) {
        *left_ -= taken;
    }
    ~ArrayRoom() {
        if (left_) *left_ += taken_;
    }
    ArrayRoom(ArrayRoom&& other) noexcept = default;
    ArrayRoom& operator=(ArrayRoom&&) = delete;

private:
    std::shared_ptr<std::size_t> left_;
    std::size_t taken_ = 0;
};

/// Row-major.
struct Array {
    std::vector<int> sizes{};
    std::vector<Value> elements{};
    ArrayRoom room{};
};

/// Where a macro's text is.
struct Macro {
    std::string name;
    std::vector<std::string> parameters;
    SourceId source;
    std::size_t body = 0;  ///< offset of what follows the parameters
    std::string_view text; ///< from '#macro' up to the matching '#end', inclusive
    Span span;             ///< of its name
};

/// A name and what it stands for. Shared: a macro's parameter is the argument's own symbol where the argument
/// is just a name, so that assigning to it assigns there.
struct Symbol {
    std::string name;
    std::variant<Value, std::shared_ptr<const Macro>> content;
    Span span{}; ///< of the declaration

    const Value* value() const { return std::get_if<Value>(&content); }
    const Macro* macro() const {
        const auto* m = std::get_if<std::shared_ptr<const Macro>>(&content);
        return m ? m->get() : nullptr;
    }
    bool isDefined() const { return macro() || !std::holds_alternative<std::monostate>(*value()); }
};

using SymbolPtr = std::shared_ptr<Symbol>;

} // namespace yarte::convert::povray::sdl
