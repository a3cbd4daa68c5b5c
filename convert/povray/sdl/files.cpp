// The files of a program: which it includes, and which it reads and writes values of.

#include "convert/povray/sdl/data_file.h"
#include "convert/povray/sdl/interpreter.h"
#include "convert/povray/sdl/words.h"

#include <fmt/format.h>

#include <utility>

namespace yarte::convert::povray::sdl {
namespace {

/// What opening a file for writing counts as: no program makes files without end.
constexpr std::size_t bytesOfAFile = 4096;

} // namespace

std::optional<std::filesystem::path> Interpreter::lookUp(const std::string& name) const {
    namespace fs = std::filesystem;
    std::error_code ignored;
    const fs::path& from = frames_.back().file;
    std::vector<fs::path> folders;
    if (environment_.writable) folders.push_back(*environment_.writable); // what the program wrote
    folders.push_back(from.has_parent_path() ? from.parent_path() : ".");
    folders.push_back(folder_);
    folders.insert(folders.end(), environment_.library.begin(), environment_.library.end());
    for (const fs::path& folder : folders)
        if (fs::is_regular_file(folder / name, ignored)) return (folder / name).lexically_normal();
    return std::nullopt;
}

bool Interpreter::mayRead(const std::filesystem::path& file) const {
    ReadableFolders readable = environment_.readable;
    readable.folders.push_back(folder_);
    if (environment_.writable) readable.folders.push_back(*environment_.writable);
    readable.folders.insert(readable.folders.end(), environment_.library.begin(), environment_.library.end());
    return readable.contain(file);
}

bool Interpreter::fileExists(const std::string& name) const {
    const auto file = lookUp(name);
    return file && mayRead(*file);
}

SourceId Interpreter::sourceOf(const std::string& name, Span where) {
    const auto file = lookUp(name);
    if (!file)
        fail("sdl.include-missing",
             fmt::format("no file '{}' in the scene's folder nor in POV-Ray's library", name), where);
    if (!mayRead(*file))
        fail("sdl.include-refused", fmt::format("'{}' is outside the scene's folder", name), where);
    // A file that is included again, as by a loop, is kept once.
    SourceId& source = included_[file->string()];
    if (!source.valid()) source = environment_.sources.add(file->string(), readFile(*file));
    return source;
}

void Interpreter::include(const Token& directive) {
    const Span where = peek().span;
    const std::string name = string();
    const SourceId source = sourceOf(name, where);
    const Source& text = environment_.sources[source];
    enterFrame({Lexer(text.text(), source), text.name(), name, directive.span});
    symbols_.enter();
}

/// The file that may be written under that name; what is there already is kept where it is appended to.
std::shared_ptr<DataFile> Interpreter::openForWriting(const std::string& name, bool appends, Span where) {
    if (!environment_.writable)
        fail("sdl.file-access", "a scene that writes files is refused, unless --allow-write names a folder",
             where);
    auto file = std::make_shared<DataFile>();
    file->target = (*environment_.writable / name).lexically_normal();
    if (!ReadableFolders{{*environment_.writable}}.contain(file->target))
        fail("sdl.file-access", fmt::format("'{}' is outside the folder that may be written", name), where);
    std::error_code ignored;
    if (appends && std::filesystem::exists(file->target, ignored)) file->written = readFile(file->target);
    spend(bytesOfAFile + file->written.size(), where);
    beingWritten_.push_back(file);
    return file;
}

void Interpreter::openFile(const Token&) {
    const Token name = rawWord("a name for the file");
    if (isReserved(name.text))
        fail("sdl.reserved", fmt::format("'{}' is a word of the language and cannot be declared", name.text),
             name.span);
    const Span where = peek().span;
    const std::string file = string();
    const Token mode = next();
    const bool appends = mode.isWord("append");
    std::shared_ptr<DataFile> opened;
    if (mode.isWord("read")) {
        const SourceId source = sourceOf(file, where);
        opened = std::make_shared<DataFile>();
        opened->reader.emplace(Lexer(environment_.sources[source].text(), source));
    } else if (appends || mode.isWord("write")) {
        opened = openForWriting(file, appends, where);
    } else {
        fail("sdl.unexpected", "expected read, write or append", mode.span);
    }
    SymbolPtr symbol = symbols_.find(name.text);
    if (!symbol) symbol = symbols_.addGlobal(name.text);
    symbol->content = Value(std::move(opened));
    symbol->span = name.span;
}

void Interpreter::spend(std::size_t bytes, Span where) {
    if (bytes > bytesLeft_)
        fail("sdl.writes-too-much", fmt::format("more than {} bytes written", environment_.limits.written),
             where);
    bytesLeft_ -= bytes;
}

/// The open file that the next word names.
std::pair<SymbolPtr, std::shared_ptr<DataFile>> Interpreter::openedFile() {
    const Token name = next();
    const Value* value = name.symbol ? name.symbol->value() : nullptr;
    const auto* file = value ? std::get_if<std::shared_ptr<DataFile>>(value) : nullptr;
    if (!file) fail("sdl.no-file", "expected the name of an open file", name.span);
    return {name.symbol, *file};
}

void Interpreter::closeFile(const Token&) {
    const Token& name = peek();
    if (name.symbol && !name.symbol->isDefined()) { // it has ended, or was closed
        next();
        return;
    }
    const auto [symbol, file] = openedFile();
    symbol->content = Value{};
    if (file->reader) return;
    std::erase(beingWritten_, file);
    finish(*file);
}

void Interpreter::finish(const DataFile& file) {
    writeFile(file.target, file.written);
    included_.erase(file.target.string()); // it may be read again
}

void Interpreter::closeFiles() {
    for (const auto& file : std::exchange(beingWritten_, {})) finish(*file);
}

void Interpreter::readFromFile(const Token& directive) {
    expect('(');
    const auto [symbol, file] = openedFile();
    if (!file->reader) fail("sdl.no-file", "this file is open for writing", directive.span);
    comma();
    while (!accept(')')) {
        Token name = next();
        if (name.kind != TokenKind::word || (!name.symbol && isReserved(name.text)))
            fail("sdl.unexpected", "expected a name to read a value into", name.span);
        if (!name.symbol) name.symbol = symbols_.addGlobal(name.text);
        // After the end names keep what they had.
        if (std::optional<Value> value = file->reader->next()) name.symbol->content = std::move(*value);
        comma();
    }
    if (file->reader->atEnd()) symbol->content = Value{}; // as if closed: #while (defined(F)) ends
}

void Interpreter::writeToFile(const Token& directive) {
    expect('(');
    const auto file = openedFile().second;
    if (file->reader) fail("sdl.no-file", "this file is open for reading", directive.span);
    comma();
    while (!accept(')')) {
        const std::string text = startsString() ? string() : dataText(expression());
        spend(text.size(), directive.span);
        file->written += text;
        comma();
    }
}

} // namespace yarte::convert::povray::sdl
