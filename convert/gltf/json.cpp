#include "convert/gltf/json.h"

#include "yarte/base/json.h"
#include "yarte/base/number.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>

namespace yarte::convert::gltf {
namespace {

/// Takes the parser's events. The parser itself does not recurse.
class TreeBuilder {
public:
    bool null() { return add(Json()); }
    bool boolean(bool value) { return add(Json(value)); }
    bool number_integer(std::int64_t value) { return add(Json(static_cast<double>(value))); }
    bool number_unsigned(std::uint64_t value) { return add(Json(static_cast<double>(value))); }
    bool number_float(double value, const std::string&) { return add(Json(value)); }
    bool string(std::string& value) { return add(Json(std::move(value))); }
    bool binary(std::vector<std::uint8_t>&) { return false; } // JSON has none
    bool start_object(std::size_t) { return begin(Json(Json::Object())); }
    bool start_array(std::size_t) { return begin(Json(Json::Array())); }
    bool key(std::string& name) {
        open_.back()->object().push_back({std::move(name), Json()});
        return true;
    }
    bool end_object() { return end(); }
    bool end_array() { return end(); }
    bool parse_error(std::size_t offset, const std::string&, const nlohmann::json::exception& error) {
        problem = error.what();
        // "[json.exception.parse_error.101] parse error at line 1, column 3: …": what follows the place. That
        // a number is too large is told without one: "[json.exception.out_of_range.406] number …".
        if (const auto colon = problem.find(": "); colon != problem.npos) problem.erase(0, colon + 2);
        if (problem.starts_with('[')) problem.erase(0, problem.find(' ') + 1);
        problem = fmt::format("the JSON is broken at byte {}: {}", offset, problem);
        return false;
    }

    Json root;
    std::string problem;

private:
    Json* place(Json value) {
        if (open_.empty()) return &(root = std::move(value));
        Json& parent = *open_.back();
        if (parent.isArray()) return &parent.array().emplace_back(std::move(value));
        return &(parent.object().back().value = std::move(value));
    }
    bool add(Json value) {
        place(std::move(value));
        return true;
    }
    /// Pointers to what is open stay valid: only the innermost one grows.
    bool begin(Json value) {
        if (open_.size() == maxJsonDepth) {
            problem = fmt::format("the JSON is more than {} levels deep", maxJsonDepth);
            return false;
        }
        open_.push_back(place(std::move(value)));
        return true;
    }
    bool end() {
        open_.pop_back();
        return true;
    }

    std::vector<Json*> open_;
};

std::string escaped(std::string_view name) {
    std::string result;
    for (const char c : name) {
        if (c == '~')
            result += "~0";
        else if (c == '/')
            result += "~1";
        else
            result += c;
    }
    return result;
}

void print(const Json& json, std::string& text) {
    const char* separator = "";
    if (json.isArray()) {
        text += "[";
        for (const Json& item : json.items()) {
            text += std::exchange(separator, ",");
            print(item, text);
        }
        text += "]";
    } else if (json.isObject()) {
        text += "{";
        for (const Json::Member& member : json.members()) {
            text += std::exchange(separator, ",");
            text += jsonString(member.name);
            text += ":";
            print(member.value, text);
        }
        text += "}";
    } else if (const double* number = json.number()) {
        text += printNumber(*number);
    } else if (const bool* boolean = json.boolean()) {
        text += *boolean ? "true" : "false";
    } else if (const std::string* string = json.text()) {
        text += jsonString(*string);
    } else {
        text += "null";
    }
}

bool appendPath(const Json& from, const Json& value, std::string& path) {
    if (&from == &value) return true;
    const std::size_t length = path.size();
    std::size_t index = 0;
    for (const Json& item : from.items()) {
        path += fmt::format("/{}", index++);
        if (appendPath(item, value, path)) return true;
        path.resize(length);
    }
    for (const Json::Member& member : from.members()) {
        path += fmt::format("/{}", escaped(member.name));
        if (appendPath(member.value, value, path)) return true;
        path.resize(length);
    }
    return false;
}

} // namespace

std::span<const Json> Json::items() const {
    const auto* array = std::get_if<Array>(&value_);
    return array ? std::span<const Json>(*array) : std::span<const Json>();
}

std::span<const Json::Member> Json::members() const {
    const auto* object = std::get_if<Object>(&value_);
    return object ? std::span<const Member>(*object) : std::span<const Member>();
}

const Json* Json::find(std::string_view name) const {
    const auto all = members();
    const auto found = std::ranges::find(all, name, &Member::name);
    if (found == all.end()) return nullptr;
    if (found->value.fate_ == Fate::unread) found->value.fate_ = Fate::read;
    return &found->value;
}

void Json::markAll(Fate fate) const {
    mark(fate);
    for (const Json& item : items()) item.markAll(fate);
    for (const Member& member : members()) member.value.markAll(fate);
}

void Json::change(Fate from, Fate to) const {
    if (fate_ == from) fate_ = to;
    for (const Json& item : items()) item.change(from, to);
    for (const Member& member : members()) member.value.change(from, to);
}

std::optional<Json> parseJson(std::string_view text, const std::string& file, Diagnostics& diagnostics) {
    TreeBuilder builder;
    if (nlohmann::json::sax_parse(text.begin(), text.end(), &builder)) return std::move(builder.root);
    diagnostics.error("gltf.bad-json", builder.problem).file = file;
    return std::nullopt;
}

std::string printJson(const Json& json) {
    std::string text;
    print(json, text);
    return text;
}

std::string jsonPointer(const Json& root, const Json& value) {
    std::string path;
    appendPath(root, value, path);
    return path;
}

} // namespace yarte::convert::gltf
