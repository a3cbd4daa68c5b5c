"use strict";
// Shows the report: what it says is in #report (the text of report.json), the pictures are in #pictures.

const report = JSON.parse(document.getElementById("report").textContent);
const pictures = JSON.parse(document.getElementById("pictures").textContent);

/** An element with properties and children; strings become text, never markup. */
function element(name, properties, ...children) {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children.filter((child) => child !== null));
  return made;
}

const unknown = "–";
const seconds = (value) => (value === null ? unknown : value.toFixed(value < 0.1 ? 3 : 2) + " s");
const place = (at) => (at === null ? "" : ` at (${at[0]}, ${at[1]})`);
const number = (value, digits) => (value === null ? unknown : value.toPrecision(digits));

/** A difference in linear light: a small one in steps of a 16-bit file. */
function difference(value) {
  if (value === null) return unknown;
  const steps = value * 65535;
  return steps < 1000 ? steps.toFixed(2) + "/65535" : value.toPrecision(4);
}

function ratio(c) {
  const yarte = c.yarte.trace_s, povray = c.povray.trace_s;
  return yarte > 0 && povray > 0 ? (povray / yarte).toFixed(1) + "×" : unknown;
}

function verdict(c) {
  return element("span", { className: "verdict " + c.verdict }, c.verdict);
}

function counts() {
  const parts = ["pass", "fail", "error"].map((verdict) => {
    const count = report.cases.filter((c) => c.verdict === verdict).length;
    return element("span", { className: count > 0 ? "verdict " + verdict : "" }, `${count} ${verdict}`);
  });
  document.getElementById("counts").append(element("span", {}, report.cases.length === 1 ? "1 case" : `${report.cases.length} cases`), ...parts);
  document.getElementById("about").textContent =
    `YARTE ${report.version}. ${report.encoding}. Errors are in linear light, 1 = white.`;
}

function overview() {
  const heads = ["verdict", "case", "size", "max error", "px over", "FLIP mean", "YARTE trace", "POV-Ray trace", "ratio"];
  const row = (c) => {
    const cells = [
      verdict(c), element("a", { href: "#" + c.name }, c.name), c.width ? `${c.width}×${c.height}` : unknown,
      difference(c.max_abs), c.pixels_over === null ? unknown : String(c.pixels_over.count),
      c.flip_mean === null ? unknown : c.flip_mean.toFixed(6),
      seconds(c.yarte.trace_s), seconds(c.povray.trace_s), ratio(c),
    ];
    return element("tr", {}, ...cells.map((cell) => element("td", {}, cell)));
  };
  document.getElementById("overview").append(
    element("thead", {}, element("tr", {}, ...heads.map((head) => element("th", { scope: "col" }, head)))),
    element("tbody", {}, ...report.cases.map(row)));
}

/** The figures of a case; the first two exchange their pictures when one is clicked. */
function figures(c) {
  const made = c.pictures.map((picture) => {
    const image = element("img", { src: pictures[picture.file], alt: `${c.name}: ${picture.label}` });
    const caption = element("figcaption", {}, picture.label);
    if (picture.label === "difference")
      caption.append(": logarithmic, black up to 2⁻¹⁷, brightest from 1; grey within the threshold, red to yellow over it");
    const button = element("button", { type: "button", title: "swap" }, image);
    return { picture, image, caption, button, figure: element("figure", {}, button, caption) };
  });
  const [a, b] = made;
  if (made.length === 3) {
    const swap = () => {
      [a.picture, b.picture] = [b.picture, a.picture];
      for (const side of [a, b]) {
        side.image.src = pictures[side.picture.file];
        side.image.alt = `${c.name}: ${side.picture.label}`;
        side.caption.textContent = side.picture.label;
      }
    };
    for (const side of made) side.button.addEventListener("click", swap);
    document.addEventListener("keydown", (event) => {
      if (event.key === "s" && !event.ctrlKey && !event.metaKey && !event.altKey) swap();
    });
  }
  return element("div", { className: "pictures" }, ...made.map((side) => side.figure));
}

function numbers(c) {
  const rows = [];
  if (c.pixels_over !== null)
    rows.push(
      ["largest error", difference(c.max_abs) + place(c.max_abs_at)],
      [`pixels over ${difference(c.pixels_over.threshold)}`, `${c.pixels_over.count} of ${c.width * c.height}`],
      ["RMSE", number(c.rmse, 4)],
      ["PSNR", c.psnr === null ? "equal pictures" : c.psnr.toFixed(2) + " dB"],
      ["FLIP mean", c.flip_mean.toFixed(6)],
      ["FLIP max", c.flip_max.toFixed(6) + place(c.flip_max_at)]);
  if (c.commands.length > 0)
    rows.push(
      ["exposure", String(c.exposure)],
      ["YARTE trace / wall", `${seconds(c.yarte.trace_s)} / ${seconds(c.yarte.wall_s)}`],
      ["POV-Ray parse / trace / wall",
        `${seconds(c.povray.parse_s)} / ${seconds(c.povray.trace_s)} / ${seconds(c.povray.wall_s)}`],
      ["POV-Ray trace / YARTE trace", ratio(c)]);
  return element("dl", {}, ...rows.map(([term, value]) =>
    element("div", {}, element("dt", {}, term), element("dd", {}, value))));
}

function commands(c) {
  if (c.commands.length === 0) return null;
  const items = c.commands.map((command) => element("li", {},
    element("pre", {}, command.line), element("small", {}, `${command.outcome}, ${seconds(command.wall_s)}`)));
  return element("details", { className: "commands" }, element("summary", {}, "command lines"),
    element("p", { className: "hint" }, `Run in a temporary folder; their files are in images/${c.name}.`),
    element("ol", {}, ...items));
}

function section(c) {
  return element("section", { className: "case", id: c.name },
    element("h2", {}, c.name, verdict(c), element("small", {}, c.source)),
    c.message ? element("pre", { className: "message " + c.verdict }, c.message) : null,
    c.pictures.length > 0 ? figures(c) : null,
    numbers(c),
    commands(c));
}

counts();
overview();
document.getElementById("cases").append(...report.cases.map(section));
