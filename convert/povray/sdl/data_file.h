// Files that a program reads or writes values of: #fopen, #read, #write, #fclose.
#pragma once

#include "convert/povray/sdl/lexer.h"
#include "convert/povray/sdl/value.h"

#include <filesystem>
#include <optional>
#include <string>

namespace yarte::convert::povray::sdl {

/// The values in a text, one after the other.
class DataReader {
public:
    explicit DataReader(Lexer text) : text_(text) {}

    /// A number, vector or string; none at the end. Throws SyntaxError on anything else. What follows a value
    /// is passed over as the comma that it should be, whatever it is, as POV-Ray does.
    std::optional<Value> next();
    /// Known as soon as the last value has been read, if no comma follows it.
    bool atEnd() const { return atEnd_; }

private:
    double number(Token first);
    Vector vector();

    Lexer text_;
    bool atEnd_ = false;
};

/// One of the two.
struct DataFile {
    std::optional<DataReader> reader;
    std::filesystem::path target{}; ///< where `written` goes when the file is closed
    std::string written{};
};

/// As #write prints a number or a vector.
std::string dataText(const Vector&);

} // namespace yarte::convert::povray::sdl
