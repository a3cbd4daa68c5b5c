#include "convert/gltf/object.h"

#include "yarte/base/number.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace yarte::convert::gltf {
namespace {

constexpr std::string_view wrongType = "gltf.wrong-type", outOfRange = "gltf.out-of-range",
                           badReference = "gltf.bad-reference";
constexpr double maxCount = 9007199254740992.0; // 2^53: whole numbers up to here are doubles

const Json nothing{Json::Object()};

bool isWhole(const Json& json) {
    const double* number = json.number();
    return number && *number >= 0 && *number <= maxCount && *number == std::floor(*number);
}

} // namespace

void Errors::report(std::string_view code, std::string message, const Json& at, std::string_view member) {
    any_ = true;
    std::string place = jsonPointer(root_, at);
    if (!member.empty()) place += fmt::format("/{}", member);
    diagnostics_.error(code, std::move(message)).file = fmt::format("{}#{}", file_, place);
}

Object::Object(const Json& json, Errors& errors) : json_(&json), errors_(&errors) {
    json.mark(Fate::read);
    if (json.isObject()) return;
    errors.report(wrongType, "must be an object", json);
    json_ = &nothing;
}

void Object::error(std::string_view code, std::string message, std::string_view member) const {
    errors_->report(code, std::move(message), *json_, member);
}

double Object::number(std::string_view name, double fallback, Range range) const {
    const Json* json = find(name);
    if (!json) return fallback;
    const double* value = json->number();
    if (!value) {
        errors_->report(wrongType, "must be a number", *json);
        return fallback;
    }
    if (*value >= range.least && *value <= range.most) return *value;
    errors_->report(outOfRange, fmt::format("out of range, got {}", printNumber(*value)), *json);
    return fallback;
}

bool Object::boolean(std::string_view name, bool fallback) const {
    const Json* json = find(name);
    if (!json) return fallback;
    if (const bool* value = json->boolean()) return *value;
    errors_->report(wrongType, "must be true or false", *json);
    return fallback;
}

std::string Object::text(std::string_view name, std::string fallback) const {
    const Json* json = find(name);
    if (!json) return fallback;
    if (const std::string* value = json->text()) return *value;
    errors_->report(wrongType, "must be a string", *json);
    return fallback;
}

Vec3 Object::vector(std::string_view name, Vec3 fallback) const {
    const std::vector<double> v = numbers(name, 3);
    return v.empty() ? fallback : Vec3{v[0], v[1], v[2]};
}

Colour Object::colour(std::string_view name, Colour fallback, Range range) const {
    const std::vector<double> v = numbers(name, 3, range);
    return v.empty() ? fallback : Colour{v[0], v[1], v[2]};
}

std::size_t Object::count(std::string_view name, std::size_t fallback) const {
    const Json* json = find(name);
    if (!json) return fallback;
    if (isWhole(*json)) return static_cast<std::size_t>(*json->number());
    errors_->report(wrongType, "must be a whole number, not negative", *json);
    return fallback;
}

std::optional<std::uint32_t> Object::index(std::string_view name, std::size_t limit) const {
    const Json* json = find(name);
    if (!json) return std::nullopt;
    if (isWhole(*json) && *json->number() < static_cast<double>(limit))
        return static_cast<std::uint32_t>(*json->number());
    if (isWhole(*json))
        errors_->report(badReference,
                        fmt::format("names number {}, but there are {}", *json->number(), limit), *json);
    else
        errors_->report(wrongType, "must be an index, a whole number", *json);
    return std::nullopt;
}

std::vector<std::uint32_t> Object::indices(std::string_view name, std::size_t limit) const {
    std::vector<std::uint32_t> result;
    const Json* json = find(name);
    if (!json) return result;
    for (const double number : numbers(name)) {
        if (number >= 0 && number < static_cast<double>(limit) && number == std::floor(number)) {
            result.push_back(static_cast<std::uint32_t>(number));
            continue;
        }
        errors_->report(badReference, fmt::format("names number {}, but there are {}", number, limit), *json);
        return {};
    }
    std::vector<std::uint32_t> sorted = result;
    std::ranges::sort(sorted);
    if (std::ranges::adjacent_find(sorted) == sorted.end()) return result;
    errors_->report(badReference, "names something twice", *json);
    return {};
}

std::vector<double> Object::numbers(std::string_view name, std::size_t size, Range range) const {
    const Json* json = find(name);
    if (!json) return {};
    std::vector<double> result;
    for (const Json& item : json->items()) {
        const double* value = item.number();
        if (!value) {
            errors_->report(wrongType, "must be a number", item);
            return {};
        }
        if (*value < range.least || *value > range.most) {
            errors_->report(outOfRange, fmt::format("out of range, got {}", printNumber(*value)), item);
            return {};
        }
        result.push_back(*value);
    }
    if (json->isArray() && !result.empty() && (size == 0 || result.size() == size)) return result;
    errors_->report(wrongType,
                    size == 0 ? "must be an array of numbers, not empty"
                              : fmt::format("must be an array of {} numbers", size),
                    *json);
    return {};
}

std::optional<Object> Object::object(std::string_view name) const {
    const Json* json = find(name);
    if (!json) return std::nullopt;
    return Object(*json, *errors_);
}

std::optional<Object> Object::extension(std::string_view name) const {
    // A look at the list does not read what it holds.
    const Json* extensions = find("extensions");
    const Json* json = extensions ? extensions->find(name) : nullptr;
    if (!json) return std::nullopt;
    return Object(*json, *errors_);
}

std::vector<Object> Object::objects(std::string_view name) const {
    std::vector<Object> result;
    const Json* json = find(name);
    if (!json) return result;
    if (!json->isArray() || json->items().empty())
        errors_->report(wrongType, "must be an array of objects, not empty", *json);
    for (const Json& item : json->items()) {
        if (errors_->full()) break;
        result.emplace_back(item, *errors_);
    }
    return result;
}

void Object::require(std::string_view name) const {
    if (!has(name)) error("gltf.missing", "is missing", name);
}

} // namespace yarte::convert::gltf
