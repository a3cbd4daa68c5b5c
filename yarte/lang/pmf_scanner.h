// PmfScanner: the words and numbers of a mesh file. Such files are large: nothing is copied or allocated
// here.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace yarte {

/// Words end at white space or `;`, which starts a comment. An empty word means that there is none.
class PmfScanner {
public:
    explicit PmfScanner(std::string_view text)
        : begin_(text.data()), at_(text.data()), end_(text.data() + text.size()) {}

    std::size_t offset() const { return static_cast<std::size_t>(at_ - begin_); }
    bool atEnd() const { return at_ == end_; }
    bool atLetter() const;

    /// Over white space, line ends and comments.
    void skipSpace();
    std::string_view nextWord();
    /// The next word before the line ends.
    std::string_view nextWordOnLine();
    /// False, standing at the word, if the next one is not a finite number.
    bool nextNumber(double& value);
    /// Over white space; true if a word follows before the line ends.
    bool moreOnLine();
    /// False, standing at the word, if the next one is not a whole number below `limit`.
    bool nextIndex(std::size_t limit, std::uint32_t& index);
    /// Goes past the next word if it is `word`.
    bool skipWord(std::string_view word);

    /// The end of the line's text from `offset` on, white space and comments behind it left out.
    std::size_t endOfLine(std::size_t offset) const;

    /// The same of the whole text, its last comment kept.
    std::size_t endOfText() const;

    /// False if `word` is not a whole number from 0 to 2^32 - 1.
    static bool toIndex(std::string_view word, std::uint32_t& index);

private:
    std::string_view wordHere();

    const char *begin_, *at_, *end_;
};

} // namespace yarte
