#include "convert/povray/sdl/interpreter.h"

#include <fmt/format.h>

namespace yarte::convert::povray::sdl {

Interpreter::Interpreter(Environment environment, Statements& statements, SourceId text,
                         std::filesystem::path file)
    : environment_(std::move(environment)), statements_(statements),
      folder_(file.has_parent_path() ? file.parent_path() : "."), tokensLeft_(environment_.limits.tokens),
      elementsLeft_(std::make_shared<std::size_t>(environment_.limits.elements)),
      stringsLeft_(environment_.limits.strings), bytesLeft_(environment_.limits.written) {
    const Source& source = environment_.sources[text];
    frames_.push_back({Lexer(source.text(), text), std::move(file), source.name(), {}});
}

Interpreter::Nested::Nested(Interpreter& in) : in_(in) {
    if (++in_.nesting_ > in_.environment_.limits.nesting) {
        --in_.nesting_; // the destructor will not run
        in_.fail(
            "sdl.too-deep",
            fmt::format("more than {} levels of braces and parentheses", in_.environment_.limits.nesting),
            in_.peek().span);
    }
}

void Interpreter::fail(std::string_view code, const std::string& message, Span where) const {
    throw SyntaxError(code, message, where);
}

void Interpreter::report(Span where, std::string what, std::string detail) const {
    if (environment_.report) environment_.report(where, std::move(what), std::move(detail));
}

void Interpreter::warn(std::string_view code, const std::string& message, Span where) {
    environment_.diagnostics.warning(code, message, where);
}

namespace {

std::string described(const Token& token) {
    switch (token.kind) {
    case TokenKind::end: return "the end of the file";
    case TokenKind::number: return "a number";
    case TokenKind::string: return "a string";
    case TokenKind::directive: return fmt::format("#{}", token.text);
    case TokenKind::word:
        if (!token.symbol || !token.symbol->value()) return fmt::format("'{}'", token.text);
        return fmt::format("'{}', {}", token.text, kindOf(*token.symbol->value()));
    case TokenKind::punctuation: break;
    }
    if (token.is(Mark::lessOrEqual)) return "'<='";
    if (token.is(Mark::greaterOrEqual)) return "'>='";
    if (token.is(Mark::notEqual)) return "'!='";
    return fmt::format("'{}'", token.mark);
}

} // namespace

void Interpreter::failExpected(std::string_view what) {
    const Token& found = peek();
    fail("sdl.unexpected", fmt::format("expected {}, found {}", what, described(found)), found.span);
}

std::vector<DiagnosticNote> Interpreter::trace() const {
    constexpr std::size_t shown = 10; // of a runaway recursion
    std::vector<DiagnosticNote> notes;
    for (auto f = frames_.rbegin(); f != frames_.rend() - 1 && notes.size() < shown; ++f)
        notes.push_back({f->isMacro ? fmt::format("in macro {}, called here", f->name)
                                    : fmt::format("in {}, included here", f->name),
                         f->call});
    return notes;
}

void Interpreter::enterFrame(Frame frame) {
    if (frames_.size() >= environment_.limits.frames)
        fail("sdl.recursion",
             fmt::format("more than {} macros and included files within one another",
                         environment_.limits.frames),
             frame.call);
    frames_.push_back(std::move(frame));
}

void Interpreter::leaveFrame() {
    frames_.pop_back();
    symbols_.leave();
}

void Interpreter::takeSteps(std::uint64_t steps, Span where) {
    if (steps > tokensLeft_)
        fail("sdl.runs-too-long",
             fmt::format("the program has not ended after {} words", environment_.limits.tokens), where);
    tokensLeft_ -= steps;
}

Token Interpreter::lex() {
    Lexer& lexer = frame().lexer;
    if (tokensLeft_ == 0) takeSteps(1, {lexer.source(), lexer.offset(), lexer.offset()});
    --tokensLeft_;
    return lexer.next();
}

namespace {

/// Directives that choose what is read, rather than declare or tell something.
bool isFlow(std::string_view directive) {
    for (const std::string_view flow : {"if", "ifdef", "ifndef", "else", "elseif", "end", "while", "for",
                                        "switch", "case", "range", "break"})
        if (directive == flow) return true;
    return false;
}

} // namespace

Token Interpreter::read(bool stopsAtDeclarations) {
    for (;;) {
        Token token = lex();
        switch (token.kind) {
        case TokenKind::directive:
            if (stopsAtDeclarations && !isFlow(token.text)) return token;
            directive(token);
            if (!ahead_.empty()) return next(); // a macro among what it read put something back
            continue;
        case TokenKind::end:
            if (!frame().blocks.empty()) fail("sdl.no-end", "this has no #end", frame().blocks.back().span);
            if (frames_.size() == 1) return token;
            leaveFrame();
            continue;
        case TokenKind::word:
            token.symbol = symbols_.find(token.text);
            if (token.symbol && token.symbol->macro()) {
                // The macro may redefine itself while it runs.
                const auto macro = std::get<std::shared_ptr<const Macro>>(token.symbol->content);
                callMacro(token, *macro);
                if (!ahead_.empty()) return next();
                continue;
            }
            return token;
        default: return token;
        }
    }
}

Token Interpreter::next() {
    while (!ahead_.empty()) {
        Token token = std::move(ahead_.back());
        ahead_.pop_back();
        if (token.kind != TokenKind::directive) return token;
        directive(token);
    }
    return read(false);
}

const Token& Interpreter::peek() {
    if (ahead_.empty() || ahead_.back().kind == TokenKind::directive) {
        Token token = next(); // which uses `ahead_` itself
        ahead_.push_back(std::move(token));
    }
    return ahead_.back();
}

const Token& Interpreter::peekTail() {
    if (ahead_.empty()) {
        Token token = read(true);
        ahead_.push_back(std::move(token));
    }
    return ahead_.back();
}

bool Interpreter::acceptTail(char mark) {
    if (!peekTail().is(mark)) return false;
    ahead_.pop_back();
    return true;
}

Span Interpreter::peekSpan() const {
    if (!ahead_.empty()) return ahead_.back().span;
    const Lexer& lexer = frames_.back().lexer;
    return {lexer.source(), lexer.offset(), lexer.offset()};
}

void Interpreter::putBack(Token token) { ahead_.push_back(std::move(token)); }

bool Interpreter::accept(char mark) {
    if (!peek().is(mark)) return false;
    ahead_.pop_back();
    return true;
}

bool Interpreter::accept(std::string_view word) {
    if (!peek().isWord(word)) return false;
    ahead_.pop_back();
    return true;
}

Token Interpreter::expect(char mark) {
    if (!peek().is(mark)) failExpected(fmt::format("'{}'", mark));
    return next();
}

void Interpreter::skipBlock() {
    const Span begin = peek().span;
    for (int depth = 1; depth > 0;) {
        const Token token = next();
        if (token.is('{')) ++depth;
        if (token.is('}')) --depth;
        if (token.kind == TokenKind::end) fail("sdl.no-brace", "this block has no closing brace", begin);
    }
}

const Value* Interpreter::global(std::string_view name) const {
    const SymbolPtr symbol = symbols_.find(name);
    return symbol ? symbol->value() : nullptr;
}

} // namespace yarte::convert::povray::sdl
