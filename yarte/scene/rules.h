// Rules: what the check functions are made of. Private to this folder.
#pragma once

#include "yarte/scene/check.h"

#include <initializer_list>

namespace yarte {

/// Collects the rules that are broken. `name` begins the message: "radius must be positive, got -2".
class Rules {
public:
    /// False, and a problem for each, if some of the values, arguments `first` and following, are infinite or
    /// not a number. The other rules take finite values.
    bool finite(int first, std::initializer_list<double> values);
    bool finite(int first, Vec3 v) { return finite(first, {v.x, v.y, v.z}); }

    void positive(std::string_view code, std::string_view name, double value, int argument);
    void notNegative(std::string_view code, std::string_view name, double value, int argument);
    /// Three arguments from `first` on, none negative.
    void colour(std::string_view name, Colour, int first);
    void broken(Problem problem);

    Problems problems() && { return std::move(problems_); }

private:
    Problems problems_;
};

} // namespace yarte
