// The page about the note: contents at the side, the way back, light and dark, figures that fill the window.

const kept = {
  read: (name) => {
    try { return localStorage.getItem(`note ${name}`); } catch { return null; } // a page from a folder may have none
  },
  write: (name, to) => {
    try { localStorage.setItem(`note ${name}`, to); } catch { /* it is not remembered */ }
  },
};

function contents() {
  const own = document.querySelector("nav.contents");
  const side = element("nav", { class: "side", "aria-label": words.contents });
  const open = new Map();
  for (const link of own?.querySelectorAll("a") ?? []) {
    const level = link.parentElement.className;
    const one = element("a", { href: link.getAttribute("href"), class: level }, link.textContent);
    side.append(one);
    const target = document.getElementById(decodeURIComponent(link.hash.slice(1)));
    if (target) open.set(target, one);
  }
  const heads = [...open.keys()];
  let now = null;
  const follow = () => {
    const passed = heads.filter((h) => h.getBoundingClientRect().top < innerHeight / 3);
    const one = open.get(passed.at(-1) ?? heads[0]);
    if (one === now || !one) return;
    now?.removeAttribute("aria-current");
    now = one;
    now.setAttribute("aria-current", "true");
    const { top, bottom } = now.getBoundingClientRect();
    if (top < 60 || bottom > innerHeight - 20) side.scrollTop += top - innerHeight / 2;
  };
  let asked = false;
  addEventListener("scroll", () => {
    if (!asked) asked = requestAnimationFrame(() => ((asked = false), follow()));
  }, { passive: true });
  follow();
  return side;
}

// Back to where a reference was followed.
function wayBack() {
  const from = [];
  const button = element("button", {
    type: "button", class: "back", hidden: "", title: words.return,
    click: () => {
      scrollTo({ top: from.pop(), behavior: reduced.matches ? "auto" : "smooth" });
      button.hidden = !from.length;
    },
  }, "↩ " + words.return);
  document.addEventListener("click", (event) => {
    if (!event.target.closest('a[href^="#"]')) return;
    from.push(scrollY);
    button.hidden = false;
  });
  return button;
}

function shades() {
  const dark = matchMedia("(prefers-color-scheme: dark)");
  const look = (name) => (root.dataset.look = name);
  look(kept.read("look") ?? (dark.matches ? "dark" : "light"));
  dark.addEventListener("change", () => kept.read("look") ?? look(dark.matches ? "dark" : "light"));
  return element("button", {
    type: "button", title: words.light, "aria-label": words.light,
    click: () => kept.write("look", look(root.dataset.look === "dark" ? "light" : "dark")),
  }, "◐");
}

function figuresFill() {
  for (const figure of document.querySelectorAll("main figure")) {
    const svg = figure.querySelector("svg");
    if (!svg) continue;
    if (!svg.querySelector("title")) svg.prepend(drawn("title", {}, figure.querySelector("figcaption")?.textContent ?? ""));
    const button = element("button", { type: "button", class: "fill", title: words.full, "aria-label": words.full, click: () => fill(figure) }, "⤢");
    figure.prepend(button);
  }
}

// The figure itself goes into the window, so that it goes on to follow the position; then back to its place.
function fill(figure) {
  const mark = element("span");
  const box = element("dialog", { class: "full" }, element("button", { type: "button", class: "close", "aria-label": words.close, click: () => box.close() }, "×"));
  figure.before(mark);
  box.append(figure);
  if (panel) box.append(panel);
  box.addEventListener("close", () => {
    mark.replaceWith(figure);
    if (panel) document.body.append(panel);
    box.remove();
  });
  document.body.append(box);
  box.showModal();
}

const panel = cycle ? dock() : null;
const comma = element("input", { type: "checkbox", change: () => kept.write("comma", comma.checked ? "1" : "0") });
comma.checked = (kept.read("comma") ?? (known.decimal === "," ? "1" : "0")) === "1";
const side = contents();
side.prepend(element("div", { class: "tools" }, shades(), element("label", {}, comma, words.comma)));
const opener = element("button", { type: "button", class: "opener", title: words.contents, "aria-label": words.contents, click: () => side.classList.toggle("open") }, "☰");
side.addEventListener("click", (event) => event.target.closest("a") && side.classList.remove("open"));
document.body.prepend(opener, side);
document.body.append(wayBack());
tablesCopy(() => comma.checked);
figuresFill();
fellowsLight();
clicksExplain();
if (cycle) {
  document.body.append(panel);
  root.classList.add("moves");
  figuresFollow();
  rowsFollow();
  show(cycle.at[home]);
}
