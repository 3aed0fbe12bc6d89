// Figures of the note that follow the position: plans and force polygons, cursors along the diagrams.
// In print and where they were constructed they are as the note has them.

const originals = new Map(); // attribute by attribute, to be put back

function change(one, name, to) {
  if (!originals.has(one)) originals.set(one, {});
  const kept = originals.get(one);
  if (!(name in kept)) kept[name] = one.getAttribute(name);
  if (one.getAttribute(name) !== String(to)) one.setAttribute(name, to); // what stays costs no layout
}

function restore(within) {
  for (const [one, kept] of originals) {
    if (!within.contains(one)) continue;
    for (const [name, was] of Object.entries(kept)) was === null ? one.removeAttribute(name) : one.setAttribute(name, was);
    originals.delete(one);
  }
}

// What stands over a figure that shows another position than that of its caption: the angle, and behind it a number.
function says(figure, told, sign = "", rest = "") {
  let one = figure.querySelector(":scope > .over");
  if (!one) {
    one = figure.appendChild(element("span", { class: "over" }, element("span"), ...signed(sign), element("span")));
  }
  one.hidden = !told;
  say(one.firstChild, told), say(one.lastChild, rest);
}

const numbers = (d) => d.match(/-?[\d.]+(?:e-?\d+)?/g).map(Number);

function livePlan(figure, plan) {
  const svg = figure.querySelector("svg");
  const all = svg.querySelector("g");
  const arrows = [...all.querySelectorAll("g[data-q]")];
  // one that has no length where the plan was constructed is not drawn there
  const missing = (key) => {
    const look = { visibility: "hidden", color: "#000", class: "layer" };
    const one = drawn("g", { "data-q": key, ...look }, drawn("path", { class: "shaft" }), drawn("path", { class: "head" }));
    all.append(one);
    return one;
  };
  const free = plan.arrows.map(([key, from, to]) => {
    const k = arrows.findIndex((a) => a.dataset.q === key);
    return { from, to, one: k < 0 ? missing(key) : arrows.splice(k, 1)[0] };
  });
  const ends = ({ from, to }) => [plan.at[from], plan.at[to]];
  // what is lettered: a vertex, or the vector whose middle is nearest
  const anchored = (x, y) => {
    const spots = [
      ...plan.at.map(([u, v], n) => ({ far: Math.hypot(u - x, -v - y), of: [n, n] })),
      ...free.map((a) => {
        const [[u, v], [p, q]] = ends(a);
        const shares = [0.25, 0.42, 0.58, 0.75].map((s) => Math.hypot(u + s * (p - u) - x, -(v + s * (q - v)) - y));
        return { far: Math.min(...shares), of: [a.from, a.to] };
      }),
    ];
    return spots.reduce((a, b) => (b.far < a.far ? b : a)).of;
  };
  const others = [...all.children].filter((one) => one.localName === "path");
  const marks = [...all.querySelectorAll("text, circle")].map((one) => {
    const [x, y] = ["x", "y"].map((c) => Number(one.getAttribute(c) ?? one.getAttribute(`c${c}`)));
    const group = drawn("g"); // what moves is the group: a text that moves by itself is laid out anew
    one.replaceWith(group);
    group.append(one);
    return { group, x, y, ends: anchored(x, y) };
  });
  const own = svg.getAttribute("viewBox").split(" ").map(Number);
  return () => {
    if (position() === plan.position) return says(figure, ""), restore(figure);
    const nodes = plan.at.map((at, n) => (n === plan.begin ? at : null));
    for (const [n, from, key, sense] of plan.ways) {
      const of = nodes[from] && vector(key);
      nodes[n] = of && [0, 1].map((c) => nodes[from][c] + (sense * of[c]) / plan.scale);
    }
    // the figure keeps its size: a plan that does not fit is drawn smaller, its letters and lines are not
    const box = roomFor(nodes, own);
    const larger = box[2] / own[2];
    change(svg, "viewBox", box.join(" "));
    says(figure, `φ = ${text(where.at, 4)}°${larger > 1.001 ? `, ${text(1 / larger, 2)} : 1` : ""}`);
    for (const { one, from, to } of free) {
      const there = nodes[from] && nodes[to];
      change(one, "visibility", there ? "visible" : "hidden");
      if (!there) continue;
      const [shaft, head] = arrow(nodes[from][0], -nodes[from][1], nodes[to][0], -nodes[to][1], 3 * larger);
      change(one.children[0], "d", shaft);
      change(one.children[1], "d", head);
      const thick = originals.get(one.children[0])["stroke-width"] ?? one.children[0].getAttribute("stroke-width");
      if (thick) change(one.children[0], "stroke-width", thick * larger);
    }
    for (const { group, x, y, ends: [a, b] } of marks) {
      const there = nodes[a] && nodes[b];
      change(group, "visibility", there ? "visible" : "hidden");
      if (!there) continue;
      const by = [0, 1].map((c) => (nodes[a][c] + nodes[b][c] - plan.at[a][c] - plan.at[b][c]) / 2);
      change(group, "transform", `translate(${by[0] + x} ${-by[1] + y}) scale(${larger}) translate(${-x} ${-y})`);
    }
    for (const one of others) change(one, "visibility", "hidden"); // lines by which it was constructed
  };
}

// The room of the plan, moved as little as holds it, larger where it is too small: left, top, width and height, mm, y down.
function roomFor(nodes, [x, y, w, h]) {
  const there = nodes.filter(Boolean);
  if (!there.length) return [x, y, w, h];
  const ends = (values) => [Math.min(...values) - 8, Math.max(...values) + 8]; // with the letters
  const [[left, right], [top, bottom]] = [ends(there.map((n) => n[0])), ends(there.map((n) => -n[1]))];
  const by = Math.max(1, (right - left) / w, (bottom - top) / h);
  const held = (own, size, from, to) => Math.min(Math.max(own + (size - by * size) / 2, to - by * size), from);
  return [held(x, w, left, right), held(y, h, top, bottom), by * w, by * h];
}

function liveChart(figure, chart) {
  const svg = figure.querySelector("svg");
  const group = drawn("g", { class: "cursor" });
  svg.append(group);
  const marks = chart.panels.map((panel) => {
    const [bottom, top] = panel.box;
    const upright = group.appendChild(drawn("path", { d: `M0 ${-bottom}V${-top}` }));
    const curves = panel.curves.map((curve) => ({
      curve,
      values: typeof curve.values === "string" ? column(...curve.values.split(".").reverse()).values : curve.values,
      dot: group.appendChild(drawn("circle", { r: 0.9 })),
      letter: group.appendChild(drawn("text", { "font-size": 2.8 })),
    }));
    return { panel, upright, curves };
  });
  const goes = (event) => {
    const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
    const share = (at.x - chart.left) / (chart.right - chart.left);
    if (share >= -0.02 && share <= 1.02) stop(), show(settled(cycle.at[0] + Math.min(Math.max(share, 0), 1) * span * (share >= 1 ? 1 - 1e-9 : 1)));
  };
  let held = false;
  svg.addEventListener("pointerdown", (event) => ((held = event.pointerType === "mouse"), goes(event)));
  svg.addEventListener("pointermove", (event) => held && event.buttons && goes(event));
  svg.addEventListener("pointerup", () => (held = false));
  return () => {
    const share = span ? (where.at - cycle.at[0]) / span : 0;
    const x = chart.left + share * (chart.right - chart.left);
    for (const { panel, upright, curves } of marks) {
      const [bottom, top, low, high] = panel.box;
      upright.setAttribute("transform", `translate(${x} 0)`);
      const told = [];
      for (const { curve, values, dot, letter } of curves) {
        const now = value(values);
        for (const one of [dot, letter]) one.style.display = now === null ? "none" : "";
        if (now === null) continue;
        const y = -(bottom + ((now - low) / (high - low)) * (top - bottom));
        dot.setAttribute("cx", x), dot.setAttribute("cy", y);
        const left = share > 0.7;
        letter.setAttribute("x", x + (left ? -1.6 : 1.6));
        told.push([y - 1.2, letter]);
        letter.setAttribute("text-anchor", left ? "end" : "start");
        letter.textContent = `${curve.name ? `${curve.name} = ` : ""}${text(now)} ${panel.unit}`;
      }
      // numbers of curves that run together stand one above another
      let room = Infinity;
      for (const [y, letter] of told.sort(([a], [b]) => b - a)) {
        letter.setAttribute("y", Math.min(y, room));
        room = Math.min(y, room) - 3.2;
      }
    }
  };
}

// Only figures that are in sight are drawn again, the others as they come into it.
function figuresFollow() {
  const inSight = new Set();
  const draws = new Map();
  const watch = new IntersectionObserver((entries) => {
    for (const { target, isIntersecting } of entries) {
      isIntersecting ? inSight.add(target) : inSight.delete(target);
      if (isIntersecting) draws.get(target)();
    }
  }, { rootMargin: "0px" });
  const add = (kind, make) => {
    for (const [anchor, of] of Object.entries(known[kind] ?? {})) {
      const figure = document.getElementById(anchor);
      if (!figure?.querySelector("svg")) continue;
      draws.set(figure, make(figure, of));
      watch.observe(figure);
    }
  };
  add("plans", livePlan);
  add("loads", liveLoads);
  add("moves", liveMoves);
  add("charts", liveChart);
  followers.push(() => inSight.forEach((figure) => draws.get(figure)()));
  addEventListener("beforeprint", () => restore(document.body));
  addEventListener("afterprint", () => draws.forEach((draw) => draw()));
}
