// The table of all cases, to filter and to sort.

const severity = { error: 0, fail: 1, pass: 2 };

/** `value` sorts; `cell` is what is shown; missing values come last. */
const columns = [
  { head: "", className: "thumbnail", cell: (c, index) => (pages[index].thumbnail ? element("img", { src: pages[index].thumbnail, alt: "", loading: "lazy" }) : "") },
  { head: "verdict", className: "text verdict-cell", value: (c) => severity[c.verdict], cell: verdictMark },
  { head: "case", className: "text name", value: (c) => c.name, cell: nameCell },
  { head: "size", value: (c) => c.width * c.height, cell: (c) => (c.width ? `${c.width}×${c.height}` : unknown) },
  { head: "max error", className: "short", value: (c) => c.max_abs, cell: (c) => lightDifference(c.max_abs) },
  { head: "px over", className: "short", value: (c) => c.pixels_over?.count ?? null, cell: (c) => (c.pixels_over ? String(c.pixels_over.count) : unknown) },
  { head: "FLIP mean", value: (c) => c.flip_mean, cell: (c) => c.flip_mean?.toFixed(6) ?? unknown },
  { head: "YARTE trace", value: (c) => c.yarte.trace_s, cell: (c) => seconds(c.yarte.trace_s) },
  { head: "POV-Ray trace", value: (c) => c.povray.trace_s, cell: (c) => seconds(c.povray.trace_s) },
  { head: "ratio", value: speedRatio, cell: ratioText },
];

const listing = { text: "", verdicts: new Set(["pass", "fail", "error"]), column: 1, descending: false };

const caseHash = (c) => "#/" + encodeURIComponent(c.name);

function nameCell(c) {
  const cause = c.verdict === "pass" ? "" : shortCause(c);
  return element("div", {}, element("a", { href: caseHash(c) }, c.name), cause ? element("span", { className: "cause" }, cause) : null);
}

function compareBy(column, descending) {
  return ([p], [q]) => {
    const [a, b] = [column.value(p), column.value(q)];
    if (a === null || b === null) return (a === null) - (b === null);
    const order = typeof a === "string" ? a.localeCompare(b, "en") : a - b;
    return descending ? -order : order;
  };
}

/** [case, index] of what the filters leave, in order. */
function listed() {
  const found = report.cases.map((c, index) => [c, index]).filter(([c]) => listing.verdicts.has(c.verdict) &&
    `${c.name} ${c.source} ${shortCause(c)}`.toLowerCase().includes(listing.text.toLowerCase()));
  return found.sort(compareBy(columns[listing.column], listing.descending));
}

function tableBody() {
  const rows = listed().map(([c, index]) => element("tr", { data: { verdict: c.verdict } },
    ...columns.map((column) => element("td", { className: column.className ?? "", data: { label: column.head } }, column.cell(c, index)))));
  return rows.length > 0 ? rows : [element("tr", {}, element("td", { className: "nothing name", colSpan: columns.length }, "No case is like that."))];
}

function headCell(column, index, sortBy) {
  const cell = element("th", { scope: "col", className: column.className ?? "" });
  if (!column.value) return cell;
  if (index === listing.column) cell.setAttribute("aria-sort", listing.descending ? "descending" : "ascending");
  cell.append(button(column.head, "Sort", () => sortBy(index)));
  return cell;
}

function filters(refresh, sortBy) {
  const search = element("input", { type: "search", id: "search", placeholder: "Search cases (/)", value: listing.text, aria: { label: "Search cases" } });
  search.addEventListener("input", () => {
    listing.text = search.value;
    refresh();
  });
  const toggles = ["fail", "error", "pass"].map((verdict) => {
    const count = report.cases.filter((c) => c.verdict === verdict).length;
    const made = element("button", { type: "button", data: { verdict }, aria: { pressed: String(listing.verdicts.has(verdict)) } }, `${count} ${verdict}`);
    made.addEventListener("click", () => {
      if (!listing.verdicts.delete(verdict)) listing.verdicts.add(verdict);
      made.setAttribute("aria-pressed", String(listing.verdicts.has(verdict)));
      refresh();
    });
    return made;
  });
  const order = element("select", { id: "order" }, ...columns.map((column, i) => (column.value ? element("option", { value: i, selected: i === listing.column }, column.head) : null)));
  order.addEventListener("change", () => sortBy(Number(order.value)));
  return element("div", { className: "filters" }, search, ...toggles, element("label", { className: "sort faint" }, "Sort by", order));
}

/** The elements of the table's page. */
function overview() {
  const head = element("thead"), body = element("tbody");
  const refresh = () => {
    head.replaceChildren(element("tr", {}, ...columns.map((column, i) => headCell(column, i, sortBy))));
    body.replaceChildren(...tableBody());
  };
  const sortBy = (index) => {
    listing.descending = index === listing.column && !listing.descending;
    listing.column = index;
    refresh();
  };
  refresh();
  const about = [`YARTE ${report.version} compared with ${report.reference}.`, `${report.encoding}.`, "Errors are in linear light, 1 = white."];
  if (report.jobs > 1) about.push(`${report.jobs} cases ran side by side: times are those of a shared machine.`);
  return [
    element("p", { className: "counts", id: "counts" }, element("span", {}, many(report.cases.length, "case")),
      ...["pass", "fail", "error"].map((verdict) => {
        const count = report.cases.filter((c) => c.verdict === verdict).length;
        return element("span", { className: count > 0 ? "verdict " + verdict : "faint" }, `${count} ${verdict}`);
      })),
    element("p", { className: "faint", id: "about" }, about.join(" ")),
    filters(refresh, sortBy),
    element("div", { className: "card scroll" }, element("table", { id: "overview", aria: { label: "Cases" } }, head, body)),
  ];
}
