// ArgumentReader: a statement's numbers, one after the other, as vectors and colours.
#pragma once

#include "yarte/base/colour.h"
#include "yarte/lang/statement.h"
#include "yarte/scene/scene.h"

namespace yarte {

/// Their number has been checked: the parser has done it for every good statement.
class ArgumentReader {
public:
    explicit ArgumentReader(const Statement& statement) : next_(statement.arguments.begin()) {}

    double number() { return (next_++)->value; }
    // The elements of a braced list are evaluated from left to right.
    Vec3 vec3() { return Vec3{number(), number(), number()}; }
    Colour colour() { return Colour{number(), number(), number()}; }

private:
    std::vector<Argument>::const_iterator next_;
};

} // namespace yarte
