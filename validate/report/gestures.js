// Gestures: what pointers and wheels do on a stage.

const dividerReach = 14; // CSS pixels from the slider's line that still hold it

/** Drag moves or, near its line, slides; two fingers and wheels zoom; a double click makes four times as large. */
function listenToPointers(stage) {
  const canvas = stage.canvas, held = new Map(); // places of pointers that are down, by their ids
  let sliding = false;
  const at = (event) => [event.offsetX, event.offsetY];
  const distance = () => {
    const [p, q] = [...held.values()];
    return Math.hypot(p[0] - q[0], p[1] - q[1]);
  };

  function drag(before, event) {
    const now = at(event), apart = held.size === 2 ? distance() : 0;
    held.set(event.pointerId, now);
    if (sliding) stage.slide(now[0] / canvas.clientWidth);
    else if (held.size === 2) stage.zoom(distance() / apart, now);
    else stage.pan(before[0] - now[0], before[1] - now[1]);
  }

  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    held.set(event.pointerId, at(event));
    sliding = look.mode === "wipe" && Math.abs(event.offsetX - look.wipe * canvas.clientWidth) < dividerReach;
  });
  canvas.addEventListener("pointermove", (event) => {
    const before = held.get(event.pointerId);
    if (before) drag(before, event);
    stage.point(at(event));
  });
  for (const name of ["pointerup", "pointercancel"]) canvas.addEventListener(name, (event) => held.delete(event.pointerId));
  canvas.addEventListener("pointerleave", () => stage.point(null));
  canvas.addEventListener("dblclick", (event) => stage.zoom(4, at(event)));
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    stage.zoom(2 ** (-event.deltaY / 240), at(event));
  }, { passive: false });
}
