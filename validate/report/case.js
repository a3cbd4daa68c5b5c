// The page of one case: its viewer, and what is known about it.

function facts(rows) {
  return element("dl", { className: "facts" },
    ...rows.flatMap(([term, value]) => [element("dt", {}, term), element("dd", {}, value)]));
}

function card(title, ...children) {
  return element("section", { className: "card" }, element("h3", {}, title), ...children);
}

function numbers(c) {
  if (c.pixels_over === null) return null;
  const equal = c.max_abs === 0;
  return card("Difference", facts([
    ["largest", lightDifference(c.max_abs) + (equal ? "" : place(c.max_abs_at))],
    [`pixels over ${lightDifference(c.pixels_over.threshold)}`, `${c.pixels_over.count} of ${c.width * c.height}`],
    ["RMSE", digits(c.rmse, 4)],
    ["PSNR", c.psnr === null ? "equal pictures" : c.psnr.toFixed(2) + " dB"],
    ["FLIP mean", c.flip_mean.toFixed(6)],
    ["FLIP largest", c.flip_max.toFixed(6) + (equal ? "" : place(c.flip_max_at))],
    ["exposure", String(c.exposure)]]));
}

function times(c) {
  if (c.yarte.wall_s === null) return null;
  const rows = [["YARTE trace", seconds(c.yarte.trace_s)], ["YARTE in all", seconds(c.yarte.wall_s)]];
  if (c.povray.wall_s !== null)
    rows.push(["POV-Ray parse", seconds(c.povray.parse_s)], ["POV-Ray trace", seconds(c.povray.trace_s)],
      ["POV-Ray in all", seconds(c.povray.wall_s)], ["POV-Ray trace / YARTE trace", ratioText(c)]);
  const notes = [];
  if (c.povray.cached) notes.push("POV-Ray's picture is from the cache; its times are those of the run that made it.");
  if (report.jobs > 1) notes.push(`${report.jobs} cases ran side by side.`);
  return card("Times", facts(rows), notes.length > 0 ? element("p", { className: "faint" }, notes.join(" ")) : null);
}

function conditions(c) {
  if (c.conditions.length === 0) return null;
  const item = (condition) => {
    const made = element("li", {},
      element("span", { className: "verdict " + (condition.holds ? "pass" : "fail") }, condition.holds ? "✓ " : "✗ "), condition.text,
      condition.group ? null : element("small", {}, `measured ${condition.measured.toPrecision(4)}, limit ${condition.limit.toPrecision(4)}` +
        (condition.holds || condition.limit === 0 ? "" : `: ${timesText(condition.measured / condition.limit)} times the limit`)),
      condition.reason ? element("small", {}, condition.reason) : null);
    made.style.setProperty("--depth", condition.depth);
    return made;
  };
  return card(c.tolerance ? `Conditions of ${c.tolerance}` : "Conditions", element("ul", { className: "conditions" }, ...c.conditions.map(item)));
}

function regionList(c, stage) {
  if (c.regions.length === 0) return null;
  const buttons = c.regions.map((region, i) => {
    const made = element("button", { type: "button", aria: { pressed: "false" } }, element("span", { className: "number" }, String(i + 1)),
      element("span", {}, region.explanation),
      element("small", {}, `${many(region.pixels, "pixel")}, at most ${lightDifference(region.max_abs)}${place(region.max_abs_at)}`));
    made.addEventListener("click", () => stage.choose(i));
    return made;
  });
  const draw = stage.onChange;
  stage.onChange = () => {
    draw();
    buttons.forEach((made, i) => made.setAttribute("aria-pressed", String(i === stage.chosen)));
  };
  return card("Regions", element("ol", { className: "regions" }, ...buttons.map((made) => element("li", {}, made))));
}

function commandLines(c) {
  if (c.commands.length === 0) return null;
  return card("To repeat it", element("p", { className: "faint" }, `Run in an empty folder; what these made is in images/${c.name}.`),
    element("ol", { className: "commands" }, ...c.commands.map((command) => element("li", {},
      element("pre", {}, command.line), element("small", {}, `${command.outcome}, ${seconds(command.wall_s)}`)))));
}

function labelsOf(c) {
  const [a = "", b = ""] = c.sides;
  const one = a === "" || b === "" ? a + b : null;
  return { a: one ?? a, b: one ?? b, difference: "difference", flip: "FLIP" };
}

/** The viewer of a case: { stage, parts } or null where there is no picture. */
async function viewer(c, index) {
  if (pages[index].width === 0) return null;
  const pixels = await readPixels(index);
  if (pixels.difference === null) look.mode = "b";
  const stage = new Stage(pixels, c, labelsOf(c));
  const readout = element("output", { className: "readout", id: "readout" });
  stage.onPoint = (x, y) => { readout.textContent = readoutText(pixels, stage.labels, x, y); };
  const notes = [];
  if (pixels.reduction > 1) notes.push(`Shown with squares of ${pixels.reduction}×${pixels.reduction} pixels as one, to keep this page small; their largest difference is kept. The whole pictures are in images/${c.name}.`);
  if (c.max_abs === 0) notes.push("The pictures are equal.");
  const made = element("div", {}, toolbar(stage), stage.element, readout,
    notes.length > 0 ? element("p", { className: "faint" }, notes.join(" ")) : null);
  return { stage, element: made };
}

const present = (...parts) => parts.filter(Boolean);

function caseHead(c, index) {
  const neighbour = (step, text, key) => {
    const other = report.cases[index + step];
    const made = button(text, key, () => { location.hash = caseHash(other); });
    made.id = text.toLowerCase();
    made.disabled = !other;
    return made;
  };
  return element("div", { className: "case-head" },
    element("a", { href: "#", id: "back" }, "All cases"), element("h2", {}, c.name), verdictMark(c),
    element("span", { className: "faint" }, c.source + (c.width ? `, ${c.width}×${c.height}` : "")),
    element("nav", { aria: { label: "Cases" } }, neighbour(-1, "Previous", "p"), neighbour(1, "Next", "n")));
}

/** A case's page: its content, and its stage or null. */
async function casePage(c, index) {
  const shown = await viewer(c, index);
  const side = element("div", { className: "side" },
    ...present(shown && regionList(c, shown.stage), conditions(c), numbers(c), times(c)));
  const content = present(caseHead(c, index),
    c.message && element("pre", { className: "message " + c.verdict }, c.message),
    c.cause && element("p", { className: "common" }, `Cause of all: ${c.cause.explanation}.`),
    element("div", { className: shown ? "columns" : "" }, ...present(shown?.element, side)),
    element("div", { className: "below" }, ...present(commandLines(c))));
  return { content, stage: shown?.stage ?? null };
}
