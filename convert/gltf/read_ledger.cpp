#include "convert/gltf/read_ledger.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace yarte::convert::gltf {
namespace {

/// Why a property is as its fate says, or what says it otherwise.
struct Explanation {
    std::string_view where, property; ///< as in the row; a property of "" is any
    Fate fate;
    Action action;
    std::string_view detail;
};

constexpr auto explanations = std::to_array<Explanation>({
    {"", "extensionsUsed", Fate::unread, Action::exact, "follows from what is used"},
    {"", "animations", Fate::unread, Action::dropped, "the scene is as it is at rest"},
    {"/accessors/*", "min", Fate::unread, Action::exact, "follows from the elements"},
    {"/accessors/*", "max", Fate::unread, Action::exact, "follows from the elements"},
    {"/bufferViews/*", "target", Fate::unread, Action::exact, "follows from the use"},
    {"/cameras/*/orthographic", "", Fate::approximated, Action::approximated,
     "a perspective camera that sees the scene's centre in the same size"},
    {"/extensions/KHR_lights_punctual/lights/*", "", Fate::approximated, Action::approximated,
     "a point light without fall-off"},
    {"/materials/*", "doubleSided", Fate::unread, Action::approximated, "both sides of every face are shown"},
    {"/meshes/*/primitives/*/attributes", "COLOR_0", Fate::approximated, Action::approximated,
     "the average of the colours is a factor of the material's"},
    {"/meshes/*/primitives/*/targets/*", "", Fate::read, Action::dropped, "the shape is that at rest"},
    {"/skins/*", "joints", Fate::read, Action::dropped, "the pose is that at rest"},
});

struct Count {
    std::size_t total = 0;
    std::array<std::size_t, 4> of{}; ///< by fate
};

using Counts = std::map<std::pair<std::string, std::string>, Count>;

/// A value whose parts have fates of their own.
bool hasParts(const Json& json) {
    return !json.members().empty() || std::ranges::any_of(json.items(), [](const Json& item) {
        return item.isObject() || item.isArray();
    });
}

void collect(const Json& json, const std::string& where, Counts& counts);

void collectOne(const Json& json, const std::string& where, const std::string& property, Counts& counts) {
    if (json.fate() != Fate::unread && hasParts(json)) return collect(json, where + "/" + property, counts);
    Count& count = counts[{where, property}];
    ++count.total;
    ++count.of[static_cast<std::size_t>(json.fate())];
}

void collect(const Json& json, const std::string& where, Counts& counts) {
    for (const Json& item : json.items()) collectOne(item, where, "*", counts);
    for (const Json::Member& member : json.members()) collectOne(member.value, where, member.name, counts);
}

Action actionOf(Fate fate) {
    switch (fate) {
    case Fate::unread: return Action::dropped;
    case Fate::read: return Action::exact;
    case Fate::approximated: return Action::approximated;
    case Fate::inExtras: return Action::exact;
    }
    return Action::dropped;
}

LedgerRow rowOf(const std::string& where, const std::string& property, Fate fate, std::size_t count,
                std::size_t total) {
    LedgerRow row{where.empty() ? "/" : where, property, actionOf(fate), {}, {}};
    std::string_view detail;
    for (const Explanation& e : explanations) {
        const bool isHere = e.where == where && (e.property.empty() || e.property == property);
        if (isHere && e.fate == fate) row.action = e.action, detail = e.detail;
    }
    if (detail.empty() && fate == Fate::approximated && where.starts_with("/materials"))
        detail = "as a Phong material";
    if (detail.empty() && fate == Fate::inExtras) detail = "YARTE's own values";
    row.detail = count < total ? fmt::format("{} of {}", count, total)
                 : total > 1   ? fmt::format("all {}", total)
                               : "";
    if (!detail.empty()) row.detail += fmt::format("{}{}", row.detail.empty() ? "" : "; ", detail);
    return row;
}

} // namespace

void addRows(const Json& root, Ledger& ledger) {
    Counts counts;
    collect(root, "", counts);
    for (const auto& [place, count] : counts)
        for (std::size_t fate = 0; fate < count.of.size(); ++fate)
            if (count.of[fate] > 0)
                ledger.add(
                    rowOf(place.first, place.second, static_cast<Fate>(fate), count.of[fate], count.total));
}

} // namespace yarte::convert::gltf
