// Tables: the row of the position is lit, a row's number goes to its position, and tables copy as numbers.

function rowsFollow() {
  const rows = new Map(); // number of a position -> its cells
  for (const cell of document.querySelectorAll('main td[data-q="position"]')) {
    const k = Number(cell.dataset.k);
    const group = [cell];
    for (let next = cell.nextElementSibling; next && next.dataset.q !== "position"; next = next.nextElementSibling) group.push(next);
    if (!rows.has(k)) rows.set(k, []);
    rows.get(k).push(...group);
    cell.tabIndex = 0;
    cell.setAttribute("role", "button");
    const go = () => k in cycle.numbered && (stop(), show(cycle.at[cycle.numbered[k]]));
    cell.addEventListener("click", (event) => (event.stopPropagation(), go()));
    cell.addEventListener("keydown", (event) => (event.key === "Enter" || event.key === " ") && (event.preventDefault(), go()));
  }
  let lit = [];
  let now = null;
  followers.push(() => {
    const k = numbered();
    if (k === now) return;
    now = k;
    for (const cell of lit) cell.classList.remove("now");
    const count = cycle.numbered.length - 1;
    lit = [...(rows.get(k) ?? []), ...(cycle.closed && k === count ? (rows.get(0) ?? []) : [])];
    for (const cell of lit) cell.classList.add("now");
  });
}

// A table for a spreadsheet: a tab between cells, a plain minus, the decimal sign of the reader's choice.
function copied(table, comma) {
  const plain = (cell) => {
    const said = [...cell.cloneNode(true).textContent].join("").trim().replace(/[\s\u00a0\u202f]+/g, " ");
    return /^[\u2212-]?\d[\d ]*(?:[.,]\d+)?$/.test(said)
      ? said.replace("\u2212", "-").replaceAll(" ", "").replace(/[.,]/, comma ? "," : ".")
      : said.replace(/^[=+@-]/, "'$&");
  };
  return [...table.rows].map((row) => [...row.cells].map(plain).join("\t")).join("\r\n");
}

function tablesCopy(comma) {
  for (const table of document.querySelectorAll("main .table table")) {
    const button = element("button", {
      type: "button", class: "copy", title: words.copy, "aria-label": words.copy,
      click: async () => {
        await put(copied(table, comma()));
        button.textContent = "✓ " + words.copied;
        setTimeout(() => (button.textContent = "⧉"), 1500);
      },
    }, "⧉");
    table.closest(".table").prepend(button);
  }
  // what a reader selects and copies himself is numbers as well
  document.addEventListener("copy", (event) => {
    const table = getSelection().anchorNode?.parentElement?.closest("main table");
    if (!table || !getSelection().containsNode(table, true) || getSelection().toString().indexOf("\t") < 0) return;
    const said = getSelection().toString().split(/\r?\n/).map((line) => line.split("\t").map((x) => x.replace(/^\u2212(?=\d)/, "-").replace(/^(-?\d+)[.,](\d+)$/, comma() ? "$1,$2" : "$1.$2")).join("\t"));
    event.clipboardData.setData("text/plain", said.join("\r\n"));
    event.preventDefault();
  });
}

async function put(said) {
  try {
    await navigator.clipboard.writeText(said);
  } catch {
    // a page from a folder may not ask the clipboard: it copies what is selected
    const area = element("textarea", { class: "aside" });
    area.value = said;
    document.body.append(area);
    area.select();
    document.execCommand("copy");
    area.remove();
  }
}
