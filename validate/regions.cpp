#include "validate/regions.h"

#include <algorithm>
#include <utility>

namespace yarte::validate {

namespace {

/// Pixels so far apart in x and y still belong together.
constexpr int reach = 2;

class Grouping {
public:
    explicit Grouping(const Difference& difference) : difference_(difference), taken_(difference.size()) {}

    std::vector<PixelGroup> groups() {
        std::vector<PixelGroup> list;
        for (std::size_t p = 0; p < difference_.size(); ++p)
            if (difference_.differs(p) && !taken_[p]) list.push_back(describe(groupOf(p)));
        std::stable_sort(list.begin(), list.end(), [](const PixelGroup& a, const PixelGroup& b) {
            return a.pixels.size() > b.pixels.size();
        });
        return list;
    }

private:
    std::vector<std::size_t> groupOf(std::size_t first) {
        std::vector<std::size_t> found{first};
        taken_[first] = true;
        for (std::size_t next = 0; next < found.size(); ++next) addNeighbours(found[next], found);
        std::sort(found.begin(), found.end());
        return found;
    }

    void addNeighbours(std::size_t pixel, std::vector<std::size_t>& found) {
        const Pixel at = place(pixel);
        for (int y = std::max(0, at.y - reach); y <= std::min(difference_.height() - 1, at.y + reach); ++y)
            for (int x = std::max(0, at.x - reach); x <= std::min(difference_.width() - 1, at.x + reach);
                 ++x) {
                const std::size_t p = static_cast<std::size_t>(y) * width() + static_cast<std::size_t>(x);
                if (!difference_.differs(p) || taken_[p]) continue;
                taken_[p] = true;
                found.push_back(p);
            }
    }

    PixelGroup describe(std::vector<std::size_t> pixels) const {
        Region region;
        const Pixel first = place(pixels.front());
        region.box = {first.x, first.y, first.x + 1, first.y + 1};
        region.pixels = pixels.size();
        for (const std::size_t p : pixels) {
            const Pixel at = place(p);
            region.box = {std::min(region.box.x0, at.x), std::min(region.box.y0, at.y),
                          std::max(region.box.x1, at.x + 1), std::max(region.box.y1, at.y + 1)};
            if (const double error = difference_.error(p); error > region.maxError)
                region.maxError = error, region.maxErrorAt = at;
        }
        return {region, std::move(pixels)};
    }

    std::size_t width() const { return static_cast<std::size_t>(difference_.width()); }
    Pixel place(std::size_t p) const {
        return {static_cast<int>(p % width()), static_cast<int>(p / width())};
    }

    const Difference& difference_;
    std::vector<bool> taken_;
};

} // namespace

std::vector<PixelGroup> groupPixels(const Difference& difference) { return Grouping(difference).groups(); }

} // namespace yarte::validate
