// Draws the particles of one solver by WebGL 2.

const vertex = `#version 300 es
precision highp float;
in vec3 a, b, start;         // in 16 bits, of the frames around and of the first one
in float kindA, kindB;       // 0 water, 1 wall, 2 dummy, 5 lost
in float valueA, valueB;     // 8 bits
uniform vec4 gridA, gridB, gridStart;  // origin and step
uniform vec2 rangeA, rangeB; // least and largest value
uniform float share;         // between the frames
uniform float exaggeration;  // of displacements
uniform vec2 scale;          // values at both ends of the colours
uniform mat4 matrix;
uniform float size;          // in pixels, at a depth of one
uniform float walls;
uniform vec3 colors[9];
uniform vec3 plain;
uniform float useColors;
out vec3 color;
out float pixels;
float value(float byte, vec2 range) { return range.x + (range.y - range.x) * byte * byte / 65025.0; }
void main() {
  float s = kindA == kindB ? share : 0.0;
  vec3 now = mix(gridA.xyz + gridA.w * a, gridB.xyz + gridB.w * b, s);
  vec3 rest = gridStart.xyz + gridStart.w * start;
  gl_Position = matrix * vec4(rest + exaggeration * (now - rest), 1.0);
  gl_PointSize = max(1.5, size / gl_Position.w);
  float v = mix(value(valueA, rangeA), value(valueB, rangeB), s);
  float place = clamp((v - scale.x) / max(scale.y - scale.x, 1e-30), 0.0, 1.0) * 8.0;
  int k = int(min(place, 7.0));
  color = useColors > 0.5 ? mix(colors[k], colors[k + 1], place - float(k)) : plain;
  if (kindA > 0.5) {
    color = kindA < 1.5 ? vec3(0.62, 0.65, 0.70) : vec3(0.76, 0.78, 0.81);
    gl_PointSize = max(1.5, gl_PointSize * 0.92);
  }
  pixels = gl_PointSize;
  if (kindA > 2.5 || (kindA > 0.5 && walls < 0.5)) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}`;

const fragment = `#version 300 es
precision highp float;
in vec3 color;
in float pixels;
uniform float alpha, shaded, square;
out vec4 result;
void main() {
  vec2 p = 2.0 * gl_PointCoord - 1.0;
  float r = dot(p, p);
  bool whole = square > 0.5 || (shaded < 0.5 && pixels < 9.0);  // a disc of so few pixels is a square
  if (!whole && r > 1.0) discard;
  float light = shaded > 0.5 ? 0.55 + 0.45 * sqrt(max(0.0, 1.0 - r)) * (0.8 - 0.2 * p.y) / 0.9 : 1.0;
  float edge = whole || shaded > 0.5 ? 1.0 : 1.0 - smoothstep(0.75, 1.0, r);
  result = vec4(color * min(light, 1.0), alpha * edge);
}`;

function compiled(gl, kind, source) {
  const shader = gl.createShader(kind);
  gl.shaderSource(shader, source);
  gl.compileShader(shader);
  if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
  return shader;
}

export class ParticleProgram {
  constructor(gl) {
    this.gl = gl;
    const program = this.program = gl.createProgram();
    gl.attachShader(program, compiled(gl, gl.VERTEX_SHADER, vertex));
    gl.attachShader(program, compiled(gl, gl.FRAGMENT_SHADER, fragment));
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
    this.places = {};
    for (let k = 0; k < gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS); ++k) {
      const name = gl.getActiveUniform(program, k).name;
      this.places[name.replace("[0]", "")] = gl.getUniformLocation(program, name);
    }
  }
  attribute(name) { return this.gl.getAttribLocation(this.program, name); }
}

/** Buffers of one solver of one run, filled with the frames that are shown. */
export class Particles {
  constructor(program, frames) {
    this.gl = program.gl;
    this.program = program;
    this.frames = frames;
    this.buffers = {};
    for (const name of ["a", "b", "start", "kindA", "kindB", "valueA", "valueB"]) this.buffers[name] = this.gl.createBuffer();
    this.loaded = {};
  }

  load(name, key, data) {
    if (this.loaded[name] === key) return;
    this.loaded[name] = key;
    this.gl.bindBuffer(this.gl.ARRAY_BUFFER, this.buffers[name]);
    this.gl.bufferData(this.gl.ARRAY_BUFFER, data, this.gl.DYNAMIC_DRAW);
  }

  bind(name, components, type) {
    const {gl} = this, at = this.program.attribute(name);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffers[name]);
    gl.enableVertexAttribArray(at);
    gl.vertexAttribPointer(at, components, type, false, 0, 0);
  }

  /** `style`: quantity (its number, or -1), scale, colors, plain, alpha, size, square, shaded, walls, exaggeration. */
  draw(camera, {k, next, share}, style) {
    const {gl} = this, p = this.program.places;
    const a = this.frames[k], b = this.frames[next] ?? a, first = this.frames[0];
    if (!a || !first) return;
    gl.useProgram(this.program.program);
    const n = a.chunk.particles, none = () => new Uint8Array(n), q = Math.max(0, style.quantity);
    this.load("a", k, a.position);
    this.load("b", a === b ? k : next, b.position);
    this.load("start", 0, first.position);
    this.load("kindA", k, a.kind ?? none());
    this.load("kindB", next, b.kind ?? none());
    this.load("valueA", `${q} ${k}`, a.quantities[q] ?? none());
    this.load("valueB", `${q} ${next}`, b.quantities[q] ?? none());
    for (const name of ["a", "b", "start"]) this.bind(name, a.chunk.components, gl.UNSIGNED_SHORT);
    for (const name of ["kindA", "kindB", "valueA", "valueB"]) this.bind(name, 1, gl.UNSIGNED_BYTE);
    const grid = ({chunk}) => [chunk.origin[0], chunk.origin[1], chunk.origin[2] ?? 0, chunk.step];
    const range = ({chunk}) => [chunk.quantities[q]?.min ?? 0, chunk.quantities[q]?.max ?? 0];
    gl.uniform4fv(p.gridA, grid(a));
    gl.uniform4fv(p.gridB, grid(b));
    gl.uniform4fv(p.gridStart, grid(first));
    gl.uniform2fv(p.rangeA, range(a));
    gl.uniform2fv(p.rangeB, range(b));
    gl.uniform1f(p.share, share);
    gl.uniform1f(p.exaggeration, style.exaggeration);
    gl.uniform2fv(p.scale, style.scale);
    gl.uniformMatrix4fv(p.matrix, false, camera.matrix());
    gl.uniform1f(p.size, style.size);
    gl.uniform1f(p.walls, style.walls ? 1 : 0);
    gl.uniform3fv(p.colors, style.colors.flat());
    gl.uniform3fv(p.plain, style.plain);
    gl.uniform1f(p.useColors, style.quantity >= 0 ? 1 : 0);
    gl.uniform1f(p.alpha, style.alpha);
    gl.uniform1f(p.shaded, style.shaded ? 1 : 0);
    gl.uniform1f(p.square, style.square ? 1 : 0);
    gl.drawArrays(gl.POINTS, 0, n);
  }
}
