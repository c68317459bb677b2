// A run that goes on: asks the server of cosurge watch for what is new.
import {digits} from "./units.js";

const pause = 1500;  // ms between two questions

function clock(seconds) {
  const whole = Math.round(seconds), two = (n) => String(n).padStart(2, "0");
  return whole < 3600 ? `${Math.floor(whole / 60)}:${two(whole % 60)} min` : `${Math.floor(whole / 3600)}:${two(Math.floor(whole / 60) % 60)} h`;
}

/** `changed(run)` is called when a run has more windows or frames. */
export function watch(runs, line, changed) {
  const begun = performance.now(), from = runs.map((run) => run.document.status.time);
  const told = (run, k) => {
    const {state, time, end} = run.document.status;
    if (state !== "unfinished") return `${state} at t = ${digits(time)} s`;
    const rate = (time - from[k]) / ((performance.now() - begun) / 1000);
    return `t = ${digits(time)} of ${digits(end)} s` + (rate > 0 ? `, ${clock((end - time) / rate)} left` : "");
  };
  const ask = async () => {
    try {
      for (const [k, run] of runs.entries()) {
        const {windows, state} = run.document.status;
        const answer = await fetch(`run/${k}?frames=${run.times.length}&windows=${windows}&state=${state}`);
        if (!answer.ok) throw new Error(`the server answers ${answer.status}`);
        if (answer.status === 204) continue;
        const document = await answer.json();
        if (document.first_frame !== run.times.length && document.scene.chunks.length) continue;
        run.take(document);
        await run.unpackHistories();
        for (const chunk of document.scene.chunks) await run.unpackChunk(chunk);
        changed(run);
      }
      line.className = "live";
      line.textContent = runs.map(told).join("; ");
    } catch (error) {
      line.className = "live lost";
      line.textContent = `no answer from cosurge watch (${error.message}): the page shows what it has`;
    }
    setTimeout(ask, pause);
  };
  ask();
}
