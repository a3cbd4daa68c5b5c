// The numbers of one pixel.

/** A difference in steps of a 16-bit file; what the report keeps no digits of is "<1". */
function stepsText(d, unit) {
  if (d === 0) return "<1";
  const inSteps = d * unit;
  return (inSteps > 0 ? "+" : "−") + Math.abs(inSteps).toFixed(Math.abs(inSteps) < 100 ? 2 : 0);
}

function channelsOf(values, index) { return [values[3 * index], values[3 * index + 1], values[3 * index + 2]]; }

/** What is printed on a pixel of the layer `name`. */
function pixelLines(pixels, name, x, y) {
  const index = y * pixels.width + x;
  if (name === "flip") return [(pixels.flip[index] / 255).toFixed(3)];
  if (name === "difference") return channelsOf(pixels.difference, index).map((d) => stepsText(d, pixels.unit));
  return channelsOf(pixels[name], index).map((step) => pixels.light(step).toFixed(5));
}

/** The lines below the viewer about one pixel. */
function readoutText(pixels, labels, x, y) {
  const index = y * pixels.width + x;
  const light = (name) => channelsOf(pixels[name], index).map((step) => pixels.light(step).toFixed(5)).join("  ");
  const width = Math.max(labels.a.length, labels.b.length, 10);
  const where = pixels.reduction === 1 ? `pixel (${x}, ${y})`
    : `mean of ${pixels.reduction}×${pixels.reduction} pixels from (${x * pixels.reduction}, ${y * pixels.reduction})`;
  if (pixels.difference === null) return `${where}\n${labels.b}  ${light("b")}  linear`;
  const difference = channelsOf(pixels.difference, index).map((d) => stepsText(d, pixels.unit)).join("  ");
  return `${where}   FLIP ${(pixels.flip[index] / 255).toFixed(3)}\n` +
    `${labels.a.padEnd(width)}  ${light("a")}  linear\n${labels.b.padEnd(width)}  ${light("b")}\n` +
    `${"difference".padEnd(width)}  ${difference}  /65535`;
}
