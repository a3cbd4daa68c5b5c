// Ledger: what became of every property in a conversion. Loss is reported, never silent.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace yarte::convert {

enum class Action {
    exact,        ///< the same value stands in the output
    approximated, ///< changed by at most `bound`
    extras,       ///< kept where only our own reader looks for it
    dropped,      ///< not in the output
    added,        ///< not in the input: a default that the output needs
};

std::string_view name(Action);

struct LedgerRow {
    std::string where;    ///< "camera", "material 3 (scene.yarte:27)"
    std::string property; ///< "apertures"
    Action action = Action::exact;
    std::string detail;
    std::optional<double> bound; ///< of the error, in the unit that `detail` names; none: unknown or no error
};

class Ledger {
public:
    void add(LedgerRow row) { rows_.push_back(std::move(row)); }

    const std::vector<LedgerRow>& rows() const { return rows_; }
    /// True if anything was approximated or dropped.
    bool hasLoss() const;
    /// True if the reader made up `where`, so that dropping it again loses nothing.
    bool wasAdded(std::string_view where) const;

private:
    std::vector<LedgerRow> rows_;
};

constexpr bool isLoss(Action a) { return a == Action::approximated || a == Action::dropped; }

/// "where: property: detail (at most BOUND)", for a warning.
std::string describe(const LedgerRow&);

/// {"schema": 1, "rows": [{"where", "property", "action", "detail", "bound"}]}; bound is null where there is
/// none.
std::string toJson(const Ledger&);

} // namespace yarte::convert
