#include "yarte/lang/statement.h"

#include "yarte/base/number.h"
#include "yarte/base/text.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace yarte {
namespace {

std::string expectedArguments(const Directive& d) {
    std::string counts = fmt::format("{}", d.count);
    if (d.otherCount != 0) counts += fmt::format(" or {}", d.otherCount);
    return fmt::format("{} takes {}{} number{} ({})", d.name, d.takesFileName ? "a file name and " : "",
                       counts, d.count == 1 ? "" : "s", d.arguments);
}

/// What is wrong with a polygon's count and number of arguments; empty if nothing is.
std::string polygonCountError(const std::vector<Argument>& arguments) {
    if (arguments.empty())
        return "polygon takes the number of its vertices and 3 numbers for each, got nothing";
    const double count = arguments[0].value;
    if (count < 0 || count != std::floor(count))
        return fmt::format("polygon takes a whole number of vertices first, got {}", printNumber(count));
    if (static_cast<double>(arguments.size() - 1) != 3 * count)
        return fmt::format("polygon takes 3 numbers for each of its {} vertices, got {} numbers",
                           printNumber(count), arguments.size() - 1);
    return {};
}

/// Without the quotes around it, with doubled ones inside made single.
std::string unquoted(std::string_view text) {
    std::string name;
    for (std::size_t i = 1; i + 1 < text.size(); ++i) {
        name += text[i];
        if (text[i] == '"') ++i;
    }
    return name;
}

} // namespace

StatementParser::StatementParser(SourceId text, const Sources& sources, Diagnostics& diagnostics)
    : lexer_(text, sources[text]), diagnostics_(diagnostics) {}

bool StatementParser::next(Statement& statement) {
    skipStrayTokens();
    if (lexer_.current().kind == TokenKind::end) return false;
    statement.good = true;
    readKeyword(statement);
    if (statement.directive != nullptr && statement.directive->takesFileName) readFileName(statement);
    readArguments(statement);
    if (statement.good) checkCount(statement);
    return true;
}

void StatementParser::report(Statement& statement, std::string_view code, std::string message, Span span) {
    diagnostics_.error(code, std::move(message), span);
    statement.good = false;
}

/// A statement takes all numbers that follow, so that these are at the beginning of the text or after a name.
void StatementParser::skipStrayTokens() {
    bool reported = false;
    for (; lexer_.current().kind != TokenKind::word && lexer_.current().kind != TokenKind::end;
         lexer_.advance()) {
        const Token& token = lexer_.current();
        if (!std::exchange(reported, true))
            diagnostics_.error("lang.expected-directive",
                               fmt::format("a directive is expected here, got {}", inQuotes(token.text)),
                               token.span);
    }
}

void StatementParser::readKeyword(Statement& statement) {
    const Token token = lexer_.current();
    lexer_.advance();
    statement.keyword = statement.whole = token.span;
    statement.directive = findDirective(token.text);
    if (statement.directive != nullptr) return;
    statement.directive = closestDirective(token.text);
    std::string hint;
    if (statement.directive != nullptr) hint = fmt::format("; did you mean '{}'?", statement.directive->name);
    report(statement, "lang.unknown-directive",
           fmt::format("{} is not a directive{}", inQuotes(token.text), hint), token.span);
}

void StatementParser::readFileName(Statement& statement) {
    const Token token = lexer_.current();
    statement.fileNameSpan = token.span;
    switch (token.kind) {
    case TokenKind::word:
        if (findDirective(token.text) != nullptr) break; // the next statement
        [[fallthrough]];
    case TokenKind::badNumber: // "60.pmf"
        statement.fileName = token.text;
        statement.whole.end = token.span.end;
        return lexer_.advance();
    case TokenKind::quotedName:
        statement.fileName = unquoted(token.text);
        statement.whole.end = token.span.end;
        return lexer_.advance();
    case TokenKind::unclosedName:
        report(statement, "lang.unclosed-name", "a quoted file name must end on its line", token.span);
        return lexer_.advance();
    case TokenKind::number:
    case TokenKind::hugeNumber:
    case TokenKind::end: break;
    }
    report(statement, "lang.missing-file-name",
           expectedArguments(*statement.directive) + ", got no file name", statement.keyword);
}

void StatementParser::readArguments(Statement& statement) {
    statement.arguments.clear();
    const bool silent = !statement.good; // the arguments of what is wrong already tell nothing
    for (; lexer_.current().isArgument(); lexer_.advance()) {
        const Token& token = lexer_.current();
        statement.arguments.push_back({token.value, token.span});
        statement.whole.end = token.span.end;
        if (silent || token.kind == TokenKind::number) continue;
        if (token.kind == TokenKind::hugeNumber)
            report(statement, "lang.number-too-large",
                   fmt::format("a number must be below 1.8e308, got {}", inQuotes(token.text)), token.span);
        else
            report(statement, "lang.bad-number", fmt::format("{} is not a number", inQuotes(token.text)),
                   token.span);
    }
}

void StatementParser::checkCount(Statement& statement) {
    const Directive& d = *statement.directive;
    const std::size_t got = statement.arguments.size();
    if (d.keyword == Keyword::polygon) {
        if (std::string error = polygonCountError(statement.arguments); !error.empty())
            report(statement, "lang.argument-count", std::move(error), statement.whole);
    } else if (got != d.count && (got != d.otherCount || got == 0))
        report(statement, "lang.argument-count", fmt::format("{}, got {}", expectedArguments(d), got),
               statement.whole);
}

} // namespace yarte
