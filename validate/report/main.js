// The page's start: what it says is in #report (the text of report.json), what it shows in #pages and #pixels-N.

const report = JSON.parse(document.getElementById("report").textContent);
const pages = JSON.parse(document.getElementById("pages").textContent);
const main = document.getElementById("main");
let stage = null, visits = 0;

/** The case whose name is in the fragment ("#/paper"), or the table. */
async function route() {
  if (location.hash === "#main") return;
  const visit = ++visits;
  const index = report.cases.findIndex((c) => caseHash(c) === location.hash);
  const shown = index < 0 ? { content: overview(), stage: null } : await casePage(report.cases[index], index);
  if (visit !== visits) {
    shown.stage?.close(); // the user has gone on while pictures were unpacked
    return;
  }
  stage?.close();
  stage = shown.stage;
  main.replaceChildren(...shown.content);
  stage?.update();
  document.title = index < 0 ? "YARTE validation" : `${report.cases[index].name}: YARTE validation`;
  window.scrollTo(0, 0);
  document.documentElement.dataset.shown = location.hash || "#";
}

const themes = { "": "Theme: system", light: "Theme: light", dark: "Theme: dark" };

function showTheme() {
  document.getElementById("theme").textContent = themes[document.documentElement.dataset.theme ?? ""];
}

function nextTheme() {
  const names = Object.keys(themes);
  const next = names[(names.indexOf(document.documentElement.dataset.theme ?? "") + 1) % names.length];
  if (next) document.documentElement.dataset.theme = next;
  else delete document.documentElement.dataset.theme;
  showTheme();
}

document.getElementById("theme").addEventListener("click", nextTheme);
document.getElementById("helpButton").addEventListener("click", () => document.getElementById("help").showModal());
document.addEventListener("keydown", (event) => handleKey(event, stage));
window.addEventListener("hashchange", route);
showTheme();
fillHelp();
route();
