// Single-sided amplitude spectra.

/** In place, by Cooley and Tukey's radix 2. */
function transform(re, im) {
  const n = re.length;
  for (let i = 1, j = 0; i < n; ++i) {
    let bit = n >> 1;
    for (; j & bit; bit >>= 1) j ^= bit;
    j ^= bit;
    if (i < j) {
      [re[i], re[j]] = [re[j], re[i]];
      [im[i], im[j]] = [im[j], im[i]];
    }
  }
  for (let size = 2; size <= n; size *= 2) {
    for (let k = 0; k < size / 2; ++k) {
      const angle = -2 * Math.PI * k / size, c = Math.cos(angle), s = Math.sin(angle);
      for (let i = k; i < n; i += size) {
        const j = i + size / 2;
        const x = re[j] * c - im[j] * s, y = re[j] * s + im[j] * c;
        re[j] = re[i] - x;
        im[j] = im[i] - y;
        re[i] += x;
        im[i] += y;
      }
    }
  }
}

/** Values between the rows of a history, at a power of two of even steps, which are not longer than the median one. */
function evenly(time, values) {
  const rows = [...time.keys()].filter((k) => Number.isFinite(values[k]));
  if (rows.length < 16) return null;
  const steps = rows.slice(1).map((k, i) => time[k] - time[rows[i]]).sort((a, b) => a - b);
  const length = time[rows.at(-1)] - time[rows[0]], median = steps[steps.length >> 1];
  const n = Math.min(2 ** 17, 2 ** Math.ceil(Math.log2(length / median)));
  const out = new Float64Array(n), step = length / n;
  for (let k = 0, row = 0; k < n; ++k) {
    const t = time[rows[0]] + k * step;
    while (row < rows.length - 2 && time[rows[row + 1]] <= t) ++row;
    const a = rows[row], b = rows[row + 1];
    out[k] = values[a] + (values[b] - values[a]) * (t - time[a]) / (time[b] - time[a]);
  }
  return {values: out, step};
}

/** {frequency [Hz], amplitude}, or null for a history that is too short: 2 |F| / n, without a window function. */
export function spectrum(time, values) {
  const even = evenly(time, values);
  if (!even) return null;
  const n = even.values.length, im = new Float64Array(n);
  transform(even.values, im);
  const frequency = [], amplitude = [];
  for (let k = 1; k < n / 2; ++k) {
    frequency.push(k / (n * even.step));
    amplitude.push(2 * Math.hypot(even.values[k], im[k]) / n);
  }
  return {frequency, amplitude};
}
