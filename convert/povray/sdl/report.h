// Report: the ledger's rows of an SDL file. What is said again of the same place (a loop makes many objects
// at one) is one row.
#pragma once

#include "convert/ledger.h"
#include "yarte/base/source.h"

#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace yarte::convert::povray::sdl {

/// What the ledger says of one thing, wherever it is.
struct Loss {
    std::string property;
    Action action = Action::approximated;
    std::string detail;
    std::optional<double> bound{};
};

class Report {
public:
    explicit Report(const Sources& sources) : sources_(sources) {}

    void tell(std::string_view kind, Span, const Loss&);
    /// Of no place in the file.
    void tell(std::string_view where, const Loss& loss) { tell(where, {}, loss); }

    /// The rows in the order in which they were first told. The bound is the largest.
    void writeTo(Ledger&) const;

private:
    struct Row {
        LedgerRow row;
        std::size_t count = 1;
    };

    const Sources& sources_;
    std::vector<Row> rows_;
    std::map<std::tuple<std::string, std::string, std::string>, std::size_t> known_;
};

} // namespace yarte::convert::povray::sdl
