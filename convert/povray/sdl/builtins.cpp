#include "convert/povray/sdl/builtins.h"

#include "convert/povray/sdl/affine.h"
#include "convert/povray/sdl/interpreter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <unordered_map>

namespace yarte::convert::povray::sdl {
namespace {

constexpr double pi = std::numbers::pi;
using Numbers = std::span<const double>;

constexpr std::pair<std::string_view, ScalarFunction> scalars[] = {
    {"abs", {1, 1, [](Numbers a) { return std::abs(a[0]); }}},
    {"acos", {1, 1, [](Numbers a) { return std::acos(std::clamp(a[0], -1.0, 1.0)); }}},
    {"acosh", {1, 1, [](Numbers a) { return std::acosh(a[0]); }}},
    {"asin", {1, 1, [](Numbers a) { return std::asin(std::clamp(a[0], -1.0, 1.0)); }}},
    {"asinh", {1, 1, [](Numbers a) { return std::asinh(a[0]); }}},
    {"atan", {1, 1, [](Numbers a) { return std::atan(a[0]); }}},
    {"atan2", {2, 2, [](Numbers a) { return std::atan2(a[0], a[1]); }}},
    {"atanh", {1, 1, [](Numbers a) { return std::atanh(a[0]); }}},
    {"ceil", {1, 1, [](Numbers a) { return std::ceil(a[0]); }}},
    {"cos", {1, 1, [](Numbers a) { return std::cos(a[0]); }}},
    {"cosh", {1, 1, [](Numbers a) { return std::cosh(a[0]); }}},
    {"degrees", {1, 1, [](Numbers a) { return a[0] * 180 / pi; }}},
    {"div", {2, 2, [](Numbers a) { return std::trunc(a[0] / a[1]); }}},
    {"exp", {1, 1, [](Numbers a) { return std::exp(a[0]); }}},
    {"floor", {1, 1, [](Numbers a) { return std::floor(a[0]); }}},
    {"int", {1, 1, [](Numbers a) { return std::trunc(a[0]); }}},
    {"ln", {1, 1, [](Numbers a) { return std::log(a[0]); }}},
    {"log", {1, 1, [](Numbers a) { return std::log10(a[0]); }}},
    {"max", {1, 99, [](Numbers a) { return *std::ranges::max_element(a); }}},
    {"min", {1, 99, [](Numbers a) { return *std::ranges::min_element(a); }}},
    {"mod", {2, 2, [](Numbers a) { return std::fmod(a[0], a[1]); }}},
    {"pow", {2, 2, [](Numbers a) { return std::pow(a[0], a[1]); }}},
    {"radians", {1, 1, [](Numbers a) { return a[0] * pi / 180; }}},
    {"select",
     {3, 4,
      [](Numbers a) {
          // Three: a < 0 or not; four: a < 0, a = 0, a > 0.
          if (a[0] < 0) return a[1];
          return a.size() == 4 && a[0] > 0 ? a[3] : a[2];
      }}},
    {"sin", {1, 1, [](Numbers a) { return std::sin(a[0]); }}},
    {"sinh", {1, 1, [](Numbers a) { return std::sinh(a[0]); }}},
    {"sqr", {1, 1, [](Numbers a) { return a[0] * a[0]; }}},
    {"sqrt", {1, 1, [](Numbers a) { return std::sqrt(a[0]); }}},
    {"tan", {1, 1, [](Numbers a) { return std::tan(a[0]); }}},
    {"tanh", {1, 1, [](Numbers a) { return std::tanh(a[0]); }}},
};

constexpr std::pair<std::string_view, Vector> constants[] = {
    {"pi", {1, {pi}}},
    {"yes", {1, {1}}},
    {"on", {1, {1}}},
    {"true", {1, {1}}},
    {"no", {1, {0}}},
    {"off", {1, {0}}},
    {"false", {1, {0}}},
    {"x", {3, {1, 0, 0}}},
    {"y", {3, {0, 1, 0}}},
    {"z", {3, {0, 0, 1}}},
    {"u", {2, {1, 0}}},
    {"v", {2, {0, 1}}},
    {"t", {4, {0, 0, 0, 1}}},
    // Of an animation's single picture.
    {"clock", {1, {0}}},
    {"clock_delta", {1, {1}}},
    {"clock_on", {1, {0}}},
    {"initial_clock", {1, {0}}},
    {"final_clock", {1, {1}}},
    {"frame_number", {1, {1}}},
    {"initial_frame", {1, {1}}},
    {"final_frame", {1, {1}}},
};

std::vector<double> scalarArguments(Interpreter& in, const Token& name, const ScalarFunction& function) {
    std::vector<double> arguments;
    in.expect('(');
    while (!in.peek().is(')')) {
        arguments.push_back(in.number());
        in.comma();
    }
    in.expect(')');
    const int count = static_cast<int>(arguments.size());
    if (count < function.least || count > function.most)
        in.fail("sdl.arguments", fmt::format("{} does not take {} arguments", name.text, count), name.span);
    return arguments;
}

/// The object that comes next, by name or written out.
ObjectPtr object(Interpreter& in) {
    if (auto named = in.acceptNamed<ObjectPtr>()) return *named;
    if (auto made = in.statements().value(in))
        if (auto* found = std::get_if<ObjectPtr>(&*made)) return *found;
    in.failExpected("an object");
}

Vec3 extent(Interpreter& in, const Token& name) {
    in.expect('(');
    const ObjectPtr found = object(in);
    in.expect(')');
    in.takeSteps(found->count, name.span);
    const auto box = in.statements().extent(*found);
    if (!box) {
        in.report(name.span, std::string(name.text), "of an object whose extent is not known: 0 is taken");
        return {};
    }
    return (*box)[name.text == "max_extent"];
}

const Array& array(Interpreter& in) {
    const Value* named = in.namedValue();
    const auto* found = named ? std::get_if<ArrayPtr>(named) : nullptr;
    if (!found) in.failExpected("an array");
    return **found;
}

using Call = Vector (*)(Interpreter&, const Token& name);

Vector bitwise(Interpreter& in, unsigned (*operation)(unsigned, unsigned)) {
    in.expect('(');
    auto value = static_cast<unsigned>(in.integer());
    while (in.accept(',')) value = operation(value, static_cast<unsigned>(in.integer()));
    in.expect(')');
    return Vector::number(static_cast<int>(value));
}

Vector vdot(Interpreter& in, const Token&) {
    in.expect('(');
    const Vec3 a = in.vector3();
    in.comma();
    const Vec3 b = in.vector3();
    in.expect(')');
    return Vector::number(dot(a, b));
}

Vector vcross(Interpreter& in, const Token&) {
    in.expect('(');
    const Vec3 a = in.vector3();
    in.comma();
    const Vec3 b = in.vector3();
    in.expect(')');
    return Vector::of(cross(a, b));
}

Vector vlength(Interpreter& in, const Token&) {
    in.expect('(');
    const Vec3 v = in.vector3();
    in.expect(')');
    return Vector::number(length(v));
}

Vector vnormalize(Interpreter& in, const Token&) {
    in.expect('(');
    const Vec3 v = in.vector3();
    in.expect(')');
    return Vector::of(length(v) == 0 ? v : v / length(v));
}

Vector vrotate(Interpreter& in, const Token&) {
    in.expect('(');
    const Vec3 v = in.vector3();
    in.comma();
    const Vec3 degrees = in.vector3();
    in.expect(')');
    return Vector::of(mapDirection(rotation(degrees), v));
}

Vector vaxisRotate(Interpreter& in, const Token&) {
    in.expect('(');
    const Vec3 v = in.vector3();
    in.comma();
    const Vec3 axis = in.vector3();
    in.comma();
    const double degrees = in.number();
    in.expect(')');
    if (length(axis) == 0) return Vector::of(v);
    return Vector::of(mapDirection(axisRotation(axis, degrees), v));
}

/// What only a renderer's knowledge of surfaces and noise could tell: its arguments are evaluated, zeros
/// stand for it, and the ledger has it.
template <int size>
Vector unknown(Interpreter& in, const Token& name) {
    in.expect('(');
    while (!in.peek().is(')')) {
        if (in.namedValue() && !in.startsExpression() && !in.startsString())
            in.takeNamed();
        else
            in.value();
        in.comma();
    }
    in.expect(')');
    in.report(name.span, std::string(name.text), "is not computed: zero is taken");
    return {size, {}};
}

const std::unordered_map<std::string_view, Call>& calls() {
    static const std::unordered_map<std::string_view, Call> table{
        {"vdot", vdot},
        {"vcross", vcross},
        {"vlength", vlength},
        {"vnormalize", vnormalize},
        {"vrotate", vrotate},
        {"vaxis_rotate", vaxisRotate},
        {"vturbulence", unknown<3>},
        {"trace", unknown<3>},
        {"inside", unknown<1>},
        {"min_extent", [](Interpreter& in, const Token& n) { return Vector::of(extent(in, n)); }},
        {"max_extent", [](Interpreter& in, const Token& n) { return Vector::of(extent(in, n)); }},
        {"bitwise_and",
         [](Interpreter& in, const Token&) {
             return bitwise(in, [](unsigned a, unsigned b) { return a & b; });
         }},
        {"bitwise_or",
         [](Interpreter& in, const Token&) {
             return bitwise(in, [](unsigned a, unsigned b) { return a | b; });
         }},
        {"bitwise_xor",
         [](Interpreter& in, const Token&) {
             return bitwise(in, [](unsigned a, unsigned b) { return a ^ b; });
         }},
        {"asc",
         [](Interpreter& in, const Token&) {
             in.expect('(');
             const std::string text = in.string();
             in.expect(')');
             return Vector::number(text.empty() ? 0 : static_cast<unsigned char>(text.front()));
         }},
        {"strlen",
         [](Interpreter& in, const Token&) {
             in.expect('(');
             const std::string text = in.string();
             in.expect(')');
             return Vector::number(static_cast<double>(text.size()));
         }},
        {"strcmp",
         [](Interpreter& in, const Token&) {
             in.expect('(');
             const std::string a = in.string();
             in.comma();
             const std::string b = in.string();
             in.expect(')');
             return Vector::number(a.compare(b) < 0 ? -1 : a.compare(b) > 0);
         }},
        {"val",
         [](Interpreter& in, const Token&) {
             in.expect('(');
             const std::string text = in.string();
             in.expect(')');
             return Vector::number(std::strtod(text.c_str(), nullptr));
         }},
        {"file_exists",
         [](Interpreter& in, const Token&) {
             in.expect('(');
             const std::string file = in.string();
             in.expect(')');
             return Vector::number(in.fileExists(file));
         }},
        {"dimensions",
         [](Interpreter& in, const Token&) {
             in.expect('(');
             const auto count = static_cast<double>(array(in).sizes.size());
             in.takeNamed();
             in.expect(')');
             return Vector::number(count);
         }},
        {"dimension_size",
         [](Interpreter& in, const Token& name) {
             in.expect('(');
             const std::vector<int> sizes = array(in).sizes;
             in.takeNamed();
             in.comma();
             const int dimension = in.integer();
             in.expect(')');
             if (dimension < 1 || dimension > static_cast<int>(sizes.size()))
                 in.fail("sdl.index", fmt::format("the array has no dimension {}", dimension), name.span);
             return Vector::number(sizes[static_cast<std::size_t>(dimension - 1)]);
         }},
        {"defined", [](Interpreter& in, const Token&) { return Vector::number(in.isDefinedName()); }},
        {"seed",
         [](Interpreter& in, const Token& name) {
             in.expect('(');
             const double value = in.number();
             in.expect(')');
             if (in.random().count() > 1'000'000)
                 in.fail("sdl.random", "more than a million streams of random numbers", name.span);
             const double wrapped = std::fmod(std::trunc(value), 4294967296.0);
             return Vector::number(static_cast<double>(
                 in.random().seed(static_cast<std::int32_t>(static_cast<std::int64_t>(wrapped)))));
         }},
        {"rand",
         [](Interpreter& in, const Token& name) {
             in.expect('(');
             const double stream = in.number();
             in.expect(')');
             if (!in.random().has(stream)) in.fail("sdl.random", "rand() needs what seed() gave", name.span);
             return Vector::number(in.random().next(static_cast<std::size_t>(stream)));
         }},
        {"image_width", [](Interpreter& in, const Token&) { return Vector::number(in.environment().width); }},
        {"image_height",
         [](Interpreter& in, const Token&) { return Vector::number(in.environment().height); }},
        {"version", [](Interpreter& in, const Token&) { return Vector::number(in.languageVersion()); }},
        {"now", [](Interpreter&, const Token&) { return Vector::number(0); }}, // the same for every run
    };
    return table;
}

} // namespace

const ScalarFunction* scalarFunction(std::string_view name) {
    const auto* found = std::ranges::find(scalars, name, [](const auto& entry) { return entry.first; });
    return found == std::end(scalars) ? nullptr : &found->second;
}

std::optional<Vector> constant(std::string_view name) {
    const auto* found = std::ranges::find(constants, name, [](const auto& entry) { return entry.first; });
    if (found == std::end(constants)) return std::nullopt;
    return found->second;
}

bool isNumericBuiltin(std::string_view name) { return scalarFunction(name) || calls().contains(name); }

std::optional<Vector> numericBuiltin(Interpreter& in, const Token& name) {
    if (const ScalarFunction* function = scalarFunction(name.text))
        return Vector::number(function->call(scalarArguments(in, name, *function)));
    const auto call = calls().find(name.text);
    if (call == calls().end()) return std::nullopt;
    return call->second(in, name);
}

} // namespace yarte::convert::povray::sdl
