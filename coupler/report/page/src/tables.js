// Numbers of the runs, in tables.
import {digits, readable} from "./units.js";

const element = (tag, attributes = {}, ...children) => {
  const made = Object.assign(document.createElement(tag), attributes);
  made.append(...children);
  return made;
};

const nameOf = (text) => text.replace("/", ": ").replaceAll("_", " ");

function table(head, rows) {
  return element("table", {}, element("thead", {}, element("tr", {}, ...head.map((text) => element("th", {textContent: text})))),
                 element("tbody", {}, ...rows.map((row) => element("tr", {className: row.strong ? "strong" : ""},
                   ...row.map((cell, k) => element(k ? "td" : "th", {textContent: cell, className: k && /^(–|-?[\d.]+(e-?\d+)?( %)?)$/.test(cell) ? "number" : ""}))))));
}

/** A number in the readable unit of its row. */
function scaled(values, unit) {
  const largest = Math.max(...values.map((v) => Math.abs(v ?? 0)));
  const shown = readable(unit, largest);
  return {cells: values.map((v) => v === null || v === undefined ? "–" : digits(v * shown.factor)), unit: shown.unit};
}

/** Histories that stay as they are, mostly counts of zero, have no peak worth a line. */
function peaks(run) {
  const rows = run.document.extremes.filter((e) => e.min !== e.max).map((e) => {
    const {cells, unit} = scaled([e.min, e.max, e.last], e.unit);
    const when = (t) => t === null ? "–" : digits(t);
    const row = [unit ? `${nameOf(e.name)} [${unit}]` : nameOf(e.name), cells[0], when(e.min_time), cells[1], when(e.max_time), cells[2]];
    row.peak = e.peak === e.max ? 3 : 1;
    return row;
  });
  const made = table(["history", "least", "at [s]", "largest", "at [s]", "last"], rows);
  made.querySelectorAll("tbody tr").forEach((tr, k) => tr.children[rows[k].peak].classList.add("peak"));
  return element("div", {}, made, element("p", {className: "hint", textContent:
    "Bold: the value farthest from zero. Histories that never change are left out."}));
}

function impulses(run) {
  return table(["integral over time of", "value", "unit"], run.document.impulses.map((e) => {
    const {cells, unit} = scaled([e.value], e.unit);
    return [nameOf(e.name), cells[0], unit];
  }));
}

function balance(run) {
  return table(["energy or work", "first window", "last window", "change", "unit"], run.document.balance.map((e) => {
    const {cells, unit} = scaled([e.first, e.last, e.change], e.unit);
    return Object.assign([nameOf(e.name), ...cells, unit], {strong: e.name.includes("sum")});
  }));
}

function cost(run) {
  const rows = run.document.phases, whole = rows.reduce((sum, row) => sum + row.seconds, 0);
  const made = table(["process", "phase", "wall time [s]", "share", ""], rows.map((row) =>
    [row.member, row.phase, digits(row.seconds, 3), `${(100 * row.seconds / (whole || 1)).toFixed(1)} %`, ""]));
  made.querySelectorAll("tbody tr").forEach((tr, k) => tr.lastChild.append(
    Object.assign(element("div", {className: "bar"}), {style: `width:${100 * rows[k].seconds / (whole || 1)}%`})));
  const {wall_seconds: wall, windows} = run.document.status;
  return element("div", {}, made, element("p", {textContent:
    `${windows} windows${wall ? `, ${digits(wall, 3)} s of wall time in all, ${digits(1000 * wall / windows, 3)} ms a window` : ""}`}));
}

function theCase(run) {
  const facts = table(["", ""], run.document.facts);
  facts.querySelector("thead").remove();
  facts.className = "facts";
  return element("div", {}, facts, table(["key of the case", "value", "unit"], run.document.case));
}

const tabs = [["Peaks", peaks, "extremes"], ["Impulses", impulses, "impulses"], ["Energy and work", balance, "balance"],
              ["Cost", cost, "phases"], ["Case", theCase, "case"]];

/** Tabs with the tables of all runs, below each other. */
export class Tables {
  constructor(root, runs) {
    this.runs = runs;
    this.body = element("div", {className: "tabbody"});
    const buttons = tabs.filter(([, , key]) => runs.some((run) => run.document[key]?.length)).map(([title, make, key]) =>
      element("button", {textContent: title, onclick: () => this.open(title, make, key)}));
    this.bar = element("nav", {className: "tabs"}, ...buttons);
    root.replaceChildren(this.bar, this.body);
    buttons[0]?.click();
  }
  open(title, make, key) {
    this.current = [title, make, key];
    for (const button of this.bar.children) button.setAttribute("aria-selected", button.textContent === title);
    this.body.replaceChildren(...this.runs.filter((run) => run.document[key]?.length).flatMap((run) =>
      this.runs.length > 1 ? [element("h4", {textContent: run.document.name}), make(run)] : [make(run)]));
  }
  update() { if (this.current) this.open(...this.current); }
}

/** One line a run: whether it can be relied on. */
export function verdictLines(root, runs) {
  root.replaceChildren(...runs.map((run) => {
    const verdict = run.document.verdict;
    if (!verdict) return "";
    const names = {good: "no objection", doubt: "check the warnings", bad: "unreliable"};
    return element("p", {className: `verdict ${verdict.level}`}, element("b", {textContent: names[verdict.level]}),
                   ` ${runs.length > 1 ? run.document.name + ": " : ""}${verdict.text}`);
  }));
}
