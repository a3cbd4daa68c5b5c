// The directives that choose what is read: conditions, loops, switches.

#include "convert/povray/sdl/interpreter.h"

#include <fmt/format.h>

namespace yarte::convert::povray::sdl {

bool Interpreter::parenthesised() {
    expect('(');
    const bool result = flag();
    expect(')');
    return result;
}

bool Interpreter::isDefinedName() {
    if (const Token open = lex(); !open.is('(')) fail("sdl.unexpected", "expected '('", open.span);
    const Token name = rawWord("a name");
    const SymbolPtr symbol = symbols_.find(name.text);
    bool isDefined = symbol && symbol->isDefined();
    if (isDefined && symbol->value() && peek().is('[')) {
        Value& element = this->element(name, std::get<Value>(symbol->content));
        isDefined = !std::holds_alternative<std::monostate>(element);
    } else if (!isDefined) {
        while (!peek().is(')')) next(); // indices of an array that is not there
    }
    expect(')');
    return isDefined;
}

Token Interpreter::skip(SkipTo to, Span block) {
    int depth = 0;
    for (;;) {
        Token token = lex();
        if (token.kind == TokenKind::end) fail("sdl.no-end", "this has no #end", block);
        if (token.kind != TokenKind::directive) continue;
        const std::string_view word = token.text;
        if (word == "if" || word == "ifdef" || word == "ifndef" || word == "while" || word == "for" ||
            word == "switch" || word == "macro")
            ++depth;
        if (word == "end" && depth-- == 0) return token;
        if (depth > 0) continue;
        if (to == SkipTo::elseOrEnd && (word == "else" || word == "elseif")) return token;
        if (to == SkipTo::caseOrEnd && (word == "case" || word == "range" || word == "else")) return token;
    }
}

void Interpreter::conditional(const Token& directive, bool taken) {
    frame().blocks.push_back({Block::Kind::conditional, directive.span});
    while (!taken) {
        const Token stop = skip(SkipTo::elseOrEnd, directive.span);
        if (stop.text == "end") {
            frame().blocks.pop_back();
            return;
        }
        taken = stop.text == "else" || parenthesised();
    }
}

void Interpreter::elseBranch(const Token& directive) {
    if (frame().blocks.empty() || (frame().blocks.back().kind != Block::Kind::conditional &&
                                   frame().blocks.back().kind != Block::Kind::switching))
        fail("sdl.else", fmt::format("#{} without an #if", directive.text), directive.span);
    if (frame().blocks.back().kind == Block::Kind::switching) return; // fallen through from the case before
    skip(SkipTo::end, frame().blocks.back().span);
    frame().blocks.pop_back();
}

void Interpreter::whileLoop(const Token& directive) {
    frame().blocks.push_back({Block::Kind::loop, directive.span, frame().lexer.offset()});
    if (parenthesised()) return;
    skip(SkipTo::end, directive.span);
    frame().blocks.pop_back();
}

bool Interpreter::continuesFor(const Block& block) const {
    const Value* value = block.variable->value();
    const auto* v = value ? std::get_if<Vector>(value) : nullptr;
    if (!v) fail("sdl.for", "the variable of this loop is no number any more", block.span);
    constexpr double tolerance = 1e-10; // POV-Ray's
    return block.step > 0 ? v->at[0] < block.last + tolerance : v->at[0] > block.last - tolerance;
}

void Interpreter::forLoop(const Token& directive) {
    Block block{Block::Kind::forLoop, directive.span};
    if (const Token open = lex(); !open.is('(')) fail("sdl.unexpected", "expected '('", open.span);
    const Token name = rawWord("the loop's variable");
    comma();
    const double first = number();
    comma();
    block.last = number();
    comma();
    if (!peek().is(')')) block.step = number();
    expect(')');
    if (block.step == 0) fail("sdl.for", "a step of 0 does not end", directive.span);
    block.variable = symbols_.addLocal(name.text);
    block.variable->content = Vector::number(first);
    block.restart = frame().lexer.offset();
    const bool runs = continuesFor(block);
    frame().blocks.push_back(std::move(block));
    if (runs) return;
    skip(SkipTo::end, directive.span);
    frame().blocks.pop_back();
}

void Interpreter::switching(const Token& directive) {
    expect('(');
    const double value = number();
    expect(')');
    frame().blocks.push_back({Block::Kind::switching, directive.span});
    for (;;) {
        const Token stop = skip(SkipTo::caseOrEnd, directive.span);
        if (stop.text == "end") {
            frame().blocks.pop_back();
            return;
        }
        if (stop.text == "else") return;
        expect('(');
        const double low = number();
        comma();
        const double high = stop.text == "range" ? number() : low;
        expect(')');
        constexpr double tolerance = 1e-10; // POV-Ray's
        const bool isCase =
            stop.text == "range" ? value >= low && value <= high : std::abs(value - low) < tolerance;
        if (isCase) return;
    }
}

void Interpreter::caseReached(const Token& directive) {
    if (frame().blocks.empty() || frame().blocks.back().kind != Block::Kind::switching)
        fail("sdl.case", fmt::format("#{} without a #switch", directive.text), directive.span);
    expect('('); // fallen through from the case before
    while (!peek().is(')')) number(), comma();
    expect(')');
}

void Interpreter::breakOut(const Token& directive) {
    while (!frame().blocks.empty()) {
        const Block block = std::move(frame().blocks.back());
        skip(SkipTo::end, block.span);
        frame().blocks.pop_back();
        if (block.kind != Block::Kind::conditional) return;
    }
    if (!frame().isMacro) fail("sdl.break", "#break outside of loops and #switch", directive.span);
    skip(SkipTo::end, directive.span); // ends the macro
    leaveFrame();
}

void Interpreter::endOfBlock(const Token& directive) {
    if (frame().blocks.empty()) {
        if (!frame().isMacro) fail("sdl.end", "#end without a beginning", directive.span);
        leaveFrame();
        return;
    }
    const std::size_t after = frame().lexer.offset();
    bool repeats = false;
    Block& block = frame().blocks.back();
    if (block.kind == Block::Kind::loop) {
        frame().lexer.seek(block.restart);
        repeats = parenthesised();
    } else if (block.kind == Block::Kind::forLoop) {
        const Value* value = block.variable->value();
        if (value && std::holds_alternative<Vector>(*value))
            block.variable->content = Vector::number(std::get<Vector>(*value).at[0] + block.step);
        repeats = continuesFor(block);
        if (repeats) frame().lexer.seek(block.restart);
    }
    if (repeats) return;
    frame().lexer.seek(after);
    frame().blocks.pop_back();
}

} // namespace yarte::convert::povray::sdl
