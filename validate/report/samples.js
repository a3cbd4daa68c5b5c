// Unpacks the pictures that validate/samples.cpp packed: base64 of a zlib stream of residuals.

async function inflated(base64) {
  const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** Undoes pack(): width*height*channels integers. */
async function unpacked(base64, width, height, channels) {
  const planes = await inflated(base64);
  const count = width * height * channels, row = width * channels;
  const values = new Int32Array(count);
  for (let i = 0; i < count; ++i) {
    const code = planes[i] | (planes[count + i] << 8) | (planes[2 * count + i] << 16);
    const left = i % row >= channels, above = i >= row;
    const predicted = (left ? values[i - channels] : 0) + (above ? values[i - row] : 0) -
      (left && above ? values[i - row - channels] : 0);
    values[i] = predicted + (code & 1 ? -((code + 1) >> 1) : code >> 1);
  }
  return values;
}

/**
 * The pictures of a case, unpacked when they are first looked at. Values are in steps: light is
 * offset + unit * value / 65535. `difference` (a - b, in steps) and `flip` (0 ... 255) are null if there is one picture.
 */
async function readPixels(index) {
  const page = pages[index];
  const [reference, difference, flip] = document.getElementById("pixels-" + index).textContent.trim().split(" ");
  const b = await unpacked(reference, page.width, page.height, 3);
  const light = (step) => page.offset + page.unit * step / steps;
  const result = { ...page, a: b, b, difference: null, flip: null, light };
  if (difference === undefined) return result;
  result.difference = Float32Array.from(await unpacked(difference, page.width, page.height, 3), (parts) => parts / 4);
  result.a = Float32Array.from(b, (step, i) => step + result.difference[i]);
  result.flip = await unpacked(flip, page.width, page.height, 1);
  return result;
}
