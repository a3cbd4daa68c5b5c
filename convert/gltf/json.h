// Json: a JSON text as a tree that remembers which of its values were looked at. What nobody looked at cannot
// be in the output: the ledger says so (read_ledger.h), whatever it is.
#pragma once

#include "yarte/base/diagnostic.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace yarte::convert::gltf {

/// What became of a value.
enum class Fate : unsigned char {
    unread,       ///< so it is dropped
    read,         ///< so it is in the output
    approximated, ///< in the output changed
    inExtras,     ///< extras of our own, or what they say more exactly
};

class Json {
public:
    struct Member;
    using Array = std::vector<Json>;
    using Object = std::vector<Member>; ///< in the text's order

    Json() = default; ///< null
    template <class Value>
    explicit Json(Value value) : value_(std::move(value)) {}

    bool isObject() const { return std::holds_alternative<Object>(value_); }
    bool isArray() const { return std::holds_alternative<Array>(value_); }
    const double* number() const { return std::get_if<double>(&value_); }
    const bool* boolean() const { return std::get_if<bool>(&value_); }
    const std::string* text() const { return std::get_if<std::string>(&value_); }

    /// Empty unless it is an array, an object.
    std::span<const Json> items() const;
    std::span<const Member> members() const;
    Array& array() { return std::get<Array>(value_); }
    Object& object() { return std::get<Object>(value_); }

    /// The member of that name, marked as read; null if there is none or this is no object.
    const Json* find(std::string_view name) const;

    Fate fate() const { return fate_; }
    void mark(Fate fate) const { fate_ = fate; }
    /// The same for all that is in it.
    void markAll(Fate) const;
    /// Where it is `from` in it, it becomes `to`.
    void change(Fate from, Fate to) const;

private:
    std::variant<std::monostate, bool, double, std::string, Array, Object> value_;
    mutable Fate fate_ = Fate::unread;
};

struct Json::Member {
    std::string name;
    Json value;
};

inline constexpr int maxJsonDepth = 200; ///< of objects and arrays in each other: what follows them recurses

/// The value that `text` is, or nothing after reporting why not, in `file`. A name given twice in an object
/// stands for its first value.
std::optional<Json> parseJson(std::string_view text, const std::string& file, Diagnostics&);

/// The text of a value; numbers read back as the same doubles.
std::string printJson(const Json&);

/// Where `value` stands in `root` (RFC 6901), "/nodes/3/mesh"; "" for the root itself or a value that is not
/// in it.
std::string jsonPointer(const Json& root, const Json& value);

} // namespace yarte::convert::gltf
