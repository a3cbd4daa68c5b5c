// Stage: the canvas of a case. It draws what `look` asks for and turns pointers and keys into movement.

/** How pictures are shown; kept from case to case. `gain` null: as much as the case's largest difference allows. */
const look = { mode: "a", stops: 0, gain: null, wipe: 0.5, exchanged: false, outlines: true };

const blinkMilliseconds = 600;

class Stage {
  constructor(pixels, c, labels) {
    Object.assign(this, { pixels, labels, regions: c.regions, chosen: -1, pointer: null, blinkOn: false, layers: new Map() });
    this.view = new View(pixels.width, pixels.height);
    this.canvas = element("canvas", { tabIndex: 0, aria: { role: "img", label: `Pictures of ${c.name}` } });
    this.element = element("div", { className: "stage" }, this.canvas);
    this.onPoint = () => {};
    this.onChange = () => {};
    this.moved = false;
    this.observer = new ResizeObserver(() => this.resize());
    this.observer.observe(this.element);
    this.timer = setInterval(() => this.blink(), blinkMilliseconds);
    listenToPointers(this);
  }

  close() {
    this.observer.disconnect();
    clearInterval(this.timer);
  }

  get gain() { return look.gain ?? (this.natural ??= naturalGain(this.pixels)); }

  /** The layer of a name, painted again only if what it depends on changed. */
  layer(name) {
    const setting = name === "difference" ? this.gain : name === "flip" ? 0 : look.stops;
    const kept = this.layers.get(name);
    if (kept?.setting === setting) return kept;
    const made = name === "difference" ? differenceLayer(this.pixels, setting)
      : name === "flip" ? flipLayer(this.pixels) : pictureLayer(this.pixels, this.pixels[name], setting);
    this.layers.set(name, { setting, ...made });
    return this.layers.get(name);
  }

  /** What is seen where: parts of the canvas, each a layer in a pane. */
  parts() {
    const whole = { x: 0, y: 0, width: this.canvas.clientWidth, height: this.canvas.clientHeight };
    const [first, second] = look.exchanged ? ["b", "a"] : ["a", "b"];
    const half = (at, start, end) => ({ ...whole, x: start, width: end - start });
    if (look.mode === "side") {
      const middle = whole.width / 2;
      return [first, second].map((name, i) => {
        const pane = half(0, i * middle, (i + 1) * middle);
        return { name, pane, clip: pane };
      });
    }
    if (look.mode === "wipe") {
      const at = whole.width * look.wipe;
      return [{ name: first, pane: whole, clip: half(0, 0, at) }, { name: second, pane: whole, clip: half(0, at, whole.width) }];
    }
    const name = look.mode === "blink" ? (this.blinkOn ? second : first) : look.mode;
    return [{ name, pane: whole, clip: whole }];
  }

  pane() { return this.parts()[0].pane; }

  resize() {
    const ratio = window.devicePixelRatio || 1;
    this.canvas.width = Math.round(this.canvas.clientWidth * ratio);
    this.canvas.height = Math.round(this.canvas.clientHeight * ratio);
    if (!this.moved) this.view.fit(this.pane());
    this.update();
  }

  draw() {
    if (this.canvas.clientWidth === 0) return;
    const context = this.canvas.getContext("2d"), ratio = window.devicePixelRatio || 1;
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, this.canvas.clientWidth, this.canvas.clientHeight);
    for (const { name, pane, clip } of this.parts()) {
      drawLayer(context, this.layer(name).canvas, this.view, pane, clip);
      context.save();
      context.beginPath();
      context.rect(clip.x, clip.y, clip.width, clip.height);
      context.clip();
      drawValues(context, this.view, pane, (x, y) => pixelLines(this.pixels, name, x, y), (x, y) => this.isBright(name, x, y));
      if (look.outlines) drawRegions(context, this.regions, this.chosen, this.view, pane, this.pixels.reduction);
      context.restore();
    }
    this.drawLabels(context);
  }

  drawLabels(context) {
    const parts = this.parts();
    for (const { name, clip } of parts)
      if (clip.width > 60) drawTag(context, this.labels[name], clip.x + 8, clip.y + 8);
    if (parts.length === 1) return;
    context.fillStyle = "#fff";
    context.fillRect(parts[1].clip.x - 1, 0, 2, this.canvas.clientHeight);
  }

  isBright(name, x, y) {
    const at = 4 * (y * this.pixels.width + x);
    const [r, g, b] = this.layer(name).bytes.subarray(at, at + 3);
    return 0.3 * r + 0.6 * g + 0.1 * b > 140;
  }

  /** Draws again after `look` or the view changed. */
  update() {
    this.draw();
    this.onChange();
    this.tell();
  }

  blink() {
    if (look.mode !== "blink") return;
    this.blinkOn = !this.blinkOn;
    this.draw();
  }

  setMode(mode) {
    const wasSide = look.mode === "side";
    look.mode = mode;
    if (!this.moved && (mode === "side") !== wasSide) this.view.fit(this.pane());
    this.update();
  }

  /** The other picture, or the two exchanged where both are seen. */
  swap() {
    if (look.mode === "a" || look.mode === "b") look.mode = look.mode === "a" ? "b" : "a";
    else if (look.mode === "side" || look.mode === "wipe") look.exchanged = !look.exchanged;
    else look.mode = "a";
    this.update();
  }

  fit() {
    this.moved = false;
    this.view.fit(this.pane());
    this.update();
  }

  zoom(factor, at = null) {
    const pane = at ? this.partAt(at).pane : this.pane();
    this.moved = true;
    this.view.zoom(factor, at ?? [pane.x + pane.width / 2, pane.y + pane.height / 2], pane);
    this.update();
  }

  pan(dx, dy) {
    this.moved = true;
    this.view.moveBy(dx / this.view.scale, dy / this.view.scale);
    this.update();
  }

  slide(part) {
    look.wipe = Math.min(Math.max(part, 0), 1);
    this.update();
  }

  choose(index) {
    this.chosen = index;
    this.moved = true;
    this.view.show(this.regions[index].box.map((v) => v / this.pixels.reduction), this.pane());
    this.pointer = this.regions[index].max_abs_at.map((v) => Math.floor(v / this.pixels.reduction));
    this.update();
  }

  /** Says which pixel the readout is about: the one under the pointer, else the one in the middle. */
  tell() {
    const [x, y] = this.pointer ?? this.view.centre.map(Math.floor);
    this.onPoint(Math.min(Math.max(x, 0), this.pixels.width - 1), Math.min(Math.max(y, 0), this.pixels.height - 1));
  }

  partAt([x]) { return this.parts().find(({ clip }) => x < clip.x + clip.width) ?? this.parts()[0]; }

  /** The pointer is at a place of the canvas, or away (null). */
  point(at) {
    this.pointer = at && this.pixelAt(at);
    this.tell();
  }

  /** The pixel seen at a place, or null beside the picture. */
  pixelAt(at) {
    const [x, y] = this.view.toPicture(at, this.partAt(at).pane).map(Math.floor);
    const inside = x >= 0 && y >= 0 && x < this.pixels.width && y < this.pixels.height;
    return inside ? [x, y] : null;
  }
}
