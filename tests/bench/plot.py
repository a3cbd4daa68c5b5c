"""Plots as SVG, without any library."""
import html
import math


def bars(title, values):
    """Horizontal bars of positive values by name, the largest on top."""
    rows = sorted(values.items(), key=lambda item: -item[1])
    left, width, height = 150, 500, 24
    largest = max(value for _, value in rows)
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {left + width + 70} {height * len(rows) + 50}" '
             'font-family="sans-serif" font-size="13">',
             '<rect width="100%" height="100%" fill="white"/>',
             f'<text x="10" y="24" font-size="15">{html.escape(title)}</text>']
    for i, (name, value) in enumerate(rows):
        y = 40 + i * height
        lines += [f'<text x="{left - 8}" y="{y + 15}" text-anchor="end">{html.escape(name)}</text>',
                  f'<rect x="{left}" y="{y + 2}" width="{width * value / largest:.1f}" height="{height - 6}" fill="#4472a8"/>',
                  f'<text x="{left + width * value / largest + 6:.1f}" y="{y + 15}">{value:.1f}</text>']
    return "\n".join(lines + ["</svg>"]) + "\n"


COLOURS = ("#4472a8", "#c0504d", "#6a9a3b", "#8064a2", "#d08a2e")


def lines(title, curves):
    """Curves of (x, y) by name, both axes logarithmic with a line at every power of ten."""
    points = [point for curve in curves.values() for point in curve]
    decades = [[math.floor(math.log10(min(values))), math.ceil(math.log10(max(values)))] for values in zip(*points)]
    left, top, unit = 60, 40, 90
    width, height = [unit * (last - first) for first, last in decades]

    def place(x, y):
        return (left + unit * (math.log10(x) - decades[0][0]), top + height - unit * (math.log10(y) - decades[1][0]))

    svg = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {left + width + 190} {top + height + 40}" '
           'font-family="sans-serif" font-size="13">',
           '<rect width="100%" height="100%" fill="white"/>',
           f'<text x="10" y="24" font-size="15">{html.escape(title)}</text>']
    for k in range(decades[0][0], decades[0][1] + 1):
        x, _ = place(10 ** k, 10 ** decades[1][0])
        svg += [f'<line x1="{x:.1f}" y1="{top}" x2="{x:.1f}" y2="{top + height}" stroke="#ddd"/>',
                f'<text x="{x:.1f}" y="{top + height + 20}" text-anchor="middle">{10 ** k:g}</text>']
    for k in range(decades[1][0], decades[1][1] + 1):
        _, y = place(10 ** decades[0][0], 10 ** k)
        svg += [f'<line x1="{left}" y1="{y:.1f}" x2="{left + width}" y2="{y:.1f}" stroke="#ddd"/>',
                f'<text x="{left - 8}" y="{y + 4:.1f}" text-anchor="end">{10 ** k:g}</text>']
    for i, (name, curve) in enumerate(curves.items()):
        colour = COLOURS[i % len(COLOURS)]
        path = " ".join(f"{x:.1f},{y:.1f}" for x, y in (place(*point) for point in curve))
        svg += [f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="2"/>',
                f'<text x="{left + width + 12}" y="{top + 14 + 20 * i}" fill="{colour}">{html.escape(name)}</text>']
    return "\n".join(svg + ["</svg>"]) + "\n"
