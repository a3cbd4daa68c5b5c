#include "convert/tessellate_outline.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace yarte::convert {
namespace {

/// True if p, on the line through a and b, lies between them or on one.
bool isBetween(Point2 a, Point2 b, Point2 p) {
    return std::min(a.u, b.u) <= p.u && p.u <= std::max(a.u, b.u) && std::min(a.v, b.v) <= p.v &&
           p.v <= std::max(a.v, b.v);
}

int sign(double value) { return (value > 0) - (value < 0); }

bool meet(Point2 a, Point2 b, Point2 c, Point2 d) {
    const int abc = sign(doubleArea(a, b, c)), abd = sign(doubleArea(a, b, d)),
              cda = sign(doubleArea(c, d, a)), cdb = sign(doubleArea(c, d, b));
    if (abc * abd < 0 && cda * cdb < 0) return true;
    return (abc == 0 && isBetween(a, b, c)) || (abd == 0 && isBetween(a, b, d)) ||
           (cda == 0 && isBetween(c, d, a)) || (cdb == 0 && isBetween(c, d, b));
}

/// True if the edge bc goes back along the edge ab.
bool foldsBack(Point2 a, Point2 b, Point2 c) {
    return doubleArea(a, b, c) == 0 && (b.u - a.u) * (c.u - b.u) + (b.v - a.v) * (c.v - b.v) <= 0;
}

class EarClipper {
public:
    explicit EarClipper(const std::vector<Point2>& outline) : points_(outline), left_(outline.size()) {
        std::iota(left_.begin(), left_.end(), 0U);
    }

    std::optional<Triangles> clip() {
        while (left_.size() > 3)
            if (!clipOne()) return std::nullopt;
        emit(1);
        return std::move(triangles_);
    }

private:
    std::uint32_t at(std::size_t i) const { return left_[i % left_.size()]; }
    double area(std::size_t i) const {
        return doubleArea(points_[at(i + left_.size() - 1)], points_[at(i)], points_[at(i + 1)]);
    }

    bool clipOne() {
        // From where the last one was: ears in a row would make a fan of slivers.
        for (std::size_t tried = 0; tried < left_.size(); ++tried) {
            const std::size_t i = (start_ + tried) % left_.size();
            if (!isEar(i)) continue;
            emit(i);
            return remove(i);
        }
        // What is left is straight somewhere: a vertex without area can go.
        for (std::size_t i = 0; i < left_.size(); ++i)
            if (area(i) == 0) return remove(i);
        return false;
    }

    bool isEar(std::size_t i) const {
        if (!(area(i) > 0)) return false;
        const std::size_t n = left_.size();
        const Point2 a = points_[at(i + n - 1)], b = points_[at(i)], c = points_[at(i + 1)];
        for (std::size_t k = 2; k + 1 < n; ++k) {
            const Point2 p = points_[at(i + k)];
            if (doubleArea(a, b, p) >= 0 && doubleArea(b, c, p) >= 0 && doubleArea(c, a, p) >= 0)
                return false;
        }
        return true;
    }

    void emit(std::size_t i) {
        if (area(i) > 0) triangles_.push_back({at(i + left_.size() - 1), at(i), at(i + 1)});
    }

    bool remove(std::size_t i) {
        left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(i));
        start_ = i + 1;
        return true;
    }

    const std::vector<Point2>& points_;
    std::vector<std::uint32_t> left_;
    std::size_t start_ = 0;
    Triangles triangles_;
};

} // namespace

bool isSimple(const std::vector<Point2>& p) {
    const std::size_t n = p.size();
    const auto at = [&](std::size_t i) { return p[i % n]; };
    for (std::size_t i = 0; i < n; ++i)
        if (foldsBack(at(i), at(i + 1), at(i + 2))) return false;
    for (std::size_t i = 0; i + 2 < n; ++i)
        for (std::size_t j = i + 2; j < n; ++j) {
            if (i == 0 && j == n - 1) continue; // neighbours
            if (meet(p[i], p[i + 1], p[j], at(j + 1))) return false;
        }
    return true;
}

std::optional<Triangles> clipEars(const std::vector<Point2>& outline) { return EarClipper(outline).clip(); }

} // namespace yarte::convert
