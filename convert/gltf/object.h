// Object: a JSON object whose members are read by type. What is wrong with one is reported at its place, a
// JSON pointer, and its fallback is used instead, so that one run finds every error.
#pragma once

#include "convert/gltf/json.h"
#include "yarte/base/colour.h"
#include "yarte/base/vec3.h"

#include <cstdint>
#include <limits>

namespace yarte::convert::gltf {

/// Reports to where the file's other diagnostics go, as "model.gltf#/nodes/3: error: …".
class Errors {
public:
    Errors(std::string file, const Json& root, Diagnostics& diagnostics)
        : file_(std::move(file)), root_(root), diagnostics_(diagnostics) {}

    /// `member` names one of `at`, which may be missing.
    void report(std::string_view code, std::string message, const Json& at, std::string_view member = {});
    bool any() const { return any_; }
    bool full() const { return diagnostics_.full(); }
    const std::string& file() const { return file_; }
    Diagnostics& diagnostics() { return diagnostics_; }

private:
    std::string file_;
    const Json& root_;
    Diagnostics& diagnostics_;
    bool any_ = false;
};

/// Of a number, both included.
struct Range {
    double least = -std::numeric_limits<double>::max(), most = std::numeric_limits<double>::max();
};

inline constexpr Range unitRange{0, 1}, notNegative{0, std::numeric_limits<double>::max()};

class Object {
public:
    /// Reports and is empty if `json` is no object.
    Object(const Json& json, Errors& errors);

    const Json& json() const { return *json_; }
    const Json* find(std::string_view name) const { return json_->find(name); }
    bool has(std::string_view name) const { return find(name) != nullptr; }

    double number(std::string_view name, double fallback, Range range = {}) const;
    bool boolean(std::string_view name, bool fallback) const;
    std::string text(std::string_view name, std::string fallback = {}) const;
    Vec3 vector(std::string_view name, Vec3 fallback) const;
    Colour colour(std::string_view name, Colour fallback, Range range = unitRange) const;
    /// A whole number from 0 to 2^53.
    std::size_t count(std::string_view name, std::size_t fallback) const;
    /// A whole number below `limit`; nothing if it is missing or wrong.
    std::optional<std::uint32_t> index(std::string_view name, std::size_t limit) const;
    /// At least one whole number, each below `limit` and there once; empty if missing or wrong.
    std::vector<std::uint32_t> indices(std::string_view name, std::size_t limit) const;
    /// As many numbers as `size` if that is not 0; empty if missing or wrong.
    std::vector<double> numbers(std::string_view name, std::size_t size = 0, Range range = {}) const;
    /// The object of that name; nothing if it is missing or none.
    std::optional<Object> object(std::string_view name) const;
    std::optional<Object> extension(std::string_view name) const;
    /// The objects of the array of that name.
    std::vector<Object> objects(std::string_view name) const;

    /// An error if the member is missing.
    void require(std::string_view name) const;
    void error(std::string_view code, std::string message, std::string_view member = {}) const;

private:
    const Json* json_;
    Errors* errors_;
};

} // namespace yarte::convert::gltf
