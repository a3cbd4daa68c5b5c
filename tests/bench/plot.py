"""Plots as SVG, without any library."""
import html


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
