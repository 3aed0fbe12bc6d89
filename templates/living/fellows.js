// What shows one quantity belongs together: cells, symbols, vectors and links are lit by one another; a click says how
// the number comes about, by the formulas of the page, or by the sentence of its chapter.

const marked = (from) => from?.closest?.("[data-q], [data-link], [data-point]");

// The links and points that a key names: v_B, R_12, a_BA_t.
function subjects(key) {
  if (!mechanism) return [];
  const names = key.split("_").slice(1);
  const parts = names.flatMap((n) => [n, ...n.split(/[,-]/), ...(n.length === 2 ? [...n] : [])]);
  return parts.filter((n) => n in mechanism.links || n in mechanism.points);
}

function lit(one, on) {
  const { q, link, point } = one.dataset;
  const many = q ? [`[data-q="${CSS.escape(q)}"]`, ...subjects(q).map(named)] : [named(link ?? point)];
  if (link) many.push(`[data-q="omega_${CSS.escape(link)}"]`, `[data-q="w_${CSS.escape(link)}"]`, `[data-q="phi_${CSS.escape(link)}"]`);
  if (point) many.push(...["v", "a", "x", "y"].map((x) => `[data-q="${x}_${CSS.escape(point)}"]`));
  const row = one.dataset.k;
  for (const fellow of document.querySelectorAll(many.join(","))) {
    fellow.classList.toggle("fellow", on);
    if (q && row !== undefined && fellow.dataset.k === row) fellow.classList.toggle("same", on);
  }
}

const named = (name) => `[data-link="${CSS.escape(name)}"],[data-point="${CSS.escape(name)}"]`;

function fellowsLight() {
  let now = null;
  const light = (one) => {
    if (one === now) return;
    if (now) lit(now, false);
    now = one ?? null;
    if (now) lit(now, true);
  };
  addEventListener("pointerover", (event) => light(marked(event.target)));
  addEventListener("focusin", (event) => light(marked(event.target)));
}

// ---- how a number comes about

// A formula as it is told: `marks`, the numbers in it, the last of which it defines; the `head` of its section; `node`,
// where it stands on the page, which one that the page leaves out has not; `copy`, what is shown of it.
const result = (formula) => formula.marks.at(-1);

let formulas = null; // all of them, in the order of the note
let defining = null; // key -> those that define it
function formulasOf() {
  if (formulas) return;
  formulas = [];
  let head = "";
  for (const one of document.querySelectorAll("main :is(h1, h2, h3, h4, .formula, p:has(> math, > nobr))")) {
    if (one.matches("h1, h2, h3, h4")) head = one.textContent;
    else if (one.matches(".formula")) add(one, [one], () => one.querySelector(".math").cloneNode(true), one.querySelector(".number")?.textContent);
    else for (const pieces of inText(one)) add(pieces[0], pieces, () => inLine(pieces.flatMap((piece) => [piece.cloneNode(true), element("wbr")])));
  }
  // those left out, each behind the one that was printed last before it
  const same = (a, b) => a.q === b.q && a.k === b.k && (a.t ?? "") === (b.t ?? "");
  for (const [said, under, of, before] of (texts?.left ?? []).toReversed()) {
    const [behind, ...marks] = [before, ...of].map((ref) => ref && { q: ref[0], k: ref[1] === null ? undefined : String(ref[1]), t: ref[2] });
    let at = behind ? formulas.findLastIndex((f) => f.node && f.marks.length && same(result(f), behind)) + 1 : 0;
    while (at && formulas[at] && !formulas[at].marks.length) at++; // equations, of which what is read off stands behind
    const section = texts.texts[under];
    const own = formulas.find((f) => f.head.endsWith(section))?.head ?? section;
    formulas.splice(at || formulas.length, 0, { head: own, marks, copy: () => inLine(signed(texts.texts[said])) });
  }
  defining = Map.groupBy(formulas.filter((f) => f.marks.length), (f) => result(f).q);
  function add(node, pieces, copy, number = "") {
    const marks = pieces.flatMap((piece) => [...piece.querySelectorAll("[data-q]")].map((x) => ({ ...x.dataset, said: x.textContent })));
    formulas.push({ node, head, number, marks, copy });
  }
}

const inLine = (pieces) => element("div", { class: "math" }, ...pieces);

// Formulas in running text: rows of pieces between which a line may end, with more than a letter and its number.
function* inText(paragraph) {
  let row = [];
  const whole = () => (row.length > 1 && row.at(-1).querySelector("[data-q]") ? [row] : []);
  for (const one of [...paragraph.childNodes, null]) {
    const math = one?.localName === "math" ? one : one?.localName === "nobr" && one.querySelector("math");
    if (math && one.previousSibling?.localName === "wbr") row.push(math);
    else if (one?.localName !== "wbr") yield* whole(), (row = math ? [math] : []);
  }
}

// The formula that defines a quantity: its result is the last number of the formula. Tables by positions, and what is worked
// out for one, tell of the same quantities; a mass of another table is another mass.
const byPositions = (table) => /(_table|_\d+|^contours)$/.test(table);
function formulaOf(key, row, table = "") {
  formulasOf();
  const own = (defining.get(key) ?? []).map((f) => ({ f, k: result(f).k, t: result(f).t ?? "" }));
  const like = own.filter(({ t }) => t === table || (byPositions(t) && byPositions(table)));
  const here = like.filter(({ k }) => k === row);
  return (here.find(({ t }) => t === table) ?? here[0] ?? like[0])?.f;
}

// The formulas that define a quantity: its own, that of the vector or of both its components, that of the opposite reaction.
function definedBy(key, row, table) {
  const [, on, by] = key.match(/^R_(.+),(.+)$/) ?? key.match(/^R_(.)(.)$/) ?? [];
  for (const name of [key, key.replace(/_[xy]$/, ""), on && `R_${by}${key.includes(",") ? "," : ""}${on}`]) {
    const one = name && formulaOf(name, row, table);
    if (one) return [one];
  }
  return ["_x", "_y"].map((c) => formulaOf(key + c, row, table)).filter(Boolean);
}

// What is read off a plan stands upon the equations in front of it, and upon what was worked out for that plan before.
function readOff(formula) {
  if (!formula.marks.some(({ q }) => q.startsWith("mu_"))) return [];
  const before = formulas.slice(0, formulas.indexOf(formula)).filter((f) => f.head === formula.head);
  const drawn = (f) => !f.marks.length;
  const last = before.findLastIndex(drawn);
  const first = before.findLastIndex((f, k) => k < last && !drawn(f));
  const { t } = result(formula);
  return [...before.slice(first + 1, last + 1), ...before.filter((f) => !drawn(f) && result(f).t === t)];
}

// The formulas and those of what stands in them, in the order of the note.
function derivation(key, row, table) {
  const found = new Set();
  const waiting = definedBy(key, row, table);
  while (waiting.length) {
    const formula = waiting.shift();
    if (found.has(formula)) continue;
    found.add(formula);
    for (const { q, k, t } of formula.marks) if (q !== key) waiting.push(...definedBy(q, k, t));
    waiting.push(...readOff(formula));
  }
  return formulas.filter((f) => found.has(f));
}

// The numbers with which formulas begin: those that no formula defines, each once.
function beginnings(leading) {
  const found = new Map();
  for (const formula of leading)
    for (const one of formula.marks)
      if (one.said && one.q !== "pi" && one !== result(formula) && !definedBy(one.q, one.k, one.t).length) found.set(`${one.q} ${one.said}`, one);
  return [...found.values()];
}

let texts = null; // unpacked when the first is asked for; a browser that cannot has the formulas alone
async function tellings() {
  try {
    const bytes = Uint8Array.from(atob(known.told), (c) => c.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
    return JSON.parse(await new Response(stream).text());
  } catch {
    return { texts: [], left: [], ways: {}, meanings: {}, worked: {}, starts: {} };
  }
}

function told(kind, { q, t, k }) {
  const of = texts[kind];
  const n = [of[`${t ?? ""}.${q}`] ?? of[q]].flat();
  return texts.texts[n[k] ?? n[0]] ?? "";
}

// The name of a number in the results; of a cell of a comparison that of the column by positions which it compares.
function nameOf({ q, t, by }) {
  const own = t ? `${t}.${q}` : q;
  if (!by || own in texts.worked || own in texts.starts) return own;
  return [texts.worked, texts.starts].flatMap(Object.keys).find((name) => name.endsWith(`_table.${q}`)) ?? own;
}

// With which numbers the way to a number starts: of a column those of the row, as the page has them.
function starts(name, k) {
  return (texts.starts[name] ?? []).map((from) => {
    if (typeof from !== "string") return from.map((n) => texts.texts[n]);
    const [table, key] = from.split(".");
    const place = table.endsWith("_table") && cycle?.numbered[k];
    const of = place !== false && place !== undefined && column(key, table);
    const cell = document.querySelector(`main td[data-q="${CSS.escape(key)}"][data-k="${CSS.escape(k)}"][data-t="${table}"]`);
    return [told("meanings", { q: key, t: table, k }) || key, of ? `${text(of.values[place])} ${of.unit}` : cell?.textContent ?? ""];
  });
}

const listed = (pairs) => element("ul", {}, ...pairs.map(([sign, number]) => element("li", {}, ...signed(sign), number && ": ", element("b", {}, number))));

async function explain(one) {
  if (!texts) (texts = await tellings()), (formulas = null);
  const { q, k, t } = one.dataset;
  const box = element("dialog", { class: "told" });
  const close = () => box.close();
  box.append(element("button", { type: "button", class: "close", "aria-label": words.close, click: close }, "×"));
  const meaning = told("meanings", one.dataset);
  box.append(element("p", { class: "head" }, ...signed(meaning || q), k === undefined || !one.dataset.t?.endsWith("_table") ? "" : `, ${words.position.toLowerCase()} ${k}`, ": ", element("b", {}, one.textContent)));
  const way = told("ways", one.dataset);
  if (way) box.append(element("p", {}, way));
  const name = nameOf(one.dataset);
  const worked = texts.worked[name] ?? [];
  if (worked.length && name.includes("_table.") && Number(k) !== texts.sample) box.append(element("p", {}, `${words.position} ${texts.sample}:`));
  if (worked.length) box.append(element("p", { class: "worked" }, ...signed(worked.map((n) => texts.texts[n]).join("\n"))));
  const from = starts(name, k);
  if (from.length) box.append(element("p", { class: "section" }, words.starts), listed(from));
  const leading = derivation(q, k, t);
  if (leading.length && k !== undefined && definedBy(q, k, t).every((f) => result(f).k !== k)) box.append(element("p", {}, words.likewise));
  let head = "";
  for (const { node, head: own, number, copy } of leading) {
    if (own !== head) box.append(element("p", { class: "section" }, (head = own)));
    const line = element("div", { class: "formula" }, copy());
    box.append(line);
    if (!node) continue;
    const back = element("a", { href: node.id ? `#${node.id}` : "#", click: close, title: words.formula }, number || "→");
    if (!node.id) back.addEventListener("click", (event) => (event.preventDefault(), node.scrollIntoView({ block: "center" })));
    line.append(back);
  }
  const begins = beginnings(leading);
  const meant = (b) => [told("meanings", b) || b.q, b.said];
  if (begins.length) box.append(element("p", { class: "section" }, words.begins), listed(begins.map(meant)));
  box.append(element("p", { class: "where" }, `results.json: ${name.includes(".") ? "tables" : "values"}.${name}`));
  box.addEventListener("click", (event) => event.target === box && close());
  box.addEventListener("close", () => box.remove());
  document.body.append(box);
  box.showModal();
}

function clicksExplain() {
  const asks = (from) => {
    const one = from.closest("main [data-q]");
    return one && one.dataset.q !== "position" && !from.closest("a, button, svg") ? one : null;
  };
  document.addEventListener("click", (event) => {
    const one = asks(event.target);
    if (one && !getSelection().toString()) explain(one);
  });
  for (const one of document.querySelectorAll("main td[data-q]")) one.tabIndex = one.tabIndex < 0 ? -1 : one.tabIndex;
  document.addEventListener("keydown", (event) => {
    if (event.key === "Enter" && event.target.matches?.("main td[data-q]")) explain(event.target);
    const by = { ArrowUp: [-1, 0], ArrowDown: [1, 0], ArrowLeft: [0, -1], ArrowRight: [0, 1] }[event.key];
    if (by && event.target.matches?.("main td")) goes(event, by);
  });
  // one stop of the tabulator a table, arrows within it
  for (const table of document.querySelectorAll("main table")) {
    const first = table.querySelector("td[data-q]");
    if (first) first.tabIndex = 0;
  }
}

function goes(event, [down, right]) {
  const cell = event.target;
  const to = cell.parentElement.parentElement.rows[cell.parentElement.sectionRowIndex + down]?.cells[cell.cellIndex + right];
  if (!to) return;
  event.preventDefault();
  to.tabIndex = -1;
  to.focus();
}
