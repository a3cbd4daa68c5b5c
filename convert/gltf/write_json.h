// Values as JSON, for what is written.
#pragma once

#include "convert/gltf/json.h"
#include "convert/gltf/transform.h"
#include "yarte/base/colour.h"

#include <initializer_list>

namespace yarte::convert::gltf {

inline Json json(double value) { return Json(value); }
inline Json json(std::size_t value) { return Json(static_cast<double>(value)); } // below 2^53
inline Json json(const char* value) { return Json(std::string(value)); }
inline Json json(std::string value) { return Json(std::move(value)); }

inline Json json(std::span<const double> values) {
    Json::Array array;
    for (const double value : values) array.push_back(Json(value));
    return Json(std::move(array));
}
inline Json json(std::initializer_list<double> values) {
    return json(std::span<const double>(values.begin(), values.size()));
}
inline Json json(Vec3 v) { return json({v.x, v.y, v.z}); }
inline Json json(Colour c) { return json({c.r, c.g, c.b}); }
/// Columns, then the translation.
inline Json json(const Transform& t) {
    return json({t.x.x, t.x.y, t.x.z, t.y.x, t.y.y, t.y.z, t.z.x, t.z.y, t.z.z, t.translation.x,
                 t.translation.y, t.translation.z});
}

inline Json object(std::initializer_list<Json::Member> members) { return Json(Json::Object(members)); }
inline Json array(std::initializer_list<Json> items) { return Json(Json::Array(items)); }

inline void set(Json& object, std::string name, Json value) {
    object.object().push_back({std::move(name), std::move(value)});
}

} // namespace yarte::convert::gltf
