// The moving picture: particles by WebGL, lines and labels over it, and what the mouse does with them.
import {FlatCamera, OrbitCamera} from "./camera.js";
import {runColors, scales} from "./colors.js";
import {drawAxes, drawParts, drawRunNames, drawScale} from "./overlay.js";
import {ParticleProgram, Particles} from "./particles.js";
import {digits, readable, withUnit} from "./units.js";
import {valueOf} from "./unpack.js";

export const titles = {pressure: "water: pressure", speed: "speed", von_mises: "bodies: von Mises stress"};
const rgb = (hex) => [1, 3, 5].map((k) => parseInt(hex.slice(k, k + 2), 16) / 255);

/** Least and largest of all but a few of many values. */
function most(values, share) {
  const sorted = Float32Array.from(values).sort();
  const at = (q) => sorted[Math.round(q * (sorted.length - 1))];
  return [at(share), at(1 - share)];
}

/** Up to `most` numbers below `count`, spread over all rows and columns of a lattice: 7919 is a prime. */
function* spread(count, most) {
  for (let k = 0; k < Math.min(count, most); ++k) yield count <= most ? k : k * 7919 % count;
}

/** Coordinates along an axis of particles that are not walls, of all frames: some of them. */
function sampled(frames, axis) {
  const values = [], there = frames.filter(Boolean);
  for (const {chunk, position, kind} of there) {
    for (const k of spread(chunk.particles, Math.max(200, 200000 / there.length)))
      if (!kind?.[k]) values.push(chunk.origin[axis] + chunk.step * position[k * chunk.components + axis]);
  }
  return values;
}

/** Box around bodies, all water but a few drops, and what is drawn of the case; of a tank in two dimensions its floor and sides. */
function boxOf(runs) {
  const d = runs[0].dimension, min = Array(d).fill(Infinity), max = Array(d).fill(-Infinity);
  const add = (axis, low, high) => { min[axis] = Math.min(min[axis], low); max[axis] = Math.max(max[axis], high); };
  for (const run of runs) {
    for (const part of run.scene?.outlines ?? [])
      for (const line of part.lines) for (const x of line)
        x.forEach((v, axis) => { if (part.kind !== "tank" || axis < d - 1) add(axis, v, v); else add(axis, v, -Infinity); });
    for (const [member, frames] of Object.entries(run.members))
      for (let axis = 0; axis < d; ++axis) {
        const values = sampled(frames, axis);
        if (values.length) add(axis, ...most(values, member === "solid" ? 0 : 0.0005));
      }
  }
  if (!min.every(Number.isFinite) || !max.every(Number.isFinite)) return {min: Array(d).fill(0), max: Array(d).fill(1)};
  const margin = 0.03 * Math.max(...max.map((v, a) => v - min[a]));
  return {min: min.map((v) => v - (d === 2 ? margin : 0)), max: max.map((v) => v + (d === 2 ? margin : 0))};
}

export class Scene {
  constructor(root, runs) {
    this.runs = runs;
    this.dimension = runs[0].dimension;
    this.canvas = root.querySelector("canvas.particles");
    this.over = root.querySelector("canvas.over");
    this.tip = root.querySelector(".tip");
    this.gl = this.canvas.getContext("webgl2", {antialias: false, alpha: false});
    if (!this.gl) throw new Error("this browser has no WebGL 2: the scene cannot be drawn; histories and tables are below");
    this.program = new ParticleProgram(this.gl);
    this.drawn = new Map();
    this.tops = new Map();
    this.time = 0;
    this.settings = {fluid: "pressure", solid: "von_mises", walls: true, labels: false, exaggeration: 1, top: {},
                     kinds: new Set(["probe", "tank", "obstacle", "clamp", "support"]), hidden: new Set()};
    this.fit();
    this.listen();
    new ResizeObserver(() => { this.resize(); this.draw(); }).observe(this.over);
  }

  /** Once more frames are there. */
  fit() {
    const box = boxOf(this.runs);
    this.camera = this.dimension === 2 ? new FlatCamera(box) : new OrbitCamera(box);
    this.resize();
  }

  resize() {
    const {clientWidth: w, clientHeight: h} = this.over, ratio = window.devicePixelRatio || 1;
    for (const canvas of [this.canvas, this.over]) {
      canvas.width = Math.round(w * ratio);
      canvas.height = Math.round(h * ratio);
    }
    this.ratio = ratio;
    delete this.over.dataset.drawn;
    this.camera.resize(w, h, this.dimension === 2 ? {left: 58, right: 14, top: 14, bottom: 48} : {left: 0, right: 0, top: 0, bottom: 0});
  }

  quantityOf(member, frame) {
    return frame ? frame.chunk.quantities.findIndex((q) => q.name === this.settings[member]) : -1;
  }

  /** The value below which 99 of 100 positive ones are, of what a member is coloured by. */
  topOf(member) {
    const name = this.settings[member], key = `${member} ${name}`;
    if (this.settings.top[key] > 0) return this.settings.top[key];
    const frames = this.runs.map((run) => run.members[member]?.length ?? 0).join();
    if (this.tops.get(key)?.frames === frames) return this.tops.get(key).top;
    const values = [];
    for (const run of this.runs)
      for (const frame of run.members[member] ?? []) {
        const q = this.quantityOf(member, frame);
        if (q < 0) continue;
        const bytes = frame.quantities[q];
        for (const k of spread(bytes.length, 500)) {
          const v = frame.kind && frame.kind[k] > 0 ? 0 : valueOf(frame.chunk.quantities[q], bytes[k]);
          if (v > 0) values.push(v);
        }
      }
    values.sort((a, b) => a - b);
    const top = values[Math.floor(0.99 * (values.length - 1))] || 1;
    this.tops.set(key, {frames, top});
    return top;
  }

  particles(run, member) {
    const key = run.members[member];
    if (!this.drawn.has(key)) this.drawn.set(key, new Particles(this.program, key));
    return this.drawn.get(key);
  }

  drawMember(run, index, member) {
    const frames = run.members[member];
    if (!frames?.length) return;
    const {gl, settings} = this, first = index === this.colored, spacing = run.scene.spacing[member];
    const thinned = member === "fluid" ? (run.scene.every_particle ?? 1) ** (1 / this.dimension) : 1;
    const quantity = first ? this.quantityOf(member, frames[0]) : -1;
    const plain = !first ? rgb(runColors[index % runColors.length]) : member === "fluid" ? [0.45, 0.68, 0.88] : [0.91, 0.45, 0.23];
    gl[first ? "disable" : "enable"](gl.BLEND);
    if (this.dimension === 2) gl.enable(gl.BLEND);
    this.particles(run, member).draw(this.camera, run.around(this.time), {
      quantity, plain, scale: [0, this.topOf(member)], alpha: first ? 1 : 0.5,
      colors: member === "solid" && settings.solid === "von_mises" ? scales.stress : settings[member] === "speed" ? scales.speed : scales.viridis,
      size: (member === "solid" ? 1.12 : (this.dimension === 2 ? 1.5 : 1.3) * thinned) * spacing * this.camera.pixelsAMetre() * this.ratio * (first ? 1 : 0.7),
      square: member === "solid" && this.dimension === 2, shaded: this.dimension === 3, walls: settings.walls && first,
      exaggeration: member === "solid" ? settings.exaggeration : 1});
  }

  draw() {
    const {gl, camera} = this;
    this.colored = this.runs.findIndex((_, k) => !this.settings.hidden.has(k));
    gl.viewport(0, 0, this.canvas.width, this.canvas.height);
    gl.clearColor(1, 1, 1, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl[this.dimension === 3 ? "enable" : "disable"](gl.DEPTH_TEST);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    this.runs.forEach((run, k) => {
      if (this.settings.hidden.has(k)) return;
      for (const member of ["fluid", "solid"]) this.drawMember(run, k, member);
    });
    this.drawOver();
  }

  /** Lines, axes and scales: only where they are others than those that are drawn. */
  drawOver() {
    const {camera, settings} = this, run = this.runs[Math.max(0, this.colored)];
    const parts = run.scene?.outlines ?? [], frame = parts.some((part) => part.poses) ? run.around(this.time).k : 0;
    const key = JSON.stringify([camera.matrix(), camera.width, camera.height, this.ratio, frame, this.colored, settings.fluid, settings.solid,
                                this.topOf("fluid"), this.topOf("solid"), settings.labels, [...settings.kinds]]);
    if (key === this.over.dataset.drawn) return;
    this.over.dataset.drawn = key;
    const g = this.over.getContext("2d");
    g.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    g.clearRect(0, 0, camera.width, camera.height);
    drawParts(g, camera, parts, frame, settings.kinds, settings.labels);
    drawAxes(g, camera, this.dimension);
    this.drawScales(g, run);
    if (this.runs.length > 1) drawRunNames(g, this.dimension === 2 ? 70 : 14, 20, this.runs);
  }

  drawScales(g, run) {
    let x = this.camera.width - 14;
    for (const member of ["solid", "fluid"]) {
      const frame = run.members[member]?.[0], q = this.quantityOf(member, frame);
      if (q < 0) continue;
      const {name, unit} = frame.chunk.quantities[q], high = this.topOf(member), shown = readable(unit, high);
      const whose = name === "speed" ? (member === "fluid" ? "water: " : "bodies: ") : "";
      x -= 180;
      drawScale(g, x, 24, 160, {title: `${whose}${titles[name]} [${shown.unit}]`, low: 0, high, factor: shown.factor,
                                colors: name === "von_mises" ? scales.stress : name === "speed" ? scales.speed : scales.viridis});
      x -= 24;
    }
  }

  /** The particle nearest to a pixel: {member, place, frame, k} or null. */
  nearest(px, py) {
    let best = null, distance = 14 ** 2;
    this.runs.forEach((run, index) => {
      if (this.settings.hidden.has(index)) return;
      for (const [member, frames] of Object.entries(run.members)) {
        const {k, next, share} = run.around(this.time), frame = frames[share > 0.5 ? next : k];
        if (!frame) continue;
        const {origin, step, components: c, particles: n} = frame.chunk;
        for (let p = 0; p < n; ++p) {
          if (frame.kind && frame.kind[p] > (this.settings.walls ? 2 : 0)) continue;
          const x = Array.from({length: c}, (_, a) => origin[a] + step * frame.position[p * c + a]);
          const at = this.camera.project(x);
          if (!at) continue;
          const d = (at[0] - px) ** 2 + (at[1] - py) ** 2;
          if (d < distance) [best, distance] = [{run, member, place: x, frame, p}, d];
        }
      }
    });
    return best;
  }

  showTip(event) {
    const bounds = this.over.getBoundingClientRect();
    const px = event.clientX - bounds.left, py = event.clientY - bounds.top;
    const hit = this.nearest(px, py);
    this.tip.hidden = !hit;
    if (!hit) return;
    const {frame, p, member} = hit, kind = frame.kind?.[p] ?? 0;
    const rows = [kind ? "wall" : member === "fluid" ? "water" : "body",
                  hit.place.map((v, a) => `${"xyz"[a]} = ${digits(v)} m`).join(", ")];
    frame.chunk.quantities.forEach((quantity, q) =>
      rows.push(`${quantity.name.replace("_", " ")}: about ${withUnit(Number(valueOf(quantity, frame.quantities[q][p]).toPrecision(3)), quantity.unit)}`));
    if (this.runs.length > 1) rows.unshift(hit.run.document.name);
    this.tip.replaceChildren(...rows.map((row) => Object.assign(document.createElement("div"), {textContent: row})));
    this.tip.style.transform = `translate(${Math.min(px + 14, bounds.width - 190)}px, ${Math.max(0, py - 70)}px)`;
  }

  listen() {
    const {over} = this;
    let drag = null;
    over.addEventListener("pointerdown", (event) => {
      drag = {x: event.clientX, y: event.clientY, pan: event.shiftKey || event.button === 2 || this.dimension === 2};
      over.setPointerCapture(event.pointerId);
      this.tip.hidden = true;
    });
    over.addEventListener("pointermove", (event) => {
      if (!drag) return this.showTip(event);
      const dx = event.clientX - drag.x, dy = event.clientY - drag.y;
      this.camera[drag.pan ? "pan" : "orbit"](dx, dy);
      Object.assign(drag, {x: event.clientX, y: event.clientY});
      this.draw();
    });
    over.addEventListener("pointerup", () => drag = null);
    over.addEventListener("pointerleave", () => this.tip.hidden = true);
    over.addEventListener("contextmenu", (event) => event.preventDefault());
    over.addEventListener("dblclick", () => { this.camera.home(); this.draw(); });
    over.addEventListener("wheel", (event) => {
      event.preventDefault();
      const bounds = over.getBoundingClientRect();
      this.camera.zoomAt(event.clientX - bounds.left, event.clientY - bounds.top, Math.exp(-0.0015 * event.deltaY));
      this.draw();
    }, {passive: false});
  }
}
