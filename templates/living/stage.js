// The moving scheme with what steers it: beside the text on a wide window, at its foot on a narrow one.

const SNAP = 0.12; // of the way between two numbered positions: so near the dragged mechanism comes to rest in one
const LONGEST = 26; // mm of the longest vector of a kind

function layer(name, keys) {
  const most = Math.max(...keys.map(([key]) => reach(key)));
  const group = drawn("g", { class: `layer ${name}` });
  const arrows = keys.map(([key, at]) => {
    const one = drawn("g", { "data-q": key }, drawn("path", { class: "shaft" }), drawn("path", { class: "head" }));
    group.append(one);
    return { one, key, at };
  });
  const draw = () => {
    for (const { one, key, at } of arrows) {
      const from = typeof at === "string" ? place(at) : [value(at[0]), value(at[1])];
      const of = vector(key);
      const [shaft, head] =
        from && of && from[0] !== null && most > 0
          ? arrow(from[0], from[1], from[0] + (of[0] * LONGEST) / most, from[1] + (of[1] * LONGEST) / most)
          : ["", ""];
      one.firstChild.setAttribute("d", shaft);
      one.lastChild.setAttribute("d", head);
    }
  };
  return { group, draw };
}

function paths() {
  const group = drawn("g", { class: "layer paths" });
  for (const [name, [link]] of Object.entries(mechanism.points)) {
    if (!mechanism.links[link]) continue;
    let d = "";
    for (let i = 0; i < last; i++)
      for (let s = 0; s < 1; s += mechanism.smooth[i] ? 0.25 : 1) {
        const at = elsewhere(i, s, () => place(name));
        d += at ? `${d && !d.endsWith("|") ? "L" : "M"}${at[0].toFixed(2)} ${at[1].toFixed(2)}` : "|";
      }
    const end = elsewhere(Math.max(0, last - 1), 1, () => place(name));
    if (end && d && !d.endsWith("|")) d += `L${end[0].toFixed(2)} ${end[1].toFixed(2)}`;
    group.append(drawn("path", { d: d.replaceAll("|", ""), "data-point": name }));
  }
  return group;
}

// What all positions need, with room for the letters: left, top, width, height, y down.
function bounds(frame) {
  const box = [Infinity, Infinity, -Infinity, -Infinity];
  const take = (x, y) => {
    [box[0], box[1]] = [Math.min(box[0], x), Math.min(box[1], y)];
    [box[2], box[3]] = [Math.max(box[2], x), Math.max(box[3], y)];
  };
  const [x, y, w, h] = frame.getAttribute("viewBox").split(" ").map(Number);
  take(x, y), take(x + w, y + h);
  const corners = ({ bars, plate, outlines, blocks }) => [...bars.flat(), ...plate, ...outlines.flat(), ...blocks.flatMap((b) => b.slice(0, 2))];
  for (let i = 0; i <= last; i++)
    elsewhere(Math.min(i, Math.max(0, last - 1)), i === last && last ? 1 : 0, () => {
      for (const name of Object.keys(mechanism.links)) {
        const of = corners(mechanism.links[name]);
        for (let k = 0; k < of.length; k += of.length > 200 ? 20 : 2) {
          const at = carried(name, of[k], of[k + 1]);
          if (at) take(at[0], -at[1]);
        }
      }
    });
  const room = 7;
  return [box[0] - room, box[1] - room, box[2] - box[0] + 2 * room, box[3] - box[1] + 2 * room];
}

// Springs, dampers and a driving cylinder: lines between two points.
function ties() {
  const group = drawn("g");
  const ends = mechanism.ties.map(([kind, a, b]) => [kind, a, b]);
  if (mechanism.cylinder) ends.push(["cylinder", ...mechanism.cylinder]);
  const lines = ends.map(([kind, a, b]) => [group.appendChild(drawn("path", { class: kind })), a, b]);
  const draw = () => {
    for (const [one, a, b] of lines) {
      const [from, to] = [place(a), place(b)];
      one.setAttribute("d", from && to ? line([...from, ...to]) : "");
    }
  };
  return { group, draw };
}

function stageDrawn() {
  const frame = parsed(mechanism.frame);
  const box = bounds(frame);
  const svg = drawn("svg", { viewBox: box.join(" "), role: "img", tabindex: 0, class: "scheme", style: `--mm: ${Math.max(1, box[2] / 110)}` }, drawn("title", {}, words.scheme));
  svg.append(document.importNode(frame.lastElementChild, true));
  const up = drawn("g", { transform: "scale(1 -1)" });
  const links = Object.keys(mechanism.links).map((name) => [linkDrawn(name), name]);
  const tied = ties();
  const gap = 1.8 * Math.max(1, box[2] / 160);
  const points = Object.entries(mechanism.points).map(([name, [, , , joint]]) => {
    const mark = drawn("circle", { r: (joint ? 1.3 : 0.6) * Math.max(1, box[2] / 160), class: joint ? "joint" : "dot", "data-point": name });
    const letter = drawn("text", { "data-point": name, x: gap, y: -gap }, name);
    return { name, mark, letter: drawn("g", {}, letter) }; // what moves is the group: its text is laid out once
  });
  const vectors = Object.keys(cycle.vectors);
  const of = (letter) => vectors.filter((k) => k.startsWith(letter) && k.slice(2) in mechanism.points).map((k) => [k, k.slice(2)]);
  const layers = {
    paths: { group: paths(), draw: () => {} },
    velocities: layer("velocities", of("v_")),
    accelerations: layer("accelerations", of("a_")),
    forces: layer("forces", mechanism.forces.filter(([key]) => key in cycle.vectors)),
  };
  up.append(layers.paths.group, ...links.map(([g]) => g), tied.group, ...points.map((p) => p.mark));
  for (const name of ["velocities", "accelerations", "forces"]) up.append(layers[name].group);
  svg.append(up, ...points.map((p) => p.letter));
  const draw = () => {
    for (const [group, name] of links) set(group, name);
    for (const { name, mark, letter } of points) {
      const at = place(name);
      for (const one of [mark, letter]) one.style.display = at ? "" : "none";
      if (!at) continue;
      mark.setAttribute("cx", at[0]), mark.setAttribute("cy", at[1]);
      letter.setAttribute("transform", `translate(${at[0]} ${-at[1]})`);
    }
    tied.draw();
    for (const one of Object.values(layers)) if (one.shown) one.draw();
  };
  followers.push(draw);
  drags(svg);
  return { svg, layers, draw };
}

// ---- dragging: the mechanism goes to where the point that is held comes nearest to the pointer

function drags(svg) {
  let held = null;
  const pointed = (event) => {
    const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
    return [at.x, -at.y];
  };
  const away = (point, [x, y]) => {
    const at = place(point);
    return at ? Math.hypot(at[0] - x, at[1] - y) : Infinity;
  };
  svg.addEventListener("pointerdown", (event) => {
    const at = pointed(event);
    const moving = Object.keys(mechanism.points).filter((p) => mechanism.links[mechanism.points[p][0]] && !mechanism.points[p][4].includes("0"));
    moving.sort((a, b) => away(a, at) - away(b, at));
    held = moving[0] ?? null;
    if (held === null) return;
    stop();
    svg.setPointerCapture(event.pointerId);
    svg.focus({ preventScroll: true });
    event.preventDefault();
  });
  svg.addEventListener("pointermove", (event) => {
    if (held !== null) show(settled(nearest(held, pointed(event))));
  });
  for (const end of ["pointerup", "pointercancel"]) svg.addEventListener(end, () => (held = null));

  function nearest(point, at) {
    const reach = span / 5; // not over to another branch of the way
    let best = [Infinity, where.at];
    const kept = where.at;
    const look = (from, to, step) => {
      for (let x = from; x <= to; x += step) {
        placeAt(x);
        const far = away(point, at) + 1e-4 * Math.abs(x - kept);
        if (far < best[0]) best = [far, x];
      }
    };
    look(kept - reach, kept + reach, span / 180);
    look(best[1] - span / 180, best[1] + span / 180, span / 3600);
    placeAt(kept);
    return best[1];
  }

  function placeAt(at) {
    const saved = followers.splice(0);
    const { whole } = where;
    show(at);
    where.whole = whole;
    followers.push(...saved);
  }
}

function settled(at) {
  const inside = cycle.closed ? cycle.at[0] + ((((at - cycle.at[0]) % span) + span) % span) : at;
  const step = span / Math.max(1, cycle.numbered.length - 1);
  const near = cycle.numbered.map((i) => cycle.at[i]).find((x) => Math.abs(x - inside) < SNAP * step);
  return near ?? at;
}

// ---- playing

let playing = 0;
const PACES = [1, 2, 4, 0.1, 0.25, 0.5];
let pace = 1;
const CYCLE = 6000; // ms of a whole cycle

function play() {
  const omega = column("omega", "flywheel")?.values.filter((x) => x !== null);
  const mean = omega?.length ? omega.reduce((a, b) => a + b, 0) / omega.length : 0;
  let before = null;
  const frame = (now) => {
    if (!playing) return;
    const passed = before === null ? 0 : Math.min(now - before, 100);
    if (reduced.matches) {
      if (before === null || now - before > 1000 / pace) step(1), (before = now);
    } else {
      const rate = mean ? (value(column("omega", "flywheel").values) ?? mean) / mean : 1; // as the flywheel lets it
      show(!cycle.closed && where.at >= cycle.at[last] ? cycle.at[0] : where.at + (passed * pace * rate * span) / CYCLE);
      before = now;
    }
    playing = requestAnimationFrame(frame);
  };
  playing = requestAnimationFrame(frame);
  root.classList.add("playing");
}

function stop() {
  cancelAnimationFrame(playing);
  playing = 0;
  root.classList.remove("playing");
}

function step(by) {
  const places = cycle.numbered.map((i) => cycle.at[i]);
  const count = cycle.closed ? places.length - 1 : places.length;
  const off = numbered();
  const exact = Math.abs(places[off] - where.at) < 1e-6;
  const next = exact ? off + by : by > 0 ? places.findIndex((x) => x > where.at) : places.findLastIndex((x) => x < where.at);
  show(places[((next % count) + count) % count]);
}

// ---- the dock

function dock() {
  const { svg, layers, draw } = mechanism ? stageDrawn() : { svg: "", layers: {} };
  const button = (name, sign, act, more = {}) => element("button", { type: "button", title: words[name], "aria-label": words[name], click: act, ...more }, sign);
  const toggle = () => (playing ? stop() : play());
  const player = button("play", "▶", toggle, { class: "play" });
  const slider = element("input", {
    type: "range", min: cycle.at[0], max: cycle.at[last], step: span / 720, "aria-label": words.place,
    input: () => (stop(), show(settled(Number(slider.value)))),
  });
  const told = element("output", { class: "at" });
  // no list: Chromium falls over one where the machine has no font
  const speed = button("speed", "1×", () => {
    pace = PACES[(PACES.indexOf(pace) + 1) % PACES.length];
    speed.textContent = `${text(pace)}×`;
  }, { class: "speed" });
  const choices = element("div", { class: "choices" });
  for (const [name, one] of Object.entries(layers)) {
    if (!one.group.childNodes.length) continue;
    const box = element("input", { type: "checkbox", change: () => ((one.shown = box.checked), (one.group.style.display = box.checked ? "" : "none"), draw()) });
    one.shown = box.checked = name === "paths";
    one.group.style.display = box.checked ? "" : "none";
    choices.append(element("label", {}, box, words[name]));
  }
  const fold = button("fold", "▾", () => panel.classList.toggle("folded"), { class: "fold" });
  const controls = element(
    "div", { class: "controls" }, button("back", "◀", () => (stop(), step(-1))), player, button("next", "▶|", () => (stop(), step(1))), slider, speed, fold,
  );
  const panel = element("aside", { class: "dock", "aria-label": words.place }, svg, controls, told, choices, readings());
  (svg || slider).addEventListener("keydown", (event) => {
    const act = { ArrowRight: () => step(1), ArrowLeft: () => step(-1), Home: () => show(cycle.at[0]), " ": toggle }[event.key];
    if (act) event.preventDefault(), event.key === " " || stop(), act();
  });
  followers.push(() => {
    slider.value = where.at;
    const k = numbered();
    const exact = position() === cycle.numbered[k];
    say(told, `${words.position} ${exact ? "" : "≈ "}${k}   φ = ${text(where.at, 4)}°`);
  });
  new MutationObserver(() => {
    player.textContent = root.classList.contains("playing") ? "❚❚" : "▶";
  }).observe(root, { attributeFilter: ["class"] });
  if (matchMedia("(max-width: 1179px)").matches) panel.classList.add("folded");
  return panel;
}

// The numbers of all tables over the positions, as they are now.
function readings() {
  const all = element("details", { class: "readings" }, element("summary", {}, words.values));
  const lines = [];
  for (const columns of Object.values(cycle.columns)) {
    const table = element("table");
    for (const one of columns) {
      const number = element("td", { "data-now": one.key });
      table.append(element("tr", { "data-q": one.key }, element("th", { scope: "row" }, ...signed(one.sign)), number, element("td", {}, one.unit)));
      lines.push([number, one.values]);
    }
    if (columns.length) all.append(table);
  }
  const draw = () => {
    if (all.open) for (const [cell, values] of lines) say(cell, text(value(values)));
  };
  all.addEventListener("toggle", draw);
  followers.push(draw);
  return all;
}
