// Uncertain: a number computed from inputs each of which may be off by half an ulp: its value for the inputs
// as they are, to 150 digits, and a rigorous bound of how far it moves. What it owes each input is kept apart
// (affine arithmetic [Comba & Stolfi 1993]), so that errors that cancel do so here, too.
#pragma once

#include "tests/hard/numbers.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace yarte::hard {

class Uncertain {
public:
    /// The part of the error that one input is responsible for: at most |change|.
    struct Share {
        std::uint32_t input;
        double change;
    };

    Uncertain() = default;
    Uncertain(int exact) : value_(exact) {}
    explicit Uncertain(const Real& exact) : value_(exact) {}
    Uncertain(const Real& value, std::uint32_t input, double change) : value_(value) {
        if (change != 0) shares_.push_back({input, change});
    }

    const Real& value() const { return value_; }
    const std::vector<Share>& shares() const { return shares_; }
    /// |change| of the value is at most this: to the first order in the inputs' errors, and the rest.
    double range() const {
        double sum = rest_;
        for (const Share& s : shares_) sum += std::abs(s.change);
        return sum;
    }

    friend Uncertain operator-(const Uncertain& a) { return combine(a, -1, a, 0, -a.value_, a.rest_); }
    friend Uncertain operator+(const Uncertain& a, const Uncertain& b) {
        return combine(a, 1, b, 1, a.value_ + b.value_, a.rest_ + b.rest_);
    }
    friend Uncertain operator-(const Uncertain& a, const Uncertain& b) {
        return combine(a, 1, b, -1, a.value_ - b.value_, a.rest_ + b.rest_);
    }
    friend Uncertain operator*(const Uncertain& a, const Uncertain& b) {
        const double x = a.rounded(), y = b.rounded();
        return combine(a, y, b, x, a.value_ * b.value_,
                       std::abs(x) * b.rest_ + std::abs(y) * a.rest_ + a.range() * b.range());
    }
    friend Uncertain operator/(const Uncertain& a, const Uncertain& b) { return a * inverse(b); }

    friend Uncertain inverse(const Uncertain& a) {
        const Real value = 1 / a.value_;
        const double y = static_cast<double>(value), relative = a.range() * std::abs(y);
        // 1/(a + e) = y - y^2 e + y^3 e^2 / (1 + y e)
        const double rest = relative < 1 ? std::abs(y) * relative * relative / (1 - relative)
                                         : std::numeric_limits<double>::infinity();
        return combine(a, -y * y, a, 0, value, y * y * a.rest_ + rest);
    }
    friend Uncertain sqrt(const Uncertain& a) {
        const Real value = a.value_ > 0 ? Real(boost::multiprecision::sqrt(a.value_)) : Real(0);
        const double root = static_cast<double>(value), relative = a.range() / (root * root);
        // sqrt(a + e) = root (1 + e/2a - ...), where the rest is at most (e/a)^2 / 2 for |e| < a
        const double rest =
            relative < 1 ? root * relative * relative / 2 : std::numeric_limits<double>::infinity();
        return combine(a, 0.5 / root, a, 0, value, 0.5 / root * a.rest_ + rest);
    }

private:
    double rounded() const { return static_cast<double>(value_); }

    /// a ka + b kb, as far as the shares go.
    static Uncertain combine(const Uncertain& a, double ka, const Uncertain& b, double kb, const Real& value,
                             double rest) {
        Uncertain result(value);
        result.rest_ = rest;
        result.shares_.reserve(a.shares_.size() + b.shares_.size());
        auto i = a.shares_.begin(), j = b.shares_.begin();
        while (i != a.shares_.end() || j != b.shares_.end()) {
            if (j == b.shares_.end() || (i != a.shares_.end() && i->input < j->input)) {
                result.shares_.push_back({i->input, i->change * ka});
                ++i;
            } else if (i == a.shares_.end() || j->input < i->input) {
                if (kb != 0) result.shares_.push_back({j->input, j->change * kb});
                ++j;
            } else {
                result.shares_.push_back({i->input, i->change * ka + j->change * kb});
                ++i, ++j;
            }
        }
        return result;
    }

    Real value_ = 0;
    std::vector<Share> shares_; ///< by input
    double rest_ = 0;
};

} // namespace yarte::hard
