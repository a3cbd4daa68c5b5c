// The directives that stand in the text: declarations and messages. Those that choose what is read are in
// flow.cpp, those of files in files.cpp.

#include "convert/povray/sdl/interpreter.h"
#include "convert/povray/sdl/words.h"

#include <fmt/format.h>

#include <unordered_map>

namespace yarte::convert::povray::sdl {

void Interpreter::directive(const Token& token) {
    using Run = void (*)(Interpreter&, const Token&);
    static const std::unordered_map<std::string_view, Run> runs{
        {"declare", [](Interpreter& in, const Token& t) { in.declare(t, false); }},
        {"local", [](Interpreter& in, const Token& t) { in.declare(t, true); }},
        {"undef", [](Interpreter& in, const Token&) { in.symbols_.remove(in.rawWord("a name").text); }},
        {"default",
         [](Interpreter& in, const Token&) {
             in.expect('{');
             in.statements_.defaults(in);
         }},
        {"macro", [](Interpreter& in, const Token& t) { in.defineMacro(t); }},
        {"include", [](Interpreter& in, const Token& t) { in.include(t); }},
        {"fopen", [](Interpreter& in, const Token& t) { in.openFile(t); }},
        {"fclose", [](Interpreter& in, const Token& t) { in.closeFile(t); }},
        {"read", [](Interpreter& in, const Token& t) { in.readFromFile(t); }},
        {"write", [](Interpreter& in, const Token& t) { in.writeToFile(t); }},
        {"version", [](Interpreter& in, const Token&) { in.setVersion(); }},
        {"debug", [](Interpreter& in, const Token& t) { in.message(t); }},
        {"render", [](Interpreter& in, const Token& t) { in.message(t); }},
        {"statistics", [](Interpreter& in, const Token& t) { in.message(t); }},
        {"warning", [](Interpreter& in, const Token& t) { in.message(t); }},
        {"error", [](Interpreter& in, const Token& t) { in.message(t); }},
        {"if", [](Interpreter& in, const Token& t) { in.conditional(t, in.parenthesised()); }},
        {"ifdef", [](Interpreter& in, const Token& t) { in.conditional(t, in.isDefinedName()); }},
        {"ifndef", [](Interpreter& in, const Token& t) { in.conditional(t, !in.isDefinedName()); }},
        {"else", [](Interpreter& in, const Token& t) { in.elseBranch(t); }},
        {"elseif", [](Interpreter& in, const Token& t) { in.elseBranch(t); }},
        {"end", [](Interpreter& in, const Token& t) { in.endOfBlock(t); }},
        {"while", [](Interpreter& in, const Token& t) { in.whileLoop(t); }},
        {"for", [](Interpreter& in, const Token& t) { in.forLoop(t); }},
        {"switch", [](Interpreter& in, const Token& t) { in.switching(t); }},
        {"case", [](Interpreter& in, const Token& t) { in.caseReached(t); }},
        {"range", [](Interpreter& in, const Token& t) { in.caseReached(t); }},
        {"break", [](Interpreter& in, const Token& t) { in.breakOut(t); }},
    };
    const auto run = runs.find(token.text);
    if (run != runs.end()) return run->second(*this, token);
    fail("sdl.directive", fmt::format("unknown directive #{}", token.text), token.span);
}

namespace {

/// What was written before the names by POV-Ray's own files: "deprecated once "message"".
void skipDeprecated(Interpreter& in) {
    if (!in.accept("deprecated")) return;
    in.accept("once");
    in.string();
}

} // namespace

void Interpreter::declare(const Token& directive, bool isLocal) {
    const Nested nested(*this);
    Token name = lex();
    if (name.isWord("deprecated")) {
        putBack(std::move(name));
        skipDeprecated(*this);
        name = next();
    }
    if (name.kind != TokenKind::word) fail("sdl.unexpected", "expected a name to declare", name.span);
    if (isReserved(name.text))
        fail("sdl.reserved", fmt::format("'{}' is a word of the language and cannot be declared", name.text),
             name.span);
    // Its value may come from a macro that has not ended when it is known: "Macro()" with a "Value;" in it.
    const std::size_t depth = symbols_.depth();
    // A local name hides those of callers; #declare changes the innermost there is, and makes global ones.
    SymbolPtr symbol = isLocal ? (symbols_.isLocal(name.text) ? symbols_.find(name.text) : nullptr)
                               : symbols_.find(name.text);
    const bool isElement = peek().is('[');
    if (isElement && !symbol) symbol = symbols_.find(name.text);
    if (isElement && (!symbol || !symbol->value()))
        fail("sdl.undeclared", fmt::format("array '{}' is not declared", name.text), name.span);
    Value* element = nullptr;
    std::shared_ptr<Array> kept; // the expression may change the name's value
    if (isElement) {
        Value& array = std::get<Value>(symbol->content);
        if (const auto* a = std::get_if<ArrayPtr>(&array)) kept = *a;
        element = &this->element(name, array);
    }
    expect('=');
    Value made = value();
    // POV-Ray asks for a semicolon after numbers and strings, and takes none.
    acceptTail(';');
    if (element) {
        *element = std::move(made);
        return;
    }
    if (!symbol) symbol = isLocal ? symbols_.addLocal(name.text, depth) : symbols_.addGlobal(name.text);
    symbol->content = std::move(made);
    symbol->span = directive.span;
}

void Interpreter::setVersion() {
    accept("unofficial");
    accept("official");
    const double version = number();
    acceptTail(';');
    if (!(version >= 1 && version < 3.8))
        warn("sdl.version", fmt::format("#version {}: read as POV-Ray 3.7 reads it", version), {});
    version_ = version;
    statements_.versionChanged(*this);
}

void Interpreter::message(const Token& directive) {
    const std::string text = string();
    if (directive.text == "error")
        fail("sdl.error-directive", fmt::format("#error: {}", text), directive.span);
    if (directive.text == "warning")
        warn("sdl.warning-directive", fmt::format("#warning: {}", text), directive.span);
    if (directive.text == "debug" && environment_.debug) environment_.debug(text);
}

} // namespace yarte::convert::povray::sdl
