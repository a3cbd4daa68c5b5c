// Keyboard keys: one table for what they do and for the help.

/** `run(stage)`; those with `stage` need a case that has pictures. */
const keys = [
  { key: "?", text: "this help", run: () => document.getElementById("help").showModal() },
  { key: "t", text: "light, dark, or as the system", run: () => nextTheme() },
  { key: "/", text: "search cases", run: () => document.getElementById("search")?.focus() },
  { key: "n", text: "next case", run: () => document.getElementById("next")?.click() },
  { key: "p", text: "previous case", run: () => document.getElementById("previous")?.click() },
  { key: "Escape", text: "all cases", run: () => document.getElementById("back")?.click() },
  { key: "a", text: "YARTE's picture", stage: true, run: (stage) => stage.setMode("a") },
  { key: "b", text: "the reference", stage: true, run: (stage) => stage.setMode("b") },
  { key: "s", text: "swap", stage: true, run: (stage) => stage.swap() },
  { key: "x", text: "blink", stage: true, run: (stage) => stage.setMode("blink") },
  { key: "w", text: "slider", stage: true, run: (stage) => stage.setMode("wipe") },
  { key: "g", text: "side by side", stage: true, run: (stage) => stage.setMode("side") },
  { key: "d", text: "difference, amplified", stage: true, run: (stage) => stage.setMode("difference") },
  { key: "f", text: "FLIP", stage: true, run: (stage) => stage.setMode("flip") },
  { key: "e", text: "brighter by half a stop", one: true, run: (stage) => changeExposure(stage, 0.5) },
  { key: "q", text: "darker by half a stop", one: true, run: (stage) => changeExposure(stage, -0.5) },
  { key: "r", text: "next region", one: true, run: (stage) => nextRegion(stage) },
  { key: "o", text: "outlines of regions", one: true, run: (stage) => toggleOutlines(stage) },
  { key: "+", text: "larger", one: true, run: (stage) => stage.zoom(2) },
  { key: "-", text: "smaller", one: true, run: (stage) => stage.zoom(1 / 2) },
  { key: "0", text: "whole picture", one: true, run: (stage) => stage.fit() },
  { key: "ArrowLeft", text: "move", one: true, run: (stage) => stage.pan(-60, 0) },
  { key: "ArrowRight", text: "move", one: true, run: (stage) => stage.pan(60, 0) },
  { key: "ArrowUp", text: "move", one: true, run: (stage) => stage.pan(0, -60) },
  { key: "ArrowDown", text: "move", one: true, run: (stage) => stage.pan(0, 60) },
];

function changeExposure(stage, stops) {
  look.stops = Math.min(Math.max(look.stops + stops, -8), 12);
  stage.update();
}

function nextRegion(stage) {
  if (stage.regions.length > 0) stage.choose((stage.chosen + 1) % stage.regions.length);
}

function toggleOutlines(stage) {
  look.outlines = !look.outlines;
  stage.update();
}

/** Runs the key's action if nobody else wants it: not while typing, not with a modifier. */
function handleKey(event, stage) {
  if (event.ctrlKey || event.metaKey || event.altKey || document.getElementById("help").open) return;
  const typing = event.target.matches("input[type=search], select") && event.key !== "Escape";
  const moving = event.key.startsWith("Arrow") && event.target !== stage?.canvas;
  const found = keys.find((each) => each.key === event.key);
  if (!found || typing || moving) return;
  if ((found.stage || found.one) && !stage) return;
  if (found.stage && stage.pixels.difference === null) return;
  event.preventDefault();
  found.run(stage);
}

function fillHelp() {
  const arrows = { ArrowLeft: "←", ArrowRight: "→", ArrowUp: "↑", ArrowDown: "↓", Escape: "Esc" };
  const close = button("Close", "Esc", () => document.getElementById("help").close());
  const rows = new Map(); // keys that do the same share a row
  for (const { key, text } of keys) rows.set(text, [...(rows.get(text) ?? []), arrows[key] ?? key]);
  document.getElementById("help").replaceChildren(
    element("h2", { id: "helpTitle" }, "Keys"),
    element("dl", {}, ...[...rows].flatMap(([text, names]) => [
      element("dt", {}, ...names.map((name) => element("kbd", {}, name))), element("dd", {}, text)])),
    element("p", { className: "faint" }, "On the picture: drag to move, wheel or two fingers to zoom, double click for four times as large. From 58 screen pixels a pixel its values are written on it."),
    close);
}
