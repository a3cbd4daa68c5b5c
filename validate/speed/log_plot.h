// Work-precision diagrams: curves over two logarithmic axes, as SVG.
#pragma once

#include <string>
#include <vector>

namespace yarte::validate {

struct PlotPoint {
    double x = 0, y = 0;
    std::string label; ///< beside the point; may be empty
    std::string tip;   ///< shown when it is pointed at
};

struct PlotCurve {
    std::string name;
    std::vector<PlotPoint> points; ///< none: the curve's colour is left for it, and it is not named
};

/// A line across the diagram, for what has no place on its axes.
struct PlotMark {
    double x = 0;
    std::string label;
};

struct LogPlot {
    std::string title, xLabel, yLabel;
    std::vector<PlotCurve> curves;
    std::vector<PlotMark> marks{};
};

/// An svg element. Points that are not above 0 have no logarithm and are left out; empty if none is left.
/// Its colours are those of plot.css, which the page holds.
std::string svg(const LogPlot&);

/// The same as a file of its own, light or dark as the viewer is.
std::string svgFile(const LogPlot&);

} // namespace yarte::validate
