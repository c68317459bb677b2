// A run as the page holds it.
import {frames, histories} from "./unpack.js";

export class Run {
  /** `document`: of RunDocument::read (coupler/report/run_document.hpp). */
  constructor(document) {
    this.members = {};  // frames by number, of "fluid" and "solid"
    this.take(document);
  }

  take(document) {
    this.document = document;
    this.scene = document.scene;
    this.times = document.scene?.times ?? [];
  }

  async unpackHistories() {
    this.histories = await histories(this.document.tables ?? []);
  }

  async unpackChunk(chunk) {
    const list = this.members[chunk.member] ??= [];
    const unpacked = await frames(chunk);
    unpacked.forEach((frame, k) => list[chunk.first + k] = frame);
  }

  get dimension() { return this.document.dimension; }
  get end() { return Math.max(this.document.status?.time ?? 0, this.times.at(-1) ?? 0); }

  /** The frame before time t, the next one and how far t is between them. */
  around(t) {
    const times = this.times;
    let low = 0, high = times.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (times[middle] <= t + 1e-12) low = middle;
      else high = middle - 1;
    }
    const next = Math.min(low + 1, times.length - 1);
    const length = times[next] - times[low];
    return {k: low, next, share: length > 0 ? Math.min(1, Math.max(0, (t - times[low]) / length)) : 0};
  }

  /** Value of a key of the case: "output.probe.0.name". */
  caseValue(key) {
    return this.document.case.find((row) => row[0] === key)?.[1];
  }

  probes() {
    const out = [];
    for (let k = 0; this.caseValue(`output.probe.${k}.name`) !== undefined; ++k)
      out.push({name: this.caseValue(`output.probe.${k}.name`), quantity: this.caseValue(`output.probe.${k}.quantity`),
                position: this.caseValue(`output.probe.${k}.position`)});
    return out;
  }
}
