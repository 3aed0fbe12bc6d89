"use strict";
// What the page knows, and the position of the mechanism that it shows: all else follows `show`.
// Nothing is computed here from the laws of mechanics: every number is that of a position that was solved.

const known = JSON.parse(document.getElementById("living").textContent);
const { words, cycle, mechanism } = known;
const root = document.documentElement;
const reduced = matchMedia("(prefers-reduced-motion: reduce)");
root.classList.add("living");

const element = (name, attributes = {}, ...children) =>
  filled(document.createElement(name), attributes, children);
const drawn = (name, attributes = {}, ...children) =>
  filled(document.createElementNS("http://www.w3.org/2000/svg", name), attributes, children);

function filled(one, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") one.addEventListener(name, value);
    else one.setAttribute(name, value);
  }
  one.append(...children);
  return one;
}

const parsed = (svg) => new DOMParser().parseFromString(svg, "image/svg+xml").documentElement;

// New words without a new node: nothing else is laid out anew.
function say(one, said) {
  if (!one.firstChild) one.append("");
  if (one.firstChild.data !== said) one.firstChild.data = said;
}

// Symbols in plain text with their indices below and above: M_bal, R_12^x.
const INDEX = /(_(?:[\p{L}\p{N}]|,(?=[\p{L}\p{N}]))+|\^(?:\([^)\s]*\)|[\p{L}\p{N}]+))/u;
const signed = (said) => said.split(INDEX).map((part, n) => (n % 2 ? element(part[0] === "_" ? "sub" : "sup", {}, part.slice(1)) : part));

const text = (x, digits = 5) => {
  if (x === null || x === undefined) return "–";
  return Number(x.toPrecision(digits)).toString().replace("-", "\u2212").replace(".", known.decimal);
};

// ---- where the mechanism is: `at` degrees turned, between positions `i` and `i + 1`, the share `s` of the way

const where = { at: 0, i: 0, s: 0, whole: 0 }; // `whole`: cycles gone through
const home = cycle ? (cycle.numbered[mechanism?.sample ?? 0] ?? 0) : 0; // where the page begins
const followers = [];
const last = cycle ? cycle.at.length - 1 : 0;
const span = cycle ? cycle.at[last] - cycle.at[0] : 0;

function show(at) {
  if (!cycle) return;
  const start = cycle.at[0];
  if (cycle.closed && (at < start || at > start + span)) where.whole += Math.floor((at - start) / span);
  if (cycle.closed && (at < start || at > start + span)) at = start + ((((at - start) % span) + span) % span);
  at = Math.min(Math.max(at, start), start + span);
  let i = Math.max(0, Math.min(last - 1, cycle.at.findIndex((x) => x > at) - 1));
  if (at >= cycle.at[last]) i = Math.max(0, last - 1);
  let s = last ? (at - cycle.at[i]) / (cycle.at[i + 1] - cycle.at[i]) : 0;
  if ((mechanism && !mechanism.smooth[i]) || s < 1e-6 || s > 1 - 1e-6) s = Math.round(s);
  Object.assign(where, { at: last ? cycle.at[i] + s * (cycle.at[i + 1] - cycle.at[i]) : start, i, s });
  root.dataset.at = where.at;
  for (const follow of followers) follow();
}

// The position in which the mechanism is, -1 between two of them; the numbered one that is nearest.
const position = () => (where.s === 0 ? where.i : where.s === 1 ? where.i + 1 : -1);
function numbered() {
  const away = cycle.numbered.map((i) => Math.abs(cycle.at[i] - where.at));
  return away.indexOf(Math.min(...away));
}

// A number of the results: exact in a position, along the straight line between two of them.
function value(values) {
  const i = position();
  if (i >= 0) return values[i];
  const [a, b] = [values[where.i], values[where.i + 1]];
  return a === null || b === null ? null : a + where.s * (b - a);
}

// The column of a number, by its table and key; of the first table that has it where none is named.
function column(key, table = "") {
  const name = table.replace(/_table$/, "");
  for (const [one, columns] of Object.entries(cycle ? cycle.columns : {})) {
    const found = (!name || one === name) && columns.find((c) => c.key === key);
    if (found) return found;
  }
  return null;
}

const vector = (key) => {
  const [x, y] = [value(cycle.vectors[key][0]), value(cycle.vectors[key][1])];
  return x === null || y === null ? null : [x, y];
};

// The largest size of a vector.
const reach = (key) => Math.max(...cycle.vectors[key][0].map((x, i) => Math.hypot(x, cycle.vectors[key][1][i])));
