// Lines, labels, axes and the colour scales over the picture of the particles.
import {css, runColors} from "./colors.js";
import {digits, ticks} from "./units.js";

export const kinds = {
  tank: {name: "tank", color: "#4a5260", width: 1.6}, water: {name: "water at t = 0", color: "#2f7fc1", width: 1.2, dash: [5, 4]},
  obstacle: {name: "obstacles", color: "#4a5260", width: 1.6}, body: {name: "bodies at t = 0", color: "#a0522d", width: 1.2, dash: [4, 3]},
  clamp: {name: "clamps", color: "#111827", width: 1.4, hatch: true}, support: {name: "supports", color: "#7c3aed", width: 1.4, hatch: true},
  extreme: {name: "walls at their extremes", color: "#d97706", width: 1.2, dash: [6, 3]}, path: {name: "paths of walls", color: "#d97706", width: 1.4},
  stairs: {name: "bodies on the lattice", color: "#dc2626", width: 1.4}, probe: {name: "probes", color: "#be123c", width: 1},
};

/** A point of a part that has moved: pose is the origin's place, then the axes. */
function moved(pose, x) {
  if (!pose) return x;
  const d = x.length;
  return x.map((_, row) => pose[row] + x.reduce((sum, xc, column) => sum + pose[d + column * d + row] * xc, 0));
}

function drawPart(g, camera, part, pose) {
  const style = kinds[part.kind];
  g.strokeStyle = g.fillStyle = style.color;
  g.lineWidth = style.width;
  g.setLineDash(style.dash ?? []);
  let first = null;
  for (const line of part.lines) {
    const points = line.map((x) => camera.project(moved(pose, x))).filter(Boolean);
    if (!points.length) continue;
    first ??= points[0];
    if (part.kind === "probe") {
      g.beginPath();
      g.arc(points[0][0], points[0][1], 4, 0, 7);
      g.stroke();
      continue;
    }
    g.beginPath();
    points.forEach(([px, py], k) => k ? g.lineTo(px, py) : g.moveTo(px, py));
    if (style.hatch && line.length > 2) {
      g.globalAlpha = 0.15;
      g.fill();
      g.globalAlpha = 1;
    }
    g.stroke();
  }
  g.setLineDash([]);
  return first;
}

/** A label that lies on no other one: moved up until it fits. */
function label(g, taken, text, [px, py], color) {
  const width = g.measureText(text).width + 6;
  let box = {x: px + 6, y: py - 18, w: width, h: 15};
  for (let tries = 0; tries < 12; ++tries) {
    const over = taken.some((o) => box.x < o.x + o.w && o.x < box.x + box.w && box.y < o.y + o.h && o.y < box.y + box.h);
    if (!over) break;
    box = {...box, y: box.y - 16};
  }
  taken.push(box);
  g.fillStyle = "rgba(255,255,255,0.85)";
  g.fillRect(box.x, box.y, box.w, box.h);
  g.fillStyle = color;
  g.textAlign = "left";
  g.textBaseline = "middle";
  g.fillText(text, box.x + 3, box.y + box.h / 2);
}

/** `shown`: names of kinds; `labels`: whether all parts have their names. */
export function drawParts(g, camera, parts, frame, shown, labels) {
  const taken = [];
  g.font = "11px system-ui, sans-serif";
  for (const part of parts) {
    if (!shown.has(part.kind)) continue;
    const at = drawPart(g, camera, part, part.poses?.[frame]);
    if (at && (part.kind === "probe" || labels)) label(g, taken, part.label, at, kinds[part.kind].color);
  }
}

function flatAxes(g, camera) {
  const {width, height, margin} = camera;
  const left = margin.left - 8, bottom = height - margin.bottom + 8;
  const low = camera.place(margin.left, height - margin.bottom), high = camera.place(width - margin.right, margin.top);
  g.fillStyle = "#fff";
  g.fillRect(0, 0, left, height);
  g.fillRect(0, bottom, width, height - bottom);
  g.strokeStyle = "#9aa3b2";
  g.fillStyle = "#374151";
  g.lineWidth = 1;
  g.beginPath();
  g.moveTo(left + 0.5, 4);
  g.lineTo(left + 0.5, bottom + 0.5);
  g.lineTo(width - 4, bottom + 0.5);
  g.stroke();
  g.textAlign = "center";
  g.textBaseline = "top";
  for (const x of ticks(low[0], high[0], (width - left) / 90)) {
    const [px] = camera.project([x, 0]);
    g.fillRect(Math.round(px), bottom, 1, 5);
    g.fillText(digits(x), px, bottom + 8);
  }
  g.textAlign = "right";
  g.textBaseline = "middle";
  for (const y of ticks(low[1], high[1], height / 60)) {
    const [, py] = camera.project([0, y]);
    g.fillRect(left - 4, Math.round(py), 5, 1);
    g.fillText(digits(y), left - 7, py);
  }
  g.textAlign = "right";
  g.fillText("x [m]", width - 6, bottom + 28);
  g.save();
  g.translate(11, 34);
  g.rotate(-Math.PI / 2);
  g.fillText("y [m]", 10, 0);
  g.restore();
}

function boxAxes(g, camera) {
  const {min, max} = camera.box;
  g.fillStyle = "#374151";
  g.strokeStyle = "#9aa3b2";
  g.textAlign = "center";
  g.textBaseline = "middle";
  const edge = (axis, at) => {
    const a = [...at], b = [...at];
    a[axis] = min[axis];
    b[axis] = max[axis];
    const pa = camera.project(a), pb = camera.project(b);
    if (!pa || !pb) return;
    g.beginPath();
    g.moveTo(pa[0], pa[1]);
    g.lineTo(pb[0], pb[1]);
    g.stroke();
    const middle = camera.project(camera.target) ?? pa;
    const away = [(pa[0] + pb[0]) / 2 - middle[0], (pa[1] + pb[1]) / 2 - middle[1]];
    const length = Math.hypot(...away) || 1, out = away.map((v) => 16 * v / length);
    const pixels = Math.hypot(pb[0] - pa[0], pb[1] - pa[1]);
    for (const x of ticks(min[axis], max[axis], Math.max(1, pixels / 70))) {
      const c = [...at];
      c[axis] = x;
      const p = camera.project(c);
      if (p) g.fillText(digits(x), p[0] + out[0], p[1] + out[1]);
    }
    g.font = "bold 12px system-ui, sans-serif";
    g.fillText(`${"xyz"[axis]} [m]`, (pa[0] + pb[0]) / 2 + 2.4 * out[0], (pa[1] + pb[1]) / 2 + 2.4 * out[1]);
    g.font = "11px system-ui, sans-serif";
  };
  const eye = camera.eye();
  const near = [0, 1].map((a) => eye[a] > camera.target[a] ? max[a] : min[a]);
  const far = [0, 1].map((a) => eye[a] > camera.target[a] ? min[a] : max[a]);
  edge(0, [0, near[1], min[2]]);
  edge(1, [near[0], 0, min[2]]);
  edge(2, [near[0], far[1], 0]);
}

export function drawAxes(g, camera, dimension) {
  g.font = "11px system-ui, sans-serif";
  if (dimension === 2) flatAxes(g, camera);
  else boxAxes(g, camera);
}

/** One colour scale: {title, colors, low, high, unit, factor}. */
export function drawScale(g, x, y, width, scale) {
  const gradient = g.createLinearGradient(x, 0, x + width, 0);
  scale.colors.forEach((c, k) => gradient.addColorStop(k / 8, css(c)));
  g.fillStyle = "rgba(255,255,255,0.82)";
  g.fillRect(x - 10, y - 17, width + 20, 45);
  g.fillStyle = gradient;
  g.fillRect(x, y, width, 9);
  g.strokeStyle = "#9aa3b2";
  g.strokeRect(x + 0.5, y + 0.5, width, 9);
  g.fillStyle = "#374151";
  g.textAlign = "left";
  g.textBaseline = "alphabetic";
  g.fillText(scale.title, x, y - 5);
  g.textAlign = "center";
  g.textBaseline = "top";
  const {low, high, factor} = scale;
  for (const v of ticks(low * factor, high * factor, 4))
    g.fillText(digits(v), x + width * (v / factor - low) / (high - low || 1), y + 13);
}

/** The names of several runs in their colours. */
export function drawRunNames(g, x, y, runs) {
  g.textAlign = "left";
  g.textBaseline = "middle";
  runs.forEach((run, k) => {
    g.fillStyle = "rgba(255,255,255,0.82)";
    g.fillRect(x - 4, y + 17 * k - 9, g.measureText(run.document.name).width + 26, 18);
    g.fillStyle = runColors[k % runColors.length];
    g.fillRect(x, y + 17 * k - 4, 12, 8);
    g.fillStyle = "#374151";
    g.fillText(run.document.name, x + 18, y + 17 * k);
  });
}
