// Elements and texts that all parts of the page use.

/** An element with properties and children; strings become text, never markup, null nothing. */
function element(name, properties = {}, ...children) {
  const { data = {}, aria = {}, ...rest } = properties;
  const made = Object.assign(document.createElement(name), rest);
  Object.assign(made.dataset, data);
  for (const [key, value] of Object.entries(aria)) made.setAttribute(key === "role" ? key : "aria-" + key, value);
  made.append(...children.filter((child) => child !== null));
  return made;
}

const unknown = "–";
const steps = 65535; // of a 16-bit file

const seconds = (value) => (value === null ? unknown : value.toFixed(value < 0.1 ? 3 : 2) + " s");
const digits = (value, count) => (value === null ? unknown
  : value !== 0 && value < 1e-3 ? value.toExponential(count - 1) : value.toPrecision(count));
const timesText = (ratio) => (ratio < 100 ? ratio.toPrecision(3) : ratio.toFixed(0));
const place = (at) => (at === null ? "" : ` at (${at[0]},\u00a0${at[1]})`);
const many = (count, what) => `${count} ${what}${count === 1 ? "" : "s"}`;

/** A difference in linear light: a small one in steps of a 16-bit file. */
function lightDifference(value) {
  if (value === null) return unknown;
  return value * steps < 1000 ? (value * steps).toFixed(2) + "/65535" : value.toPrecision(4);
}

/** The reference's time divided by YARTE's; null if one is unknown. */
function speedRatio(c) {
  const yarte = c.yarte.trace_s, povray = c.povray.trace_s;
  return yarte > 0 && povray > 0 ? povray / yarte : null;
}

const ratioText = (c) => (speedRatio(c) === null ? unknown : speedRatio(c).toFixed(1) + "×");

const verdictMark = (c) => element("span", { className: "verdict " + c.verdict }, c.verdict);

/** One line that says why a case is not a pass. */
function shortCause(c) {
  if (c.cause) return c.cause.explanation;
  if (c.regions.length > 0) return c.regions[0].explanation;
  return c.message.split("\n")[0];
}
