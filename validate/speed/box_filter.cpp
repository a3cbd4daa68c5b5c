#include "validate/speed/box_filter.h"

namespace yarte::validate {

Picture boxFiltered(const Picture& fine, int n) {
    Picture coarse{fine.width / n, fine.height / n, {}};
    coarse.pixels.resize(static_cast<std::size_t>(coarse.width) * static_cast<std::size_t>(coarse.height));
    const Colour* from = fine.pixels.data();
    for (int y = 0; y < coarse.height * n; ++y, from += fine.width)
        for (int x = 0; x < coarse.width * n; ++x)
            coarse.pixels[static_cast<std::size_t>(y / n) * static_cast<std::size_t>(coarse.width) +
                          static_cast<std::size_t>(x / n)] += from[x];
    return scaled(std::move(coarse), 1.0 / (n * n));
}

} // namespace yarte::validate
