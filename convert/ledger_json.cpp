#include "convert/ledger.h"

#include <nlohmann/json.hpp>

namespace yarte::convert {

std::string toJson(const Ledger& ledger) {
    using Json = nlohmann::ordered_json; // keys in the order written here
    Json rows = Json::array();
    for (const LedgerRow& row : ledger.rows()) {
        rows.push_back({{"where", row.where},
                        {"property", row.property},
                        {"action", name(row.action)},
                        {"detail", row.detail},
                        {"bound", row.bound ? Json(*row.bound) : Json(nullptr)}});
    }
    // File names are bytes: what is not UTF-8 is replaced rather than refused.
    return Json{{"schema", 1}, {"rows", rows}}.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace yarte::convert
