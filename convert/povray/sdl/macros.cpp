#include "convert/povray/sdl/interpreter.h"
#include "convert/povray/sdl/words.h"

#include <fmt/format.h>

namespace yarte::convert::povray::sdl {

/// A word as it stands: not looked up, no macro run.
Token Interpreter::rawWord(std::string_view what) {
    Token token = lex();
    if (token.kind != TokenKind::word) fail("sdl.unexpected", fmt::format("expected {}", what), token.span);
    return token;
}

void Interpreter::defineMacro(const Token& directive) {
    const Token name = rawWord("the macro's name");
    auto macro = std::make_shared<Macro>();
    macro->name = name.text;
    macro->span = name.span;
    macro->source = frame().lexer.source();
    Token token = lex();
    if (!token.is('(')) fail("sdl.unexpected", "expected '(' and the macro's parameters", token.span);
    for (token = lex(); !token.is(')'); token = lex()) {
        if (token.is(',')) continue;
        if (token.kind != TokenKind::word)
            fail("sdl.unexpected", "expected a parameter's name or ')'", token.span);
        macro->parameters.emplace_back(token.text);
    }
    macro->body = frame().lexer.offset();
    const Token end = skip(SkipTo::end, directive.span);
    const std::string_view text = environment_.sources[macro->source].text();
    macro->text = text.substr(directive.span.begin, end.span.end - directive.span.begin);
    const SymbolPtr symbol = symbols_.addGlobal(name.text);
    symbol->content = std::shared_ptr<const Macro>(std::move(macro));
    symbol->span = name.span;
}

void Interpreter::callMacro(const Token& name, const Macro& macro) {
    const Nested nested(*this);
    struct Argument {
        SymbolPtr reference; ///< the argument is just a name
        Value value;
    };
    std::vector<Argument> arguments;
    expect('(');
    while (!peek().is(')')) {
        if (arguments.size() == macro.parameters.size())
            fail("sdl.arguments",
                 fmt::format("macro {} takes {} arguments", macro.name, macro.parameters.size()),
                 peek().span);
        if (peek().kind == TokenKind::word) {
            Token word = next();
            // Of names that are not declared yet, too: the macro may declare them for the caller.
            const bool isName = (peek().is(',') || peek().is(')')) && (word.symbol || !isReserved(word.text));
            if (isName) {
                if (!word.symbol) word.symbol = symbols_.addGlobal(word.text);
                arguments.push_back({word.symbol, {}});
                comma();
                continue;
            }
            putBack(std::move(word));
        }
        arguments.push_back({nullptr, value()});
        comma();
    }
    expect(')');
    if (arguments.size() != macro.parameters.size())
        fail("sdl.arguments",
             fmt::format("macro {} takes {} arguments, not {}", macro.name, macro.parameters.size(),
                         arguments.size()),
             name.span);
    if (statements_.isKnown(*this, macro)) {
        std::vector<Value> values;
        for (const Argument& a : arguments) {
            const Value* of = a.reference ? a.reference->value() : &a.value;
            values.push_back(of ? *of : Value{});
        }
        if (std::optional<Value> made = statements_.callKnown(*this, macro, values, name.span)) {
            Token token = name;
            token.symbol = std::make_shared<Symbol>(Symbol{macro.name, std::move(*made)});
            putBack(std::move(token));
            return;
        }
    }
    const std::filesystem::path file = environment_.sources[macro.source].name();
    const std::string_view text = environment_.sources[macro.source].text();
    enterFrame({Lexer(text, macro.source, macro.body), file, macro.name, name.span, true});
    symbols_.enter();
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        Argument& argument = arguments[i];
        if (!argument.reference) {
            argument.reference =
                std::make_shared<Symbol>(Symbol{macro.parameters[i], std::move(argument.value)});
        }
        symbols_.bindLocal(macro.parameters[i], std::move(argument.reference));
    }
}

} // namespace yarte::convert::povray::sdl
