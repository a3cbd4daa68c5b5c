// Function: what `#declare f = function(a, b) { ... }` defines. Compiled where it is defined: later changes
// of the names in it do not change it.
#pragma once

#include "convert/povray/sdl/value.h"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace yarte::convert::povray::sdl {

class Interpreter;

struct Function {
    using Evaluate = std::function<double(std::span<const double> arguments)>;

    std::vector<std::string> parameters{"x", "y", "z"};
    Evaluate evaluate;  ///< null: it needs patterns or POV-Ray's internal functions, see `kind`
    std::string kind{}; ///< "pattern", "internal", ...
    /// Operands, with those of the deepest function that it calls: bounds the stack that it takes.
    int depth = 0;
    std::uint64_t steps = 0; ///< operands that a call evaluates, with all that it calls
};

/// From the word `function`, which comes next.
Value parseFunction(Interpreter&);

/// The function's value; 0, and a report, if it is none that is computed.
Vector call(const Function&, std::span<const double> arguments, Interpreter&, Span where);

} // namespace yarte::convert::povray::sdl
