#include "yarte/base/source.h"

#include <algorithm>
#include <utility>

namespace yarte {

Source::Source(std::string name, std::string text) : name_(std::move(name)), text_(std::move(text)) {
    if (text_.starts_with("\xEF\xBB\xBF")) text_.erase(0, 3);
}

const std::vector<std::size_t>& Source::lineStarts() const {
    if (!lineStarts_.empty()) return lineStarts_;
    lineStarts_.push_back(0);
    for (std::size_t i = 0; i < text_.size(); ++i)
        if (text_[i] == '\n') lineStarts_.push_back(i + 1);
    return lineStarts_;
}

LineColumn Source::position(std::size_t offset) const {
    const std::vector<std::size_t>& starts = lineStarts();
    const auto next = std::upper_bound(starts.begin(), starts.end(), offset);
    return {static_cast<std::size_t>(next - starts.begin()), offset - *(next - 1) + 1};
}

std::string_view Source::line(std::size_t line) const {
    const std::vector<std::size_t>& starts = lineStarts();
    if (line == 0 || line > starts.size()) return {};
    const std::size_t begin = starts[line - 1];
    std::size_t end = line < starts.size() ? starts[line] - 1 : text_.size();
    if (end > begin && text_[end - 1] == '\r') --end;
    return std::string_view(text_).substr(begin, end - begin);
}

SourceId Sources::add(std::string name, std::string text) {
    sources_.emplace_back(std::move(name), std::move(text));
    return {static_cast<std::uint32_t>(sources_.size() - 1)};
}

} // namespace yarte
