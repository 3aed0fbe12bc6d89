// Pictures of gears and cams: their parts turn with the position, their dimensions stay.

function liveMoves(figure, { still, bare, parts, box }) {
  const svg = figure.querySelector("svg");
  const note = svg.querySelector("g");
  const kids = [...note.children];
  const hidden = still.map((k) => kids[k]);
  if (bare) hidden.push(...kids.filter((kid) => !hidden.includes(kid)));
  const group = drawn("g", { class: "turning" });
  const all = parts.map((part) => {
    const shape = parsed(`<g xmlns="http://www.w3.org/2000/svg" fill="none" stroke-linecap="round" stroke-linejoin="round">${part.svg}</g>`);
    const one = () => {
      const made = group.appendChild(document.importNode(shape, true));
      made.prepend(...(part.same ?? []).map((k) => kids[k].cloneNode(true)));
      return made;
    };
    const count = part.pitch ? Math.ceil(Math.min(180, 60 + 2 * (part.half / Math.hypot(...part.centre)) * 57.3) / part.pitch) : 0;
    return { part, shapes: Array.from({ length: 2 * count + 1 }, (_, n) => [one(), n - count]) };
  });
  const turn = (angle, [x, y]) => `rotate(${-angle} ${x} ${-y})`;
  return () => {
    // where the page begins, the figure is that of the note
    if (position() === home && !where.whole && !playing) return group.remove(), restore(figure);
    if (!group.isConnected) note.insertBefore(group, note.lastElementChild);
    if (box) change(svg, "viewBox", box.join(" ")), change(svg, "width", `${box[2]}mm`), change(svg, "height", `${box[3]}mm`);
    for (const one of hidden) change(one, "visibility", "hidden");
    const whole = where.at - cycle.at[0] + span * where.whole;
    for (const { part, shapes } of all) {
      let angle = part.rate * whole;
      if (part.turns) angle = along(part.at, part.turns);
      if (part.pitch) angle = (((angle % part.pitch) + 1.5 * part.pitch) % part.pitch) - part.pitch / 2;
      if (part.rise) {
        // from the side: in front of the axis it is seen, behind it not, and where half of a wheel is drawn, on that half
        const [front, up] = turned(part.rise, [Math.cos, Math.sin].map((f) => f((angle * Math.PI) / 180)));
        const [x, y] = part.across;
        shapes[0][0].setAttribute("transform", `translate(${x * up} ${-y * up})`);
        shapes[0][0].style.display = front > 0 && (!part.side || part.side * up > 0) ? "" : "none";
        continue;
      }
      const orbit = (part.about ?? 0) * whole;
      for (const [one, k] of shapes) {
        const own = turn(angle - orbit + k * (part.pitch ?? 0), part.centre);
        const way = part.ways ? `translate(${along(part.at, part.ways[0])} ${-along(part.at, part.ways[1])}) ` : "";
        one.setAttribute("transform", `${way}${orbit ? turn(orbit, [0, 0]) : ""}${own}`);
        if (!part.pitch) continue;
        // a tooth is seen where the note draws some
        const far = ((angle + k * part.pitch) * Math.PI) / 180;
        one.style.display = Math.abs(Math.sin(far)) * Math.hypot(...part.centre) < part.half && Math.abs(far) < Math.PI / 2 ? "" : "none";
      }
    }
  };
}

// A value at the position, of a picture that has its own.
function along(at, values) {
  const turned = span ? ((((where.at - at[0]) % (at.at(-1) - at[0])) + (at.at(-1) - at[0])) % (at.at(-1) - at[0])) + at[0] : at[0];
  const i = Math.max(0, Math.min(at.length - 2, at.findIndex((x) => x > turned) - 1));
  const s = (turned - at[i]) / (at[i + 1] - at[i]);
  return values[i] + s * (values[i + 1] - values[i]);
}
