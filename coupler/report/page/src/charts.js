// Histories over time by uPlot, with the reference curves and a line at the time of the scene.
import uPlot from "uplot";
import {referenceColors, runColors} from "./colors.js";
import {spectrum} from "./spectrum.js";
import {digits, readable} from "./units.js";

const lineStyles = [[], [6, 4], [2, 3], [8, 3, 2, 3], [1, 4]];
const seriesColors = ["#14213d", "#d1495b", "#1b998b", "#e19c2a", "#8f5fb7"];
const sync = uPlot.sync("time");

/** Curves of a chart: [{label, time, values, color, width, dash}]. */
function curvesOf(group, runs) {
  const curves = [];
  for (const run of runs)
    for (const reference of run.document.references ?? []) {
      const k = group.columns.indexOf(reference.column);
      if (k < 0 || curves.some((c) => c.label.startsWith(reference.name) && c.column === reference.column)) continue;
      const label = group.columns.length > 1 ? `${reference.name}, ${group.labels[k]}` : reference.name;
      curves.push({label, column: reference.column, time: reference.time, values: reference.values, width: 1, reference: true,
                   color: referenceColors[curves.length % referenceColors.length], dash: curves.length >= 10 ? [4, 3] : [], exact: true});
    }
  runs.forEach((run, r) => group.columns.forEach((column, k) => {
    const history = run.histories.get(column);
    if (!history) return;
    const several = runs.length > 1;
    curves.push({label: several ? `${run.document.name}${group.columns.length > 1 ? ", " + group.labels[k] : ""}` : group.labels[k],
                 time: history.time, values: history.values, exact: history.exact, width: 1.6,
                 color: several ? runColors[r % runColors.length] : seriesColors[k % seriesColors.length],
                 dash: several ? lineStyles[k % lineStyles.length] : []});
  }));
  return curves;
}

/** As uPlot wants it: one axis for all, with gaps where a curve has no value; increasing, without doubles. */
function joined(curves, axis, value) {
  const tables = curves.map((curve) => {
    const xs = [], ys = [];
    for (let k = 0; k < curve[axis].length; ++k) {
      if (xs.length && curve[axis][k] <= xs.at(-1)) continue;
      xs.push(curve[axis][k]);
      ys.push(value(curve, k));
    }
    return [xs, ys];
  });
  const same = tables.every(([xs]) => xs.length === tables[0][0].length && xs[0] === tables[0][0][0] && xs.at(-1) === tables[0][0].at(-1));
  if (same && !curves.some((c) => c.reference)) return [tables[0][0], ...tables.map(([, ys]) => ys)];
  return uPlot.join(tables);
}

export class Chart {
  /** `pick(t)`: what happens with the time under the mouse; `playing()`: whether the scene moves. */
  constructor(root, group, runs, pick, playing) {
    Object.assign(this, {group, runs, pick, playing, log: false, frequency: false, time: 0});
    this.root = document.createElement("section");
    this.root.className = "chart";
    this.root.innerHTML = `<header><h3></h3><span class="note"></span><div class="switches">
      <button data-do="log" aria-pressed="false" title="logarithm of the absolute values">log</button>
      <button data-do="frequency" aria-pressed="false" title="single-sided amplitude spectrum">spectrum</button></div></header><div class="plot"></div>`;
    this.root.querySelector("h3").textContent = group.title;
    this.plotRoot = this.root.querySelector(".plot");
    this.root.querySelector(".switches").addEventListener("click", (event) => {
      const what = event.target.dataset.do;
      if (!what) return;
      this[what] = !this[what];
      event.target.setAttribute("aria-pressed", this[what]);
      this.build();
    });
    root.append(this.root);
    new IntersectionObserver(([entry]) => {
      this.visible = entry.isIntersecting;
      if (this.visible && !this.plot) this.build();
      this.moveLine();
    }, {rootMargin: "300px"}).observe(this.root);
    new ResizeObserver(() => this.plot?.setSize(this.size())).observe(this.plotRoot);
  }

  size() { return {width: Math.max(200, this.plotRoot.clientWidth), height: 250}; }

  data(curves) {
    const log = this.log || this.frequency, value = (curve, k) => {
      const v = curve.shown[k] * this.factor;
      return !Number.isFinite(v) ? null : log ? (Math.abs(v) > this.floor ? Math.abs(v) : null) : v;
    };
    return joined(curves, "axis", value);
  }

  /** Curves over time, or their spectra. */
  curves() {
    const all = curvesOf(this.group, this.runs);
    const note = this.root.querySelector(".note");
    note.textContent = all.some((c) => !c.exact) ? "least and largest values of each part of the run" : "";
    if (!this.frequency) return all.map((c) => ({...c, axis: c.time, shown: c.values}));
    if (all.some((c) => !c.exact)) note.textContent = "spectrum left out: the page has not all windows of it";
    return all.filter((c) => c.exact).flatMap((c) => {
      const found = spectrum(c.time, c.values);
      return found ? [{...c, axis: found.frequency, shown: found.amplitude}] : [];
    });
  }

  build() {
    const curves = this.curves();
    this.plot?.destroy();
    this.plot = null;
    if (!curves.length) return;
    let largest = 0;
    for (const c of curves) if (!c.reference) for (const v of c.shown) if (Math.abs(v) > largest) largest = Math.abs(v);
    const {unit, factor} = readable(this.group.unit, largest);
    this.factor = factor;
    this.floor = 1e-9 * largest * factor;  // of logarithms: below it is rounding
    const data = this.data(curves);
    const bracket = (name, u) => u ? `${name} [${u}]` : name;
    const log = this.log || this.frequency;
    const options = {
      ...this.size(), cursor: {y: false, drag: {x: true, y: true, uni: 20}, sync: this.frequency ? undefined : {key: sync.key, setSeries: false}},
      legend: {live: true},
      scales: {x: {time: false}, y: log ? {distr: 3} : {}},
      axes: [{label: this.frequency ? "f [Hz]" : "t [s]", labelSize: 18, size: 34, stroke: "#374151", grid: {stroke: "#eceff3"}, ticks: {stroke: "#c5ccd6"}},
             {label: bracket(this.log ? "absolute value" : this.frequency ? "amplitude" : short(this.group), unit), labelSize: 18, size: 58, stroke: "#374151",
              grid: {stroke: "#eceff3"}, ticks: {stroke: "#c5ccd6"}, values: (_, values) => values.map((v) => v === null ? "" : digits(v, 5))}],
      series: [{label: this.frequency ? "f" : "t", value: (_, v) => v === null ? "–" : `${digits(v, 5)} ${this.frequency ? "Hz" : "s"}`},
               ...curves.map((c) => ({label: c.label, stroke: c.color, width: c.width, dash: c.dash, alpha: c.reference ? 0.8 : 1, spanGaps: true,
                                      points: {show: false}, value: (_, v) => v === null || v === undefined ? "–" : `${digits(v)} ${unit}`}))],
    };
    if (this.frequency) options.scales.x.range = [0, this.frequencyEnd(curves)];
    this.plot = new uPlot(options, data, this.plotRoot);
    this.line = document.createElement("div");
    this.line.className = "now";
    this.plot.over.append(this.line);
    this.plot.over.addEventListener("mousemove", (event) => {
      if (this.frequency || this.playing() || event.buttons) return;
      this.pick(this.plot.posToVal(event.offsetX, "x"));
    });
    this.plot.over.addEventListener("click", (event) => { if (!this.frequency) this.pick(this.plot.posToVal(event.offsetX, "x")); });
    this.plot.hooks.draw = [...(this.plot.hooks.draw ?? []), () => this.moveLine()];
    this.moveLine();
  }

  /** Where most of the amplitude is: the axis ends at three times the highest frequency above a thousandth. */
  frequencyEnd(curves) {
    let end = 0;
    for (const c of curves) {
      const most = c.shown.reduce((a, b) => Math.max(a, b), 0);
      c.shown.forEach((v, k) => { if (v > 0.02 * most) end = Math.max(end, c.axis[k]); });
    }
    return Math.min(3 * end || 1, Math.max(...curves.map((c) => c.axis.at(-1))));
  }

  /** New data of a run that goes on. */
  update() {
    if (!this.plot) return;
    if (this.frequency) return this.build();
    this.plot.setData(this.data(this.curves()));
  }

  show(time, withValues) {
    this.time = time;
    if (!this.visible || !this.plot || this.frequency) return;
    this.moveLine();
    if (withValues && !this.plotRoot.matches(":hover")) this.plot.setCursor({left: this.plot.valToPos(time, "x"), top: 10}, false);
  }

  moveLine() {
    if (!this.line) return;
    const at = this.plot?.valToPos(this.time, "x") ?? -1;
    this.line.hidden = this.frequency || !(at >= 0 && at <= this.plot.over.clientWidth);
    this.line.style.transform = `translateX(${at}px)`;
  }
}

function short(group) {
  const names = {m: "length", Pa: "pressure", N: "load", J: "energy", "m/s": "speed", s: "time"};
  if (group.title.includes("displacement")) return "displacement";
  if (group.title.includes("level")) return "level";
  if (group.title.includes("front")) return "front";
  return names[group.unit] ?? group.labels[0];
}
