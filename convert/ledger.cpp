#include "convert/ledger.h"

#include "yarte/base/number.h"

#include <fmt/format.h>

#include <algorithm>

namespace yarte::convert {

std::string_view name(Action action) {
    switch (action) {
    case Action::exact: return "exact";
    case Action::approximated: return "approximated";
    case Action::extras: return "extras";
    case Action::dropped: return "dropped";
    case Action::added: return "added";
    }
    return "";
}

bool Ledger::hasLoss() const {
    return std::ranges::any_of(rows_, [](const LedgerRow& row) { return isLoss(row.action); });
}

bool Ledger::wasAdded(std::string_view where) const {
    return std::ranges::any_of(
        rows_, [&](const LedgerRow& row) { return row.action == Action::added && row.where == where; });
}

std::string describe(const LedgerRow& row) {
    const std::string bound = row.bound ? fmt::format(" (at most {})", printNumber(*row.bound)) : "";
    return fmt::format("{}: {} {}: {}{}", row.where, row.property, name(row.action), row.detail, bound);
}

} // namespace yarte::convert
