#include "yarte/scene/rules.h"

#include "yarte/base/number.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace yarte {

void Rules::broken(Problem problem) { problems_.push_back(std::move(problem)); }

bool Rules::finite(int first, std::initializer_list<double> values) {
    bool good = true;
    int argument = first;
    for (const double value : values) {
        if (!std::isfinite(value)) {
            broken({"scene.not-finite", fmt::format("a number must be finite, got {}", value), argument});
            good = false;
        }
        ++argument;
    }
    return good;
}

void Rules::positive(std::string_view code, std::string_view name, double value, int argument) {
    if (!(value > 0))
        broken({code, fmt::format("{} must be positive, got {}", name, printNumber(value)), argument});
}

void Rules::notNegative(std::string_view code, std::string_view name, double value, int argument) {
    if (value < 0)
        broken({code, fmt::format("{} must not be negative, got {}", name, printNumber(value)), argument});
}

void Rules::colour(std::string_view name, Colour c, int first) {
    notNegative("scene.colour-negative", name, c.r, first);
    notNegative("scene.colour-negative", name, c.g, first + 1);
    notNegative("scene.colour-negative", name, c.b, first + 2);
}

} // namespace yarte
