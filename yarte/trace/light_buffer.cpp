#include "yarte/trace/light_buffer.h"

#include "yarte/base/huge_pages.h"

#include <cmath>
#include <limits>
#include <optional>

namespace yarte::trace {
namespace {

constexpr std::size_t cellsPerElement = 2, maxCells = 256 * 256;
/// Cells with more are crowded.
constexpr std::uint32_t maxElementsInCell = 64;
/// No buffer is made if more than this share of what is seen is seen in crowded cells ...
constexpr double maxCrowded = 0.01;
/// ... or if more than this many elements are seen in a cell, on average.
constexpr double maxMean = 32;

using Axes = double[3];

struct Interval {
    double low, high;
    double length() const { return high - low; }
    void add(Interval i) { low = std::min(low, i.low), high = std::max(high, i.high); }
};

/// The slopes at which a face sees an element.
struct View {
    Interval u, v;
    double depth;
    std::uint32_t entry;
};

/// x / z for all x and all z > 0 of two intervals, as far as it is in [-1, 1].
std::optional<Interval> slopes(Interval x, Interval z) {
    if (x.low > z.high || x.high < -z.high) return std::nullopt; // the usual case, without divisions
    const double nearest = std::max(z.low, 0.0);
    const auto divided = [](double a, double b) { return a == 0 ? 0 : a / b; };
    return Interval{std::max(divided(x.low, x.low < 0 ? nearest : z.high), -1.0),
                    std::min(divided(x.high, x.high < 0 ? z.high : nearest), 1.0)};
}

/// `low` and `high` are the corners of a box, relative to the light.
std::optional<View> viewOf(const Axes& low, const Axes& high, const LightBuffer::Face& face) {
    const int axis = face.axis, a = (axis + 1) % 3, b = (axis + 2) % 3;
    const Interval depth =
        face.isDownwards ? Interval{-high[axis], -low[axis]} : Interval{low[axis], high[axis]};
    if (depth.high <= 0) return std::nullopt;
    const auto u = slopes({low[a], high[a]}, depth), v = slopes({low[b], high[b]}, depth);
    if (!u || !v) return std::nullopt;
    return View{*u, *v, std::max(depth.low, 0.0), 0};
}

struct FaceViews {
    LightBuffer::Face face;
    std::vector<View> views;
    Interval u{1, -1}, v{1, -1}; ///< over all views
    double area() const { return views.empty() ? 0 : u.length() * v.length(); }
};

FaceViews look(std::span<const Bounds> boxes, Vec3 light, double margin, int axis, bool isDownwards) {
    FaceViews result;
    result.face.axis = axis, result.face.isDownwards = isDownwards;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        const Vec3 l = boxes[i].low - light, h = boxes[i].high - light;
        auto view = viewOf({l.x - margin, l.y - margin, l.z - margin},
                           {h.x + margin, h.y + margin, h.z + margin}, result.face);
        if (!view) continue;
        view->entry = i;
        result.u.add(view->u), result.v.add(view->v);
        result.views.push_back(*view);
    }
    return result;
}

void layGrid(FaceViews& seen, double cells) {
    LightBuffer::Face& face = seen.face;
    const double u = seen.u.length(), v = seen.v.length();
    const double columns = std::clamp(std::round(std::sqrt(cells * u / v)), 1.0, cells);
    const double rows = std::clamp(std::round(cells / columns), 1.0, cells);
    constexpr double steps = LightBuffer::stepsPerCell * (1 - 0x1p-40); // the last slope is in the last cell
    face.columns = static_cast<std::uint32_t>(columns), face.rows = static_cast<std::uint32_t>(rows);
    face.uLow = seen.u.low, face.vLow = seen.v.low;
    face.uScale = columns / u * steps, face.vScale = rows / v * steps;
}

/// Steps [low, high] along one direction of a grid.
struct Stretch {
    int low, high;

    int firstCell() const { return low / LightBuffer::stepsPerCell; }
    int lastCell() const { return high / LightBuffer::stepsPerCell; }
    /// Relative to a cell.
    Stretch in(int cell) const {
        const int begin = cell * LightBuffer::stepsPerCell;
        return {std::max(low - begin, 0), std::min(high - begin, LightBuffer::stepsPerCell - 1)};
    }
};

struct Rectangle {
    Stretch u, v;
    double cellCount() const {
        return double(u.lastCell() - u.firstCell() + 1) * (v.lastCell() - v.firstCell() + 1);
    }
};

Rectangle placeOf(const View& view, const LightBuffer::Face& face) {
    const auto steps = [](Interval slope, double low, double scale) {
        return Stretch{static_cast<int>((slope.low - low) * scale),
                       static_cast<int>((slope.high - low) * scale)};
    };
    return {steps(view.u, face.uLow, face.uScale), steps(view.v, face.vLow, face.vScale)};
}

/// Calls `visit(view, cell, what the cell shows of it)`.
template <class Visit>
void forEachCell(std::span<const FaceViews> faces, LightBuffer& buffer, Visit&& visit) {
    for (const FaceViews& seen : faces)
        for (const View& view : seen.views) {
            const auto [u, v] = placeOf(view, seen.face);
            for (int row = v.firstCell(); row <= v.lastCell(); ++row) {
                LightBuffer::Cell* cells =
                    &buffer.cells[seen.face.firstCell + static_cast<std::uint32_t>(row) * seen.face.columns];
                for (int column = u.firstCell(); column <= u.lastCell(); ++column)
                    visit(view, cells[column], Rectangle{u.in(column), v.in(row)});
            }
        }
}

float roundDown(double v) {
    return std::nextafter(static_cast<float>(v), -std::numeric_limits<float>::infinity());
}

std::vector<FaceViews> lookAround(const Tree& tree, std::span<const Bounds> boxes, Vec3 light) {
    std::vector<FaceViews> faces;
    double area = 0;
    for (int axis = 0; axis < 3; ++axis)
        for (const bool isDownwards : {false, true}) {
            FaceViews seen = look(boxes, light, tree.margin, axis, isDownwards);
            if (seen.area() <= 0) continue;
            area += seen.area();
            faces.push_back(std::move(seen));
        }
    const auto cells = static_cast<double>(std::min(cellsPerElement * boxes.size(), maxCells));
    std::uint32_t cellCount = 0;
    for (FaceViews& seen : faces) {
        layGrid(seen, std::max(1.0, cells * seen.area() / area));
        seen.face.firstCell = cellCount;
        cellCount += seen.face.columns * seen.face.rows;
    }
    return faces;
}

/// Cells with their numbers of elements as blockCount, and ranges of depth; nothing if a buffer would not
/// pay.
std::vector<LightBuffer::Cell> countContents(std::span<const FaceViews> faces) {
    LightBuffer counted;
    const LightBuffer::Face& last = faces.back().face;
    const std::size_t cellCount = last.firstCell + last.columns * last.rows;
    double all = 0, crowded = 0;
    for (const FaceViews& seen : faces)
        for (const View& view : seen.views) all += placeOf(view, seen.face).cellCount();
    if (all > maxMean * static_cast<double>(cellCount)) return {};
    // While depths are gathered, depthScale is the greatest one.
    counted.cells.resize(cellCount, {0, 0, std::numeric_limits<float>::max(), 0});
    forEachCell(faces, counted, [](const View& view, LightBuffer::Cell& cell, const Rectangle&) {
        const float depth = roundDown(view.depth);
        cell.depthLow = std::min(cell.depthLow, depth), cell.depthScale = std::max(cell.depthScale, depth);
        ++cell.blockCount;
    });
    for (LightBuffer::Cell& cell : counted.cells) {
        const float range = cell.depthScale - cell.depthLow;
        cell.depthScale = range > 0 ? 255 / range : 0;
        if (cell.blockCount > maxElementsInCell) crowded += cell.blockCount;
    }
    if (crowded > maxCrowded * all) return {};
    return std::move(counted.cells);
}

void fill(std::span<const FaceViews> faces, LightBuffer& buffer) {
    constexpr std::uint32_t size = LightBuffer::Block::size;
    const auto blocksFor = [](std::uint32_t elements) { return (elements + size - 1) / size; };
    std::uint32_t blockCount = 0;
    for (LightBuffer::Cell& cell : buffer.cells) {
        cell.firstBlock = blockCount;
        if (cell.blockCount > maxElementsInCell) {
            cell.blockCount = LightBuffer::Cell::crowded;
        } else {
            blockCount += blocksFor(cell.blockCount);
            cell.blockCount = 0; // counted again
        }
    }
    LightBuffer::Block unused{};
    std::fill_n(unused.uLow, size, std::uint8_t{255});
    reserveWhole(buffer.blocks, blockCount);
    buffer.blocks.assign(blockCount, unused);
    forEachCell(faces, buffer, [&](const View& view, LightBuffer::Cell& cell, const Rectangle& part) {
        if (cell.blockCount == LightBuffer::Cell::crowded) return;
        const std::uint32_t i = cell.blockCount % size;
        LightBuffer::Block& block = buffer.blocks[cell.firstBlock + cell.blockCount / size];
        block.uLow[i] = static_cast<std::uint8_t>(part.u.low);
        block.uHigh[i] = static_cast<std::uint8_t>(part.u.high);
        block.vLow[i] = static_cast<std::uint8_t>(part.v.low);
        block.vHigh[i] = static_cast<std::uint8_t>(part.v.high);
        block.depth[i] = cell.depthStep(roundDown(view.depth));
        block.entry[i] = view.entry;
        ++cell.blockCount;
    });
    for (LightBuffer::Cell& cell : buffer.cells)
        if (cell.blockCount != LightBuffer::Cell::crowded) cell.blockCount = blocksFor(cell.blockCount);
}

} // namespace

LightBuffer buildLightBuffer(const Tree& tree, std::span<const Bounds> boxes, Vec3 light, double farthest) {
    LightBuffer buffer;
    buffer.light = light;
    const double reach = farthest * tree.radius;
    if (length(light - tree.centre) > reach || length(tree.centre) > reach) return buffer;
    const std::vector<FaceViews> faces = lookAround(tree, boxes, light);
    if (faces.empty()) return buffer;
    buffer.cells = countContents(faces);
    if (buffer.cells.empty()) return buffer;
    fill(faces, buffer);
    for (const FaceViews& seen : faces) buffer.faces.push_back(seen.face);
    return buffer;
}

} // namespace yarte::trace
