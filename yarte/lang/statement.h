// Statement: a directive with its arguments as written; the parser cuts a scene's text into them.
#pragma once

#include "yarte/base/diagnostic.h"
#include "yarte/base/source.h"
#include "yarte/lang/directive.h"
#include "yarte/lang/lexer.h"

#include <string>
#include <vector>

namespace yarte {

struct Argument {
    double value = 0;
    Span span;
};

struct Statement {
    const Directive* directive = nullptr; ///< nothing: an unknown word, reported, unlike every keyword
    Span keyword;                         ///< the word
    Span whole;                           ///< from the word to the last argument
    std::string fileName;                 ///< of a mesh
    Span fileNameSpan;
    std::vector<Argument> arguments;
    /// Number and form of the arguments are right. If not, an error has been reported and the arguments are
    /// not to be used; the directive itself stands, so that one error does not lead to others.
    bool good = false;
};

class StatementParser {
public:
    StatementParser(SourceId text, const Sources&, Diagnostics&);

    /// False at the end of the text.
    bool next(Statement&);

private:
    void skipStrayTokens();
    void readKeyword(Statement&);
    void readFileName(Statement&);
    void readArguments(Statement&);
    void checkCount(Statement&);
    void report(Statement&, std::string_view code, std::string message, Span);

    Lexer lexer_;
    Diagnostics& diagnostics_;
};

} // namespace yarte
