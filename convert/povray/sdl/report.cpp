#include "convert/povray/sdl/report.h"

#include <fmt/format.h>

#include <algorithm>

namespace yarte::convert::povray::sdl {

void Report::tell(std::string_view kind, Span span, const Loss& loss) {
    std::string where(kind);
    if (span.source.valid()) {
        const Source& source = sources_[span.source];
        const LineColumn at = source.position(span.begin);
        where += fmt::format(" at {}:{}:{}", source.name(), at.line, at.column);
    }
    const auto [entry, isNew] = known_.try_emplace({where, loss.property, loss.detail}, rows_.size());
    if (isNew) {
        rows_.push_back({{where, loss.property, loss.action, loss.detail, loss.bound}});
        return;
    }
    Row& row = rows_[entry->second];
    ++row.count;
    if (loss.bound) row.row.bound = std::max(*loss.bound, row.row.bound.value_or(0));
}

void Report::writeTo(Ledger& ledger) const {
    for (const Row& row : rows_) {
        LedgerRow written = row.row;
        if (row.count > 1) written.detail += fmt::format(" ({} times)", row.count);
        ledger.add(std::move(written));
    }
}

} // namespace yarte::convert::povray::sdl
