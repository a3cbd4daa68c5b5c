#include "yarte/hits_text.h"

#include <fmt/format.h>

namespace yarte {

std::string hitsText(Tile region, std::span<const CameraHit> hits) {
    std::string text = "x,y,body,distance,normal_x,normal_y,normal_z\n";
    auto hit = hits.begin();
    for (int y = region.y0; y < region.y1; ++y)
        for (int x = region.x0; x < region.x1; ++x, ++hit)
            text += fmt::format("{},{},{},{},{},{},{}\n", x, y, hit->body, hit->distance, hit->normal.x,
                                hit->normal.y, hit->normal.z);
    return text;
}

} // namespace yarte
