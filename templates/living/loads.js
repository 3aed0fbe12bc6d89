// Loading schemes and Zhukovsky's lever, drawn anew in every position but that for which the note has them. Lengths of
// forces only hint at their sizes, as they do in the note.

const ARROW = [11, 17]; // mm of the shortest arrow, and by how much that of the largest force is longer
const LETTER = 2.8; // mm
const ROOM = [150, 120, 165]; // mm of paper: the width of a scheme at least; at most its height, and that of a lever
const TURN = 6; // mm, radius of the arc of a couple

// A letter with its indices: base, lower, upper. What moves is the group: a text that moves by itself is laid out anew.
function lettered([base, sub = "", sup = ""], attributes) {
  const one = drawn("text", { "font-size": LETTER, ...attributes });
  one.append(drawn("tspan", { "font-style": "italic" }, base));
  const small = (said, dy) => one.append(drawn("tspan", { "font-size": 0.72 * LETTER, dy }, said));
  if (sub) small(sub, 0.22 * LETTER);
  if (sup) small(sup, (sub ? -0.58 : -0.36) * LETTER);
  return drawn("g", {}, one);
}

// A vector turned by the factor [c, s].
const turned = ([x, y], [c, s]) => [c * x - s * y, s * x + c * y];

// Places of what acts, mm of the scheme, y up; null where it is not known.
function whereActs(load) {
  const { by = 1 } = load;
  const scaled = (at) => at && at[0] !== null && [at[0] * by, at[1] * by];
  const along = (at) => scaled([value(at[0]), value(at[1])]);
  const places = Object.fromEntries(mechanism.forces.map(([key, at]) => [key, at]));
  if (load.sides) {
    const end = (name) => {
      const v = name ? vector(`v_${name}`) : [0, 0];
      return v && turned(v, load.turn);
    };
    return { end, force: (at) => at.map(end), link: () => null };
  }
  const force = (at) => [typeof at === "string" ? scaled(place(at)) : along(at[0] === "" ? places[at[1]] : at)];
  return { force, link: ([link, x, y]) => scaled(carried(link, x, y)) };
}

// The forces of a scheme as they are: what each is drawn by, from where to where, mm, y up; of a pair the second has the
// opposite sense. Those that would lie upon one another stand side by side.
function arrowsOf(load, at, larger) {
  const largest = Math.max(...load.forces.map(([key]) => reach(key)));
  const found = [];
  for (const [key, place] of load.forces)
    at.force(place).forEach((from, n) => {
      const of = vector(key);
      const size = of && Math.hypot(...of);
      if (!from || !(size > 1e-6 * largest)) return found.push(null);
      const sense = n ? -1 : 1;
      const [u, v] = [(sense * of[0]) / size, (sense * of[1]) / size];
      const long = (ARROW[0] + (ARROW[1] * size) / largest) * larger;
      const same = (a) => a && Math.hypot(a.from[0] - from[0], a.from[1] - from[1]) < 1 && Math.abs(a.u * v - a.v * u) < 0.05;
      const beside = found.filter(same).length;
      const [x, y] = [from[0] - 1.2 * larger * beside * v, from[1] + 1.2 * larger * beside * u];
      found.push({ from, u, v, beside, start: [x, y], end: [x + u * long, y + v * long] });
    });
  return found;
}

function forcesDrawn(load, group, at, larger) {
  const all = load.forces.flatMap(([key, place, letter, colour]) =>
    at.force(place).map(() => {
      const one = vectorDrawn(key, `#${colour}`, 0.5 * larger);
      const name = lettered(letter, { fill: `#${colour}` });
      group.append(one, name);
      return [one, name];
    }),
  );
  return () => {
    arrowsOf(load, at, larger).forEach((a, k) => {
      const [one, name] = all[k];
      for (const part of all[k]) part.style.display = a ? "" : "none";
      if (!a) return;
      lead(one, a.start, a.end, larger);
      const aside = 2.4 * larger * a.beside;
      letterAt(name, a.end[0] - aside * a.v, a.end[1] + aside * a.u, a.u, a.v, larger);
    });
  };
}

const vectorDrawn = (key, colour, width) =>
  drawn("g", { "data-q": key, style: `color:${colour}` }, drawn("path", { class: "shaft", style: `stroke-width:${width}px` }), drawn("path", { class: "head" }));

function lead(one, from, to, larger) {
  const [shaft, head] = from && to ? arrow(from[0], -from[1], to[0], -to[1], 3 * larger) : ["", ""];
  one.firstChild.setAttribute("d", shaft), one.lastChild.setAttribute("d", head);
}

// A letter beyond (x, y), y up, where something ends that points along (u, v).
function letterAt(name, x, y, u, v, larger) {
  const anchor = u < -0.4 ? "end" : u > 0.4 ? "start" : "middle";
  if (name.firstChild.getAttribute("text-anchor") !== anchor) name.firstChild.setAttribute("text-anchor", anchor);
  const [to, down] = [x + 1.2 * larger * u, -(y + 2.2 * larger * v) + 0.9 * larger];
  name.setAttribute("transform", `translate(${to} ${down}) scale(${larger})`);
}

function couplesDrawn(load, group, at, larger) {
  const all = (load.couples ?? []).map(([key, place, letter]) => {
    const one = vectorDrawn(key, "#1B4F9C", 0.35 * larger);
    const name = lettered(letter, { fill: "#1B4F9C" });
    group.append(one, name);
    return { one, name, key, place };
  });
  return () => {
    for (const { one, name, key, place } of all) {
      const [middle, moment] = [at.link(place), value(cycle.turning[key])];
      for (const part of [one, name]) part.style.display = middle && moment ? "" : "none";
      if (!middle || !moment) continue;
      // an arc over the place, its head where the couple turns to
      const [r, sense] = [TURN * larger, Math.sign(moment)];
      const spot = (angle) => [middle[0] + r * Math.cos(angle), -(middle[1] + r * Math.sin(angle))];
      const [start, end] = [Math.PI / 2 - sense * 1.9, Math.PI / 2 + sense * 1.9];
      const [a, b, c] = [spot(start), spot(end - sense * 0.35), spot(end)];
      one.firstChild.setAttribute("d", `M${a.join(" ")}A${r} ${r} 0 1 ${sense > 0 ? 0 : 1} ${b.join(" ")}`);
      one.lastChild.setAttribute("d", arrow(4 * b[0] - 3 * c[0], 4 * b[1] - 3 * c[1], ...c, Infinity)[1]);
      letterAt(name, middle[0], middle[1] + r, 0, 0.4, larger);
    }
  };
}

// The plan of velocities of the lever, with the letters of its points.
function leverDrawn(load, group, at, larger) {
  const sides = load.sides.map(([key, from, to]) => {
    const one = vectorDrawn(key, "#000", (from ? 0.35 : 0.6) * larger);
    group.append(one);
    return { one, from, to };
  });
  const names = ["", ...load.points].map((name) => [name, lettered(name ? [name[0].toLowerCase(), name.slice(1)] : ["p"])]);
  group.append(...names.map(([, one]) => one));
  return () => {
    for (const { one, from, to } of sides) lead(one, at.end(from), at.end(to), larger);
    for (const [name, one] of names) {
      const [x, y] = at.end(name) ?? [0, 0];
      const far = Math.hypot(x, y) || 1;
      letterAt(one, x, y, name ? x / far : -0.7, name ? y / far : -0.7, larger);
    }
  };
}

// The links of a scheme with the letters of their points.
function linksDrawn(load, group, at, larger) {
  const up = drawn("g", { transform: "scale(1 -1)", class: "scheme", style: `--mm:${larger}` });
  const links = load.links.filter((name) => mechanism.links[name]).map((name) => [linkDrawn(name, load.by, larger), name]);
  const own = Object.entries(mechanism.points).filter(([, of]) => of[4].some((link) => link !== "0" && load.links.includes(link)));
  const points = own.map(([name, [, , , joint]]) => {
    const mark = drawn("circle", { class: joint ? "joint" : "dot", "data-point": name, r: (joint ? 1.2 : 0.7) * larger });
    return { name, mark, letter: lettered([name[0], name.slice(1)], { "data-point": name }) };
  });
  // links that replace cam pairs: from a centre of curvature to where the follower is met
  const rods = (load.rods ?? []).map(([centre, met, letter]) => {
    const [one, mark] = [drawn("path", { class: "rod" }), drawn("circle", { class: "joint", r: 1.2 * larger })];
    return { centre, met, one, mark, letter: lettered(letter, {}) };
  });
  up.append(...links.map(([g]) => g), ...rods.flatMap(({ one, mark }) => [one, mark]), ...points.map(({ mark }) => mark));
  group.append(up, ...[...rods, ...points].map(({ letter }) => letter));
  return () => {
    for (const [one, name] of links) set(one, name, load.by);
    for (const { centre, met, one, mark, letter } of rods) {
      const [from, to] = [at.force(centre)[0], at.force(met)[0]];
      for (const part of [one, mark, letter]) part.style.display = from && to ? "" : "none";
      if (!from || !to) continue;
      one.setAttribute("d", line([...from, ...to]));
      mark.setAttribute("transform", `translate(${from[0]} ${from[1]})`);
      letterAt(letter, from[0] + larger, from[1] + 0.5 * larger, 0.45, 0.7, larger);
    }
    for (const { name, mark, letter } of points) {
      const at = place(name);
      for (const one of [mark, letter]) one.style.display = at ? "" : "none";
      if (!at) continue;
      const [x, y] = [at[0] * load.by, at[1] * load.by];
      mark.setAttribute("cx", x), mark.setAttribute("cy", y);
      letterAt(letter, x + larger, y + 0.5 * larger, 0.45, 0.7, larger);
    }
  };
}

// Some places of the outlines of a link.
function* edges(name) {
  for (const of of mechanism.links[name]?.outlines ?? []) {
    const by = 2 * Math.ceil(of.length / 48);
    for (let k = 0; k < of.length; k += by) yield carried(name, of[k], of[k + 1]);
  }
}

// The figure is given the room that all positions need, from the first motion on: what does not fit is drawn smaller, its
// letters, lines and arrows are not.
function roomOf(load, at, own) {
  const room = (larger) => {
    const spots = [[own[0], own[1]], [own[0] + own[2], own[1] + own[3]]];
    const add = (one, by) => one && spots.push([one[0] - by * larger, -one[1] - by * larger], [one[0] + by * larger, -one[1] + by * larger]);
    for (let i = 0; i <= last; i++)
      elsewhere(Math.min(i, Math.max(0, last - 1)), i === last && last ? 1 : 0, () => {
        if (load.sides) ["", ...load.points].forEach((name) => add(at.end(name), 3));
        for (const a of larger ? arrowsOf(load, at, larger) : []) add(a?.end, 5), add(a?.start, 3);
        for (const [, where] of load.couples ?? []) add(at.link(where), TURN + 3);
        for (const [centre] of load.rods ?? []) add(at.force(centre)[0], 5);
        for (const name of load.links ?? []) for (const spot of edges(name)) add(spot?.map((x) => x * load.by), 1);
        for (const name of load.links ?? []) for (const [point, of] of Object.entries(mechanism.points)) {
          const spot = of[4].includes(name) && name !== "0" && place(point);
          if (spot) add(spot.map((x) => x * load.by), 5);
        }
      });
    const [xs, ys] = [0, 1].map((c) => spots.map((one) => one[c]));
    const [left, top] = [Math.min(...xs), Math.min(...ys)];
    return [left, top, Math.max(...xs) - left, Math.max(...ys) - top];
  };
  const wide = Math.max(own[2], ROOM[0]);
  const times = (box) => Math.max(1, box[2] / wide, box[3] / ROOM[load.sides ? 2 : 1]);
  let larger = times(room(0));
  for (let round = 0; round < 4; round++) larger = times(room(larger));
  const box = room(larger);
  return { box, larger: times(box), size: box.slice(2).map((x) => `${x / times(box)}mm`) };
}

function liveLoads(figure, load) {
  const svg = figure.querySelector("svg");
  const note = svg.querySelector("g");
  const own = svg.getAttribute("viewBox").split(" ").map(Number);
  const group = drawn("g", { class: "loads layer", "font-family": note.getAttribute("font-family") });
  let parts = null;
  let room = null;
  const begin = () => {
    const at = whereActs(load);
    room = roomOf(load, at, own);
    svg.append(group);
    return [load.sides ? leverDrawn : linksDrawn, couplesDrawn, forcesDrawn].map((make) => make(load, group, at, room.larger));
  };
  return () => {
    const noted = position() === load.position;
    group.style.display = noted ? "none" : "";
    if (noted && !parts) return;
    parts ??= begin();
    change(svg, "viewBox", room.box.join(" "));
    change(svg, "width", room.size[0]), change(svg, "height", room.size[1]);
    change(note, "visibility", noted ? "visible" : "hidden");
    if (noted) return says(figure, "");
    for (const part of parts) part();
    const moment = load.moment && column(load.moment);
    const told = moment ? ` = ${text(value(moment.values))} ${moment.unit}` : "";
    const smaller = room.larger > 1.001 ? `, ${text(1 / room.larger, 2)} : 1` : "";
    says(figure, `φ = ${text(where.at, 4)}°${moment ? ", " : ""}`, moment ? moment.sign : "", told + smaller);
  };
}
