// From places of the scene to pixels, in two and three dimensions. Up is the last coordinate.

/** Two dimensions: a middle and pixels a metre. */
export class FlatCamera {
  constructor(box) {
    this.box = box;
    this.home();
  }
  home() {
    this.middle = [0, 1].map((a) => (this.box.min[a] + this.box.max[a]) / 2);
    this.zoom = 1;
  }
  resize(width, height, margin) {
    Object.assign(this, {width, height, margin});
    const w = width - margin.left - margin.right, h = height - margin.top - margin.bottom;
    this.fit = Math.max(1e-9, Math.min(w / (this.box.max[0] - this.box.min[0]), h / (this.box.max[1] - this.box.min[1])));
    this.center = [margin.left + w / 2, margin.top + h / 2];
  }
  get scale() { return this.fit * this.zoom; }  // pixels a metre
  project([x, y]) {
    return [this.center[0] + (x - this.middle[0]) * this.scale, this.center[1] - (y - this.middle[1]) * this.scale, 0];
  }
  place(px, py) {
    return [this.middle[0] + (px - this.center[0]) / this.scale, this.middle[1] - (py - this.center[1]) / this.scale];
  }
  pan(dx, dy) {
    this.middle[0] -= dx / this.scale;
    this.middle[1] += dy / this.scale;
  }
  orbit(dx, dy) { this.pan(dx, dy); }
  zoomAt(px, py, factor) {
    const before = this.place(px, py);
    this.zoom = Math.min(2000, Math.max(0.2, this.zoom * factor));
    const after = this.place(px, py);
    for (const a of [0, 1]) this.middle[a] += before[a] - after[a];
  }
  /** Matrix (columns) from metres to clip space. */
  matrix() {
    const {width, height, scale, middle, center} = this;
    const ox = 2 * center[0] / width - 1, oy = 1 - 2 * center[1] / height;
    const sx = 2 * scale / width, sy = 2 * scale / height;
    return [sx, 0, 0, 0, 0, sy, 0, 0, 0, 0, 1, 0, ox - sx * middle[0], oy - sy * middle[1], 0, 1];
  }
  pixelsAMetre() { return this.scale; }
}

const multiply = (a, b) => Array.from({length: 16}, (_, i) => {
  const row = i % 4, column = i - row;
  return a[row] * b[column] + a[row + 4] * b[column + 1] + a[row + 8] * b[column + 2] + a[row + 12] * b[column + 3];
});

/** Three dimensions: an eye that goes around a target. */
export class OrbitCamera {
  constructor(box) {
    this.box = box;
    this.home();
  }
  home() {
    const {min, max} = this.box;
    this.target = [0, 1, 2].map((a) => (min[a] + max[a]) / 2);
    this.size = Math.hypot(...[0, 1, 2].map((a) => max[a] - min[a]));
    this.azimuth = -1.0;
    this.elevation = 0.42;
    this.distance = 1.35 * this.size;
  }
  resize(width, height, margin) { Object.assign(this, {width, height, margin}); }
  axes() {
    const ca = Math.cos(this.azimuth), sa = Math.sin(this.azimuth);
    const ce = Math.cos(this.elevation), se = Math.sin(this.elevation);
    return {right: [-sa, ca, 0], up: [-ca * se, -sa * se, ce], back: [ca * ce, sa * ce, se]};
  }
  eye() {
    const {back} = this.axes();
    return this.target.map((x, a) => x + this.distance * back[a]);
  }
  matrix() {
    const {right, up, back} = this.axes(), eye = this.eye();
    const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    const view = [right[0], up[0], back[0], 0, right[1], up[1], back[1], 0, right[2], up[2], back[2], 0,
                  -dot(right, eye), -dot(up, eye), -dot(back, eye), 1];
    const near = this.distance / 200, far = this.distance + 4 * this.size;
    const f = this.focal, aspect = this.width / this.height;
    return multiply([f / aspect, 0, 0, 0, 0, f, 0, 0, 0, 0, (far + near) / (near - far), -1, 0, 0,
                     2 * far * near / (near - far), 0], view);
  }
  get focal() { return 2.2; }
  /** At a depth of one metre. */
  pixelsAMetre() { return this.focal * this.height / 2; }
  project(x) {
    const m = this.matrix();
    const at = (row) => m[row] * x[0] + m[row + 4] * x[1] + m[row + 8] * x[2] + m[row + 12];
    const w = at(3);
    return w <= 0 ? null : [(1 + at(0) / w) * this.width / 2, (1 - at(1) / w) * this.height / 2, w];
  }
  pan(dx, dy) {
    const {right, up} = this.axes(), metre = this.distance / this.pixelsAMetre();
    this.target = this.target.map((x, a) => x + metre * (-dx * right[a] + dy * up[a]));
  }
  orbit(dx, dy) {
    this.azimuth -= 0.008 * dx;
    this.elevation = Math.min(1.55, Math.max(-1.55, this.elevation + 0.008 * dy));
  }
  zoomAt(px, py, factor) { this.distance = Math.min(20 * this.size, Math.max(this.size / 200, this.distance / factor)); }
}
