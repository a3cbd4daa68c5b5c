// Interpreter: runs the program that an SDL file is.
//
// To its users, the parsers of statements, it is a stream of tokens in which directives have been obeyed,
// macros replaced by their text and files included, as in POV-Ray, where a #if or a macro may stand anywhere;
// and it evaluates the expressions in it. The first error ends the run: SyntaxError.
#pragma once

#include "convert/povray/sdl/lexer.h"
#include "convert/povray/sdl/limits.h"
#include "convert/povray/sdl/random.h"
#include "convert/povray/sdl/symbols.h"
#include "convert/povray/sdl/value.h"
#include "yarte/base/diagnostic.h"
#include "yarte/base/file.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace yarte::convert::povray::sdl {

class Interpreter;

/// What the language needs to know of statements: given to the interpreter, so that it can be tested alone.
struct Statements {
    virtual ~Statements() = default;
    /// The value that starts here, if it is more than an expression: object, texture, camera, ...
    virtual std::optional<Value> value(Interpreter&) = 0;
    /// The content of #default { ... }, the opening brace read.
    virtual void defaults(Interpreter&) = 0;
    /// After a #version.
    virtual void versionChanged(Interpreter&) = 0;
    /// True for a macro whose meaning is known: its arguments say more than what its text makes of them.
    virtual bool isKnown(const Interpreter&, const Macro&) = 0;
    /// What stands in place of a known macro's call; none: its text is run after all.
    virtual std::optional<Value> callKnown(Interpreter&, const Macro&, const std::vector<Value>& arguments,
                                           Span call) = 0;
    /// For min_extent and max_extent.
    virtual std::optional<std::array<Vec3, 2>> extent(const Object&) = 0;
};

struct Environment {
    Sources& sources;
    Diagnostics& diagnostics;
    ReadableFolders readable; ///< besides the scene's own folder
    /// Where the program may write, and relative names of its files start; none: it may not.
    std::optional<std::filesystem::path> writable{};
    std::vector<std::filesystem::path> library{}; ///< where includes are looked for last
    int width = 640, height = 480;                ///< image_width, image_height
    Limits limits{};
    std::function<void(const std::string&)> debug{}; ///< what #debug prints
    /// Tells of something that is not as POV-Ray would have it; for the ledger.
    std::function<void(Span, std::string what, std::string detail)> report{};
};

class Interpreter {
public:
    /// `file`: where the text comes from; its folder is where includes are looked for first.
    Interpreter(Environment, Statements&, SourceId text, std::filesystem::path file);

    // Tokens
    Token next();
    const Token& peek();
    /// As peek(), where the next token may belong to what was read before or not (is there an operator?
    /// another layer?): it does not obey a #declare, which would then come before its time.
    const Token& peekTail();
    bool acceptTail(char mark);
    /// Where the next token is, or near it, without looking at it.
    Span peekSpan() const;
    /// Puts back what was read last, or the last two, in reverse order.
    void putBack(Token);
    bool accept(char mark);
    bool accept(std::string_view word);
    Token expect(char mark);
    /// POV-Ray takes a comma or none.
    void comma() { accept(','); }
    bool atEnd() { return peek().kind == TokenKind::end; }
    /// Reads up to the matching '}', the opening one read.
    void skipBlock();
    /// The block that comes next, its brace included.
    void skipBraces() { expect('{'), skipBlock(); }
    /// The raw lexer's way for the many vectors of a mesh, where no token has been looked at.
    Vec3 point();
    /// A point of a list, and the comma that may follow it.
    Vec3 listedPoint();
    /// Whether the next point of a list follows, as point() would see it.
    bool isAtListedPoint() { return ahead_.empty() && frame().lexer.isAt('<'); }

    // Expressions
    /// A number, vector or colour. Comparisons are part of it; in all those below they need parentheses, as
    /// in POV-Ray: "<0, 2, 0> <0, 0, -1>" are two vectors.
    Vector expression();
    Vector term();
    bool flag(); ///< an expression
    double number();
    int integer();
    Vec3 vector3(); ///< promoted
    Rgbft colour(); ///< with or without the word colour, rgb, red, ...
    std::string string();
    /// True if what comes starts an expression of numbers.
    bool startsExpression();
    bool startsString();
    /// What may stand right of '=' or as an argument.
    Value value();
    /// The name that comes next as a number or vector, called or indexed if need be.
    Vector expressionOfName() { return unary(); }
    /// "(NAME)" or "(NAME[I])" comes next: whether it has a value.
    bool isDefinedName();

    /// The value of the name that comes next, through array indices, if it is a T; it is then read.
    template <typename T>
    std::optional<T> acceptNamed() {
        const Value* found = namedValue();
        if (!found || !std::holds_alternative<T>(*found)) return std::nullopt;
        T result = std::get<T>(*found);
        takeNamed();
        return result;
    }
    /// What the name that comes next stands for; null if no name comes, or one without a value. Reads its
    /// indices.
    const Value* namedValue();
    void takeNamed() { ahead_.pop_back(); }

    static bool isTrue(double v) { return v > 1e-10 || v < -1e-10; } ///< POV-Ray's tolerance

    [[noreturn]] void fail(std::string_view code, const std::string& message, Span where) const;
    /// "expected WHAT, found ..."
    [[noreturn]] void failExpected(std::string_view what);
    void report(Span where, std::string what, std::string detail) const;
    /// So much more that the program does, besides reading words.
    void takeSteps(std::uint64_t steps, Span where);
    void warn(std::string_view code, const std::string& message, Span where);

    /// The value of a global name, if it has one.
    const Value* global(std::string_view name) const;
    SymbolPtr find(std::string_view name) const { return symbols_.find(name); }
    Symbols& symbols() { return symbols_; }
    const Environment& environment() const { return environment_; }
    Statements& statements() { return statements_; }
    SourceId sceneText() const { return frames_.front().lexer.source(); }
    double languageVersion() const { return version_; }
    Random& random() { return random_; }
    /// As file_exists: of the files that may be read.
    bool fileExists(const std::string& name) const;
    /// At the end of the program.
    void closeFiles();
    /// Where the run is, outermost first: notes for a diagnostic.
    std::vector<DiagnosticNote> trace() const;

    /// Guards native recursion.
    class Nested {
    public:
        explicit Nested(Interpreter& in);
        ~Nested() { --in_.nesting_; }
        Nested(const Nested&) = delete;
        Nested& operator=(const Nested&) = delete;

    private:
        Interpreter& in_;
    };

private:
    struct Block {
        enum class Kind { conditional, loop, forLoop, switching } kind;
        Span span;               ///< of its directive
        std::size_t restart = 0; ///< loops: offset of the condition; #for: of the body
        // #for
        SymbolPtr variable{};
        double last = 0, step = 1;
        // conditional, switching
        bool elseSeen = false;
    };

    /// A text being read: the file, an included one, a macro's.
    struct Frame {
        Lexer lexer;
        std::filesystem::path file; ///< of the text
        std::string name;           ///< of the macro or included file
        Span call;                  ///< where it was called
        bool isMacro = false;
        std::vector<Block> blocks{};
    };

    // interpreter.cpp
    /// Obeys directives on the way; with `stopsAtDeclarations`, only those that choose what is read: another
    /// one is then the token.
    Token read(bool stopsAtDeclarations);
    Token lex();
    Frame& frame() { return frames_.back(); }
    void enterFrame(Frame);
    void leaveFrame();

    // directives.cpp
    void directive(const Token&);
    void declare(const Token&, bool isLocal);
    void assign(Symbol&, const Token& name);
    void conditional(const Token&, bool taken);
    void whileLoop(const Token&);
    void forLoop(const Token&);
    void switching(const Token&);
    void elseBranch(const Token&);
    void endOfBlock(const Token&);
    void breakOut(const Token&);
    void caseReached(const Token&);
    bool parenthesised();
    bool continuesFor(const Block&) const;
    void setVersion();
    void message(const Token&);
    enum class SkipTo { elseOrEnd, end, caseOrEnd };
    /// Skips text up to the directive that the current block stops at.
    Token skip(SkipTo, Span block);

    // files.cpp
    void include(const Token&);
    void openFile(const Token&);
    void closeFile(const Token&);
    void readFromFile(const Token&);
    void writeToFile(const Token&);
    std::shared_ptr<DataFile> openForWriting(const std::string& name, bool appends, Span where);
    std::pair<SymbolPtr, std::shared_ptr<DataFile>> openedFile();
    void finish(const DataFile&);
    void spend(std::size_t bytes, Span where); ///< of what may be written
    /// The file that a name in the text being read leads to.
    std::optional<std::filesystem::path> lookUp(const std::string& name) const;
    /// The text of the file that is found under `name`.
    SourceId sourceOf(const std::string& name, Span where);
    bool mayRead(const std::filesystem::path&) const;

    // macros.cpp
    void defineMacro(const Token&);
    void callMacro(const Token& name, const Macro&);
    Token rawWord(std::string_view what);

    // expressions.cpp
    Vector choice(const Vector& condition);
    Vector logical();
    Vector comparison();
    Vector sum();
    Vector product();
    Vector unary();
    Vector primary();
    Vector angled();
    Vector ofName(const Token& name);
    Vector colourWords();
    Vector components(const Token& place, Vector);
    Value& element(const Token& name, Value& array);
    Value arrayLiteral(const Token&);
    std::string someString();
    /// Arrays are values: a copy does not change with its original.
    Value copied(const Value&, Span where, int depth = 0);
    void fillArray(Array&, std::size_t dimension, std::size_t& at);

    Environment environment_;
    Statements& statements_;
    Symbols symbols_;
    Random random_;
    std::vector<Frame> frames_;
    std::vector<Token> ahead_;     ///< put back or looked at, the next one last
    std::filesystem::path folder_; ///< of the scene
    double version_ = 3.62;
    std::unordered_map<std::string, SourceId> included_; ///< by file
    std::uint64_t tokensLeft_;
    std::shared_ptr<std::size_t> elementsLeft_; ///< as ArrayRoom wants it
    std::size_t stringsLeft_;                   ///< bytes of strings that may still be made
    std::vector<std::shared_ptr<DataFile>> beingWritten_;
    std::size_t bytesLeft_; ///< of what #write may write
    int nesting_ = 0;
};

} // namespace yarte::convert::povray::sdl
