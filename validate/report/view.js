// View: which part of a picture is seen, and how large. Lengths on screen are CSS pixels.

class View {
  constructor(width, height) {
    this.width = width;
    this.height = height;
    this.fit({ width: 1, height: 1 });
  }

  /** The whole picture in a pane; small pictures grow by whole factors, so that their pixels stay equal. */
  fit(pane) {
    const scale = Math.min(pane.width / this.width, pane.height / this.height);
    this.scale = scale > 2 ? Math.floor(scale) : scale;
    this.centre = [this.width / 2, this.height / 2];
  }

  /** A box [x0, y0, x1, y1] with some of its surroundings. */
  show([x0, y0, x1, y1], pane) {
    const margin = 4;
    this.centre = [(x0 + x1) / 2, (y0 + y1) / 2];
    this.setScale(Math.min(pane.width / (x1 - x0 + 2 * margin), pane.height / (y1 - y0 + 2 * margin)));
  }

  setScale(scale) { this.scale = Math.min(Math.max(scale, 1 / 16), 160); }

  /** Keeps the point of the picture under `at`, a place in the pane, where it is. */
  zoom(factor, at, pane) {
    const [x, y] = this.toPicture(at, pane);
    this.setScale(this.scale * factor);
    const [nowX, nowY] = this.toPicture(at, pane);
    this.moveBy(x - nowX, y - nowY);
  }

  moveBy(dx, dy) {
    this.centre = [Math.min(Math.max(this.centre[0] + dx, 0), this.width),
      Math.min(Math.max(this.centre[1] + dy, 0), this.height)];
  }

  toPicture([x, y], pane) {
    return [(x - pane.x - pane.width / 2) / this.scale + this.centre[0],
      (y - pane.y - pane.height / 2) / this.scale + this.centre[1]];
  }

  toScreen([x, y], pane) {
    return [(x - this.centre[0]) * this.scale + pane.x + pane.width / 2,
      (y - this.centre[1]) * this.scale + pane.y + pane.height / 2];
  }

  /** The pixels that a pane shows: [x0, y0, x1, y1), cut to the picture. */
  visible(pane) {
    const [x0, y0] = this.toPicture([pane.x, pane.y], pane);
    const [x1, y1] = this.toPicture([pane.x + pane.width, pane.y + pane.height], pane);
    return [Math.max(0, Math.floor(x0)), Math.max(0, Math.floor(y0)),
      Math.min(this.width, Math.ceil(x1)), Math.min(this.height, Math.ceil(y1))];
  }
}
