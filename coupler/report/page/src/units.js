// Numbers and units for readers.

const prefixed = {m: [["mm", 1e3], ["m", 1]], Pa: [["Pa", 1], ["kPa", 1e-3], ["MPa", 1e-6]], N: [["N", 1], ["kN", 1e-3]],
                  J: [["mJ", 1e3], ["J", 1], ["kJ", 1e-3]], "Pa s": [["Pa s", 1], ["kPa s", 1e-3]]};

/** Unit and factor so that values up to `largest` have few digits. */
export function readable(unit, largest) {
  const choices = prefixed[unit];
  if (!choices || !(largest > 0)) return {unit: unit === "-" ? "" : unit, factor: 1};
  let best = choices[0];
  for (const choice of choices)
    if (largest * choice[1] >= 0.5) best = choice;
  return {unit: best[0], factor: best[1]};
}

/** Four digits, without an exponent where that is short. */
export function digits(value, count = 4) {
  if (value === null || value === undefined || Number.isNaN(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e6 || size < 1e-4) return value.toExponential(count - 1).replace("e+", "e");
  if (Number.isInteger(value)) return String(value);
  return String(Number(value.toPrecision(count)));
}

export function withUnit(value, unit) {
  const {unit: shown, factor} = readable(unit, Math.abs(value));
  return value === null ? "–" : `${digits(value * factor)} ${shown}`.trim();
}

/** Steps of 1, 2 or 5 times a power of ten: about `count` between two values. */
export function ticks(low, high, count) {
  const rough = (high - low) / Math.max(1, count);
  if (!(rough > 0)) return [];
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = power * [1, 2, 5, 10].find((m) => m * power >= rough * 0.999);
  const out = [];
  for (let k = Math.ceil(low / step); k * step <= high + 1e-9 * step; ++k) out.push(Number((k * step).toPrecision(12)));
  return out;
}
