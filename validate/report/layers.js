// Layers: pictures of a case as the eye sees them, each a canvas with one pixel per pixel, and its bytes.

function srgb(linear) {
  const v = Math.min(Math.max(linear, 0), 1);
  return v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055;
}

/** Colours from dark to light that grow evenly for the eye ("magma" of Matplotlib, its values at eighths). */
const heatColours = ["000004", "1d1147", "51127c", "822681", "b63679", "e65164", "fb8861", "fec287", "fcfdbf"]
  .map((hex) => [0, 2, 4].map((at) => parseInt(hex.slice(at, at + 2), 16)));

function heat(value) {
  const at = Math.min(Math.max(value, 0), 1) * (heatColours.length - 1);
  const low = Math.min(Math.floor(at), heatColours.length - 2);
  return heatColours[low].map((v, k) => v + (at - low) * (heatColours[low + 1][k] - v));
}

/** { canvas, bytes }; `paint(bytes)` fills RGBA bytes. */
function layer(pixels, paint) {
  const canvas = element("canvas", { width: pixels.width, height: pixels.height });
  const image = new ImageData(pixels.width, pixels.height);
  paint(image.data);
  canvas.getContext("2d").putImageData(image, 0, 0);
  return { canvas, bytes: image.data };
}

function rgbLayer(pixels, values, byteOf) {
  return layer(pixels, (bytes) => {
    for (let from = 0, to = 0; from < values.length; to += 4) {
      for (let k = 0; k < 3; ++k) bytes[to + k] = byteOf(values[from++]);
      bytes[to + 3] = 255;
    }
  });
}

/** A picture with its light times 2^stops, sRGB encoded. */
function pictureLayer(pixels, values, stops) {
  const table = new Uint8ClampedArray(steps + 1);
  for (let step = 0; step <= steps; ++step) table[step] = Math.round(255 * srgb(pixels.light(step) * 2 ** stops));
  return rgbLayer(pixels, values, (step) => table[Math.min(Math.max(Math.round(step), 0), steps)]);
}

/** |a - b| times 2^stops, as brightness of each channel. */
function differenceLayer(pixels, stops) {
  const factor = 255 * pixels.unit * 2 ** stops / steps;
  return rgbLayer(pixels, pixels.difference, (d) => Math.min(255, Math.round(Math.abs(d) * factor)));
}

function flipLayer(pixels) {
  const table = Array.from({ length: 256 }, (_, value) => heat(value / 255).map(Math.round));
  return layer(pixels, (bytes) => pixels.flip.forEach((value, i) => bytes.set([...table[value], 255], 4 * i)));
}

/** The amplification, in stops, that brings the largest difference just to white. */
function naturalGain(pixels) {
  let largest = 0;
  for (const d of pixels.difference) largest = Math.max(largest, Math.abs(d));
  return largest === 0 ? 0 : Math.max(0, Math.floor(Math.log2(steps / (largest * pixels.unit))));
}
