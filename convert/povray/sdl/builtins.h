// The functions and constants of the language that a program can use.
#pragma once

#include "convert/povray/sdl/value.h"

#include <optional>
#include <span>
#include <string_view>

namespace yarte::convert::povray::sdl {

class Interpreter;

/// Of numbers alone: sin, max, ... These may stand in a user's functions, too.
struct ScalarFunction {
    int least, most; ///< arguments
    double (*call)(std::span<const double>);
};
const ScalarFunction* scalarFunction(std::string_view name);

/// "pi", "yes", "x"; none where it depends on the run ("clock", "image_width").
std::optional<Vector> constant(std::string_view name);

/// A function that gives a number or a vector, or a variable of the run: its name has been read. None: `name`
/// is no such word.
std::optional<Vector> numericBuiltin(Interpreter&, const Token& name);

bool isNumericBuiltin(std::string_view name);
bool isStringFunction(std::string_view name);
/// Its name has been read.
std::string stringFunction(Interpreter&, const Token& name);

} // namespace yarte::convert::povray::sdl
