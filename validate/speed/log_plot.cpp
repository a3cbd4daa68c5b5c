#include "validate/speed/log_plot.h"

#include "validate/report_page.h" // made by CMake of the files in validate/report
#include "validate/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace yarte::validate {

namespace {

constexpr double width = 640, height = 420, left = 74, right = 18, top = 64, bottom = 56;

bool canBeDrawn(double value) { return value > 0 && std::isfinite(value); }
bool canBeDrawn(const PlotPoint& point) { return canBeDrawn(point.x) && canBeDrawn(point.y); }

std::string superscript(int number) {
    constexpr std::array digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = number < 0 ? "⁻" : "";
    for (const char c : fmt::to_string(std::abs(number))) text += digits[static_cast<std::size_t>(c - '0')];
    return text;
}

/// factor times 10^power, the factor being 1, 2 or 5.
std::string tickText(int factor, int power) {
    if (power >= -3 && power <= 3) return fmt::format("{:g}", factor * std::pow(10.0, power));
    return factor == 1 ? "10" + superscript(power) : fmt::format("{}·10{}", factor, superscript(power));
}

struct Tick {
    double value;
    std::string label; ///< empty: a fine line
};

/// One of the axes: where its numbers lie between two places in the picture.
class Axis {
public:
    Axis(double begin, double end) : begin_(begin), end_(end) {}

    void include(double value) {
        least_ = std::min(least_, std::log10(value));
        most_ = std::max(most_, std::log10(value));
    }
    bool isEmpty() const { return least_ > most_; }
    /// Some room around what is drawn, and never less than half a decade.
    void widen() {
        const double room = std::max(0.07 * (most_ - least_), (0.5 - (most_ - least_)) / 2);
        least_ -= room, most_ += room;
    }
    double place(double value) const {
        return begin_ + (end_ - begin_) * (std::log10(value) - least_) / (most_ - least_);
    }
    std::vector<Tick> ticks() const {
        std::vector<Tick> result;
        const bool isWide = most_ - least_ > 2.2, isVeryWide = most_ - least_ > 7;
        for (int power = static_cast<int>(std::floor(least_)); power <= most_; ++power)
            for (int factor = 1; factor < 10; ++factor) {
                const double value = factor * std::pow(10.0, power), at = std::log10(value);
                if (at < least_ || at > most_ || (isVeryWide && factor > 1)) continue;
                const bool named =
                    isVeryWide ? power % 2 == 0 : factor == 1 || (!isWide && (factor == 2 || factor == 5));
                result.push_back({value, named ? tickText(factor, power) : ""});
            }
        return result;
    }

private:
    double begin_, end_;
    double least_ = std::numeric_limits<double>::infinity(), most_ = -least_;
};

constexpr std::size_t markerCount = 4;

/// A shape for each curve: colours alone are not for all eyes.
std::string marker(std::size_t curve, double x, double y) {
    switch (curve % markerCount) {
    case 0: return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4.5\"", x, y);
    case 1: return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"8\" height=\"8\"", x - 4, y - 4);
    case 2: return fmt::format("<path d=\"M{:.1f} {:.1f}l5.5 9.5h-11z\"", x, y - 5.5);
    default: return fmt::format("<path d=\"M{:.1f} {:.1f}l5.5 5.5-5.5 5.5-5.5-5.5z\"", x, y - 5.5);
    }
}

std::string gridText(const Axis& x, const Axis& y) {
    std::string text;
    for (const auto& [value, label] : x.ticks()) {
        const double at = x.place(value);
        text += fmt::format("<line class=\"{}\" x1=\"{:.1f}\" y1=\"{}\" x2=\"{:.1f}\" y2=\"{}\"/>\n",
                            label.empty() ? "fine" : "grid", at, top, at, height - bottom);
        if (!label.empty())
            text +=
                fmt::format("<text class=\"tick\" x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n",
                            at, height - bottom + 18, label);
    }
    for (const auto& [value, label] : y.ticks()) {
        const double at = y.place(value);
        text += fmt::format("<line class=\"{}\" x1=\"{}\" y1=\"{:.1f}\" x2=\"{}\" y2=\"{:.1f}\"/>\n",
                            label.empty() ? "fine" : "grid", left, at, width - right, at);
        if (!label.empty())
            text += fmt::format("<text class=\"tick\" x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>\n",
                                left - 8, at + 4, label);
    }
    return text;
}

/// About as wide as the text is drawn.
double widthOf(std::string_view text) { return 7.2 * static_cast<double>(text.size()); }

/// Beside points, where there is room: a label that would cover another is left out, and the point's tip
/// tells.
class Labels {
public:
    /// Above the point to its right, or below it to its left; away from the frame.
    std::string put(double x, double y, bool above, std::string_view text) {
        const double wide = widthOf(text);
        const bool rightwards = above ? x + 7 + wide < width - right : x - 7 - wide < left;
        const Box box{rightwards ? x + 7 : x - 7 - wide, y + (above ? -6 : 14), wide};
        for (const Box& other : placed_)
            if (std::abs(box.y - other.y) < 12 && box.x < other.x + other.wide && other.x < box.x + box.wide)
                return {};
        placed_.push_back(box);
        return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n",
                           x + (rightwards ? 7 : -7), box.y, rightwards ? "start" : "end", markupText(text));
    }

private:
    struct Box {
        double x, y, wide;
    };
    std::vector<Box> placed_;
};

/// Labels of one curve stand above its points, of the next below: neighbours share most of their places.
std::string curveText(const PlotCurve& curve, std::size_t number, const Axis& x, const Axis& y,
                      Labels& labels) {
    constexpr std::array ends{"</circle>", "</rect>", "</path>", "</path>"};
    std::string line, marks;
    for (const PlotPoint& point : curve.points) {
        if (!canBeDrawn(point)) continue;
        const double px = x.place(point.x), py = y.place(point.y);
        line += fmt::format("{}{:.1f},{:.1f}", line.empty() ? "" : " ", px, py);
        marks += fmt::format("{}><title>{}</title>{}\n", marker(number, px, py), markupText(point.tip),
                             ends[number % markerCount]);
        if (!point.label.empty()) marks += labels.put(px, py, number % 2 == 0, point.label);
    }
    return fmt::format("<g class=\"curve c{}\">\n<polyline points=\"{}\"/>\n{}</g>\n", number % markerCount,
                       line, marks);
}

/// In a row below the title.
std::string legendText(const LogPlot& plot) {
    std::string text;
    double x = left + 6;
    for (std::size_t i = 0; i < plot.curves.size(); ++i) {
        const std::string& name = plot.curves[i].name;
        if (plot.curves[i].points.empty()) continue;
        text += fmt::format("<g class=\"curve c{}\">{}/><text x=\"{:.1f}\" y=\"{}\">{}</text></g>\n",
                            i % markerCount, marker(i, x, top - 19), x + 10, top - 14.5, markupText(name));
        x += widthOf(name) + 30;
    }
    return text;
}

std::string markText(const PlotMark& mark, const Axis& x) {
    const double at = x.place(mark.x);
    return fmt::format("<line class=\"mark\" x1=\"{0:.1f}\" y1=\"{1}\" x2=\"{0:.1f}\" y2=\"{2}\"/>\n"
                       "<text class=\"tick\" x=\"{3:.1f}\" y=\"{4}\">{5}</text>\n",
                       at, top, height - bottom, at + 6, height - bottom - 8, markupText(mark.label));
}

} // namespace

std::string svg(const LogPlot& plot) {
    Axis x(left, width - right), y(height - bottom, top);
    for (const PlotCurve& curve : plot.curves)
        for (const PlotPoint& point : curve.points)
            if (canBeDrawn(point)) x.include(point.x), y.include(point.y);
    if (x.isEmpty()) return {};
    for (const PlotMark& mark : plot.marks)
        if (canBeDrawn(mark.x)) x.include(mark.x);
    x.widen(), y.widen();
    std::string text = fmt::format(
        "<svg class=\"plot\" xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" role=\"img\" "
        "aria-label=\"{}\">\n<text class=\"title\" x=\"{}\" y=\"24\">{}</text>\n",
        width, height, markupText(plot.title), left, markupText(plot.title));
    text += gridText(x, y);
    text += fmt::format("<rect class=\"frame\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n", left, top,
                        width - left - right, height - top - bottom);
    text += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n",
                        (left + width - right) / 2, height - 14, markupText(plot.xLabel));
    text += fmt::format("<text transform=\"translate(18 {}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
                        (top + height - bottom) / 2, markupText(plot.yLabel));
    for (const PlotMark& mark : plot.marks)
        if (canBeDrawn(mark.x)) text += markText(mark, x);
    Labels labels;
    for (std::size_t i = 0; i < plot.curves.size(); ++i)
        if (!plot.curves[i].points.empty()) text += curveText(plot.curves[i], i, x, y, labels);
    return text + legendText(plot) + "</svg>\n";
}

std::string svgFile(const LogPlot& plot) {
    std::string text = svg(plot);
    if (text.empty()) return text;
    return text.insert(text.find('>') + 1, fmt::format("\n<style>\n{}</style>", page::plot));
}

} // namespace yarte::validate
