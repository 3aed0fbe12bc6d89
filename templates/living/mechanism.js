// Where the links are, mm, y up. Between two positions a link goes by the polynomial of the fifth degree that has the
// places, velocities and accelerations of both.

function between([p, v, a], turn) {
  const i = where.i;
  if (where.s === 0 || !turn) return p[i];
  if (where.s === 1) return p[i + 1];
  const s = where.s;
  const rise = p[i + 1] - p[i];
  const [first, second, end, bend] = [v[i] * turn, (a[i] * turn * turn) / 2, v[i + 1] * turn, (a[i + 1] * turn * turn) / 2];
  const c3 = 10 * rise - 6 * first - 3 * second - 4 * end + bend;
  const c4 = -15 * rise + 8 * first + 3 * second + 7 * end - 2 * bend;
  const c5 = 6 * rise - 3 * first - second - 3 * end + bend;
  return p[i] + s * (first + s * (second + s * (c3 + s * (c4 + s * c5))));
}

// x and y of the origin of a link's axes and its angle; null where it cannot be assembled.
function pose(link) {
  if (!mechanism.links[link]) return [0, 0, 0];
  const { pose: of } = mechanism.links[link];
  if (of[0][where.s === 1 ? where.i + 1 : where.i] === null) return null;
  const turn = last ? ((cycle.at[where.i + 1] - cycle.at[where.i]) * Math.PI) / 180 : 0;
  return [between(of.slice(0, 3), turn), between(of.slice(3, 6), turn), between(of.slice(6, 9), turn)];
}

function carried(link, x, y) {
  const at = pose(link);
  if (!at) return null;
  const [c, s] = [Math.cos(at[2]), Math.sin(at[2])];
  return [at[0] + c * x - s * y, at[1] + s * x + c * y];
}

const place = (point) => {
  const [link, x, y] = mechanism.points[point];
  return carried(link, x, y);
};

// Does something at another position and comes back.
function elsewhere(i, s, act) {
  const kept = { ...where };
  Object.assign(where, { i, s, at: cycle.at[i] + s * (cycle.at[Math.min(i + 1, last)] - cycle.at[i]) });
  const found = act();
  Object.assign(where, kept);
  return found;
}

// ---- how a link is drawn, in its own axes

const line = (points, closed) => {
  const pairs = [];
  for (let k = 0; k < points.length; k += 2) pairs.push(`${points[k]} ${points[k + 1]}`);
  return `M${pairs.join("L")}${closed ? "Z" : ""}`;
};

// A link; `by`: how much larger than in the moving scheme, `mark`: its blocks, which are no lengths of the mechanism.
function linkDrawn(name, by = 1, mark = 1) {
  const link = mechanism.links[name];
  const group = drawn("g", { "data-link": name, class: "link" });
  const larger = (points) => points.map((x) => by * x);
  const add = (points, closed, look) => group.append(drawn("path", { d: line(larger(points), closed), class: look }));
  if (link.plate.length) add(link.plate, true, "plate bar");
  for (const outline of link.outlines) {
    add(outline, true, "plate rim");
    if (link.wheel) add([...middle(outline), outline[0], outline[1]], false, "rim"); // a spoke shows that it turns
  }
  for (const bar of link.bars) add(bar, false, "bar");
  for (const [x, y, r] of link.rollers) group.append(drawn("circle", { cx: by * x, cy: by * y, r: by * r, class: "joint" }));
  const [wide, tall] = mechanism.block.map((x) => mark * x);
  for (const [x, y, c, s] of link.blocks) {
    const box = { x: -wide, y: -tall, width: 2 * wide, height: 2 * tall, class: "block" };
    group.append(drawn("rect", { ...box, transform: `matrix(${c} ${s} ${-s} ${c} ${by * x} ${by * y})` }));
  }
  return group;
}

function middle(points) {
  const sums = [0, 0];
  points.forEach((x, k) => (sums[k % 2] += x / (points.length / 2)));
  return sums;
}

function set(group, link, by = 1) {
  const at = pose(link);
  group.style.display = at ? "" : "none";
  if (!at) return;
  const [c, s] = [Math.cos(at[2]), Math.sin(at[2])];
  group.setAttribute("transform", `matrix(${c} ${s} ${-s} ${c} ${by * at[0]} ${by * at[1]})`);
}

// Shaft and head of an arrow, as the drawings of the note have them.
function arrow(x0, y0, x1, y1, most = 3) {
  const long = Math.hypot(x1 - x0, y1 - y0);
  if (!(long > 1e-3)) return ["", ""];
  const head = Math.min(most, long / 4);
  const [u, v] = [(x1 - x0) / long, (y1 - y0) / long];
  const [bx, by, wing] = [x1 - head * u, y1 - head * v, 0.17 * head];
  return [
    line([x0, y0, bx + 0.3 * head * u, by + 0.3 * head * v]),
    line([x1, y1, bx - wing * v, by + wing * u, bx + wing * v, by - wing * u], true),
  ];
}
