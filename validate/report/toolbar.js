// The viewer's controls: buttons and sliders that say and set what `look` holds.

const modes = [
  ["a", "a"], ["b", "b"], ["blink", "x"], ["wipe", "w"], ["side", "g"], ["difference", "d"], ["flip", "f"],
];
const modeNames = { blink: "Blink", wipe: "Slider", side: "Side by side", difference: "Difference", flip: "FLIP" };

const stopsText = (stops) => (stops > 0 ? "+" : "") + stops.toFixed(1).replace(/\.0$/, "") + " EV";
const gainText = (stops) => "×" + (2 ** stops).toLocaleString("en", { maximumFractionDigits: 1 });

function slider(name, properties, text, set) {
  const output = element("output");
  const input = element("input", { type: "range", ...properties });
  input.addEventListener("input", () => set(Number(input.value)));
  return {
    element: element("label", {}, name, input, output),
    show(value, enabled = true) {
      input.value = value;
      input.disabled = !enabled;
      output.textContent = text(value);
    },
  };
}

function button(text, title, action) {
  const made = element("button", { type: "button", title }, text);
  made.addEventListener("click", action);
  return made;
}

/** The toolbar of a stage; it follows the stage's changes. */
function toolbar(stage) {
  const both = stage.pixels.difference !== null;
  const modeButtons = modes.filter(([mode]) => both || mode === "b").map(([mode, key]) => {
    const made = button(stage.labels[mode] && !modeNames[mode] ? stage.labels[mode] : modeNames[mode], `${key}`, () => stage.setMode(mode));
    made.dataset.mode = mode;
    return made;
  });
  const swap = button("Swap", "s", () => stage.swap());
  swap.id = "swap";
  const outlines = button("Outlines", "o", () => {
    look.outlines = !look.outlines;
    stage.update();
  });
  const change = (name) => (value) => {
    look[name] = value;
    stage.update();
  };
  const exposure = slider("Exposure", { id: "exposure", min: -8, max: 12, step: 0.5 }, stopsText, change("stops"));
  const gain = slider("Amplify", { id: "gain", min: 0, max: 16, step: 1 }, gainText, change("gain"));
  const wipe = slider("Slider", { id: "wipe", min: 0, max: 1, step: 0.01 }, (v) => Math.round(100 * v) + " %", change("wipe"));
  const zoom = [button("−", "Smaller (-)", () => stage.zoom(1 / 2)), button("+", "Larger (+)", () => stage.zoom(2)),
    button("Fit", "Whole picture (0)", () => stage.fit())];
  const scale = element("output", { id: "scale", title: "Screen pixels a picture pixel" });
  const group = (label, ...members) => element("div", { className: "group", aria: { role: "group", label } }, ...members);
  const made = element("div", { className: "toolbar", aria: { role: "toolbar", label: "How the pictures are shown" } },
    group("Picture", ...modeButtons, both ? swap : null),
    group("Zoom", ...zoom, scale, stage.regions.length > 0 ? outlines : null),
    group("Levels", exposure.element, both ? gain.element : null, both ? wipe.element : null));
  stage.onChange = () => {
    for (const each of modeButtons) each.setAttribute("aria-pressed", String(each.dataset.mode === look.mode));
    outlines.setAttribute("aria-pressed", String(look.outlines));
    exposure.show(look.stops);
    if (both) gain.show(stage.gain, look.mode === "difference");
    wipe.show(look.wipe, look.mode === "wipe");
    scale.textContent = stage.view.scale >= 1 ? `${stage.view.scale.toFixed(1)}×` : `1/${(1 / stage.view.scale).toFixed(1)}`;
  };
  return made;
}
