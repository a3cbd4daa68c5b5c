// RenderError: the machine did not let a render finish.
#pragma once

#include <stdexcept>

namespace yarte {

/// Too little memory, no process to be had, or a tile whose worker died twice; what() says which. Exit
/// code 3.
class RenderError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

} // namespace yarte
