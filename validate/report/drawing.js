// Drawing: a layer in a pane, and on it the regions and the pixels' values.

const smallestPixelWithText = 58;

/** Draws `canvas` into a pane as `view` sees it, inside `clip`. */
function drawLayer(context, canvas, view, pane, clip) {
  context.save();
  context.beginPath();
  context.rect(clip.x, clip.y, clip.width, clip.height);
  context.clip();
  context.imageSmoothingEnabled = view.scale < 1;
  const [x, y] = view.toScreen([0, 0], pane);
  context.drawImage(canvas, x, y, view.width * view.scale, view.height * view.scale);
  context.restore();
}

function drawTag(context, text, x, y, colour = "#0009", ink = "#fff") {
  context.font = "600 12px system-ui, sans-serif";
  context.fillStyle = colour;
  context.beginPath();
  context.roundRect(x, y, context.measureText(text).width + 12, 20, 6);
  context.fill();
  context.fillStyle = ink;
  context.textBaseline = "middle";
  context.fillText(text, x + 6, y + 10.5);
}

/** Outlines with numbers; `reduction` pixels of the picture are one here. */
function drawRegions(context, regions, chosen, view, pane, reduction) {
  regions.forEach((region, i) => {
    const [x0, y0, x1, y1] = region.box.map((v) => v / reduction);
    const [left, top] = view.toScreen([x0, y0], pane), [right, bottom] = view.toScreen([x1, y1], pane);
    for (const [width, colour] of [[i === chosen ? 6 : 4, "#000c"], [i === chosen ? 3 : 1.5, "#ffd21f"]]) {
      context.lineWidth = width;
      context.strokeStyle = colour;
      context.strokeRect(left - 3, top - 3, right - left + 6, bottom - top + 6);
    }
    drawTag(context, String(i + 1), left - 4, top - 25, "#ffd21f", "#1a1500");
  });
}

/** Writes each visible pixel's numbers on it: `lines(x, y)`. `bright(x, y)`: it needs dark ink. */
function drawValues(context, view, pane, lines, bright) {
  if (view.scale < smallestPixelWithText) return;
  context.font = `${Math.min(13, view.scale / 5.2)}px ui-monospace, monospace`;
  context.textBaseline = "middle";
  const [x0, y0, x1, y1] = view.visible(pane);
  for (let y = y0; y < y1; ++y)
    for (let x = x0; x < x1; ++x) {
      const [left, top] = view.toScreen([x, y], pane);
      context.fillStyle = bright(x, y) ? "#000" : "#fff";
      const texts = lines(x, y);
      texts.forEach((text, k) => context.fillText(text, left + 4, top + view.scale * (k + 1) / (texts.length + 1)));
    }
}
