// Source: a text and where its lines begin. Span: a piece of it, by byte offsets.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace yarte {

/// Names a source in its `Sources`. The default names none: an error without a place in a text.
struct SourceId {
    std::uint32_t index = 0xffffffff;
    constexpr bool valid() const { return index != 0xffffffff; }
    friend constexpr bool operator==(SourceId, SourceId) = default;
};

/// Bytes [begin, end) of a source.
struct Span {
    SourceId source;
    std::size_t begin = 0, end = 0;
    friend constexpr bool operator==(const Span&, const Span&) = default;
};

/// Line and column as people and editors count: from 1; a column is a byte.
struct LineColumn {
    std::size_t line = 1, column = 1;
};

class Source {
public:
    /// A UTF-8 byte order mark is dropped: it is no part of the text.
    Source(std::string name, std::string text);

    const std::string& name() const { return name_; }
    std::string_view text() const { return text_; }
    LineColumn position(std::size_t offset) const;
    /// The text of line `line` (from 1) without its end; empty beyond the last.
    std::string_view line(std::size_t line) const;

private:
    const std::vector<std::size_t>& lineStarts() const;

    std::string name_, text_;
    /// Empty until something asks for a line: binary data, and texts without errors, need none.
    mutable std::vector<std::size_t> lineStarts_;
};

/// The texts read in one run; references stay valid.
class Sources {
public:
    SourceId add(std::string name, std::string text);
    const Source& operator[](SourceId id) const { return sources_[id.index]; }
    /// Gives back the memory of a text about which nothing is left to be said; its name stays.
    void release(SourceId id) { sources_[id.index] = Source(sources_[id.index].name(), {}); }

private:
    std::deque<Source> sources_;
};

} // namespace yarte
