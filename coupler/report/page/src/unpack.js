// Numbers as coupler/report/packing.cpp and packed_frames.cpp have packed them.

/** Bytes of a zlib stream in base64. */
export async function inflate(base64) {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let k = 0; k < text.length; ++k) bytes[k] = text.charCodeAt(k);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** `count` values of `size` bytes whose bytes of equal weight lie together, from `at` on. */
function gathered(bytes, at, count, size) {
  const out = new Uint8Array(count * size);
  for (let b = 0; b < size; ++b) {
    const plane = at + b * count;
    for (let k = 0; k < count; ++k) out[k * size + b] = bytes[plane + k];
  }
  return out.buffer;
}

/** Histories by name: {name: {unit, exact, time, values}}, of all tables of a run. */
export async function histories(tables) {
  const out = new Map();
  for (const table of tables) {
    const bytes = await inflate(table.data);
    const rows = table.rows;
    const time = new Float64Array(gathered(bytes, 0, rows, 8));
    table.columns.slice(1).forEach((column, k) => {
      const values = new Float32Array(gathered(bytes, rows * (8 + 4 * k), rows, 4));
      out.set(column.name, {unit: column.unit, exact: table.exact, time, values});
    });
  }
  return out;
}

/** One coordinate of a frame, from what the two frames before let expect. */
function coordinate(bytes, at, count, axis, components, last, before, out) {
  for (let k = 0; k < count; ++k) {
    const word = bytes[at + k] | bytes[at + count + k] << 8;
    const difference = word >>> 1 ^ -(word & 1);
    const i = k * components + axis;
    const expected = !last ? 0 : before ? 2 * last[i] - before[i] : last[i];
    out[i] = expected + difference;  // of 16 bits: wraps as it did when it was packed
  }
}

function summed(bytes, at, count, last) {
  const out = new Uint8Array(count);
  for (let k = 0; k < count; ++k) out[k] = (last ? last[k] : 0) + bytes[at + k];
  return out;
}

/** Frames of a chunk: [{chunk, position (16 bits, a particle's coordinates together), kind, quantities}]. */
export async function frames(chunk) {
  const bytes = await inflate(chunk.data);
  delete chunk.data;
  const {particles: n, components: c} = chunk;
  const out = [];
  let at = 0;
  for (let f = 0; f < chunk.frames; ++f) {
    const last = out[f - 1], before = out[f - 2];
    const position = new Uint16Array(n * c);
    for (let axis = 0; axis < c; ++axis, at += 2 * n)
      coordinate(bytes, at, n, axis, c, last?.position, before?.position, position);
    let kind = null;
    if (chunk.kinds) {
      kind = summed(bytes, at, n, last?.kind);
      at += n;
    }
    const quantities = [];
    for (let q = 0; q < chunk.quantities.length; ++q, at += n)
      quantities.push(summed(bytes, at, n, last?.quantities[q]));
    out.push({chunk, position, kind, quantities});
  }
  return out;
}

/** The value of a quantity's byte. */
export function valueOf(quantity, byte) {
  return quantity.min + (quantity.max - quantity.min) * (byte / 255) ** 2;
}
