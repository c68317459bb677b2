// The page of cosurge report, watch and check --picture.
import {Chart} from "./charts.js";
import {controls} from "./controls.js";
import {groupsOf} from "./groups.js";
import {Player} from "./player.js";
import {Run} from "./run.js";
import {Scene} from "./scene.js";
import {Tables, verdictLines} from "./tables.js";
import {watch} from "./watch.js";

const find = (selector) => document.querySelector(selector);

function complain(error) {
  console.error(error);
  find("#trouble").hidden = false;
  find("#trouble").textContent = error.message ?? String(error);
}

function head(data, runs) {
  const titles = [...new Set(runs.map((run) => run.document.title))];
  document.title = `${titles.join(", ")} – Cosurge`;
  find("h1").textContent = titles.join(" / ");
  const what = {report: "report", check: "picture of the case before its run", watch: "live"}[data.mode];
  find("#made").textContent = `Cosurge ${data.cosurge}, ${what}, ${data.made}`;
  verdictLines(find("#verdicts"), runs);
}

/** How the page shows less than the run has. */
function thinning(runs) {
  return runs.flatMap(({scene, document: {name}}) => {
    const parts = [];
    if (scene?.every_frame > 1) parts.push(`one of ${scene.every_frame} frames`);
    if (scene?.every_particle > 1) parts.push(`one of ${scene.every_particle} water particles`);
    return parts.length ? [`${runs.length > 1 ? name + ": " : ""}shown: ${parts.join(", ")} (--size makes it more)`] : [];
  }).join("; ");
}

class Page {
  constructor(data, runs) {
    Object.assign(this, {data, runs, charts: []});
    try {
      this.scene = new Scene(find("#scene"), runs);
    } catch (error) {
      complain(error);
    }
    this.player = new Player(find("#player"), Math.max(...runs.map((run) => run.end)), (t) => this.show(t));
    this.tables = new Tables(find("#tables"), runs);
    find("#thinning").textContent = thinning(runs);
    this.layOutCharts();
    if (data.mode === "check") {
      document.body.classList.add("check");
      const settings = this.scene?.settings ?? {kinds: new Set()};
      Object.assign(settings, {labels: true, fluid: "none", solid: "none"});
      for (const kind of ["water", "body", "extreme", "path", "stairs"]) settings.kinds.add(kind);
    }
  }

  layOutCharts() {
    const {groups, others} = groupsOf(this.runs), root = find("#charts");
    const add = (group) => {
      const chart = new Chart(root, group, this.runs, (t) => this.player.set(t), () => this.player.playing);
      this.charts.push(chart);
      return chart;
    };
    groups.forEach(add);
    const more = find("#more");
    find("#histories").hidden = !groups.length && !others.length;
    more.append(...others.map((group, k) => Object.assign(document.createElement("option"), {value: k, textContent: group.title})));
    more.addEventListener("change", () => {
      const chart = add(others[more.value]);
      more.selectedOptions[0].remove();
      more.value = "";
      chart.root.scrollIntoView({block: "center"});
    });
  }

  show(time) {
    if (this.scene) {
      this.scene.time = time;
      this.scene.draw();
    }
    for (const chart of this.charts) chart.show(time, false);
    this.values ??= setTimeout(() => {  // the numbers of the legends follow a few times a second
      this.values = undefined;
      for (const chart of this.charts) chart.show(this.player.time, true);
    }, 150);
  }

  async unpackFrames() {
    const all = this.runs.flatMap((run) => (run.scene?.chunks ?? []).map((chunk) => ({run, chunk})));
    all.sort((a, b) => a.chunk.first - b.chunk.first);
    let first = true;
    for (const {run, chunk} of all) {
      await run.unpackChunk(chunk);
      if (first && this.scene) this.refresh();
      first = false;
    }
    if (this.scene) this.refresh();
  }

  /** After more frames: the box of the scene and its controls. */
  refresh() {
    this.scene.fit();
    controls(find("#controls"), this.scene, this.data.mode);
    this.scene.draw();
  }

  grown() {
    const atEnd = this.player.time >= this.player.end - 1e-12;
    this.player.setEnd(Math.max(...this.runs.map((run) => run.end)));
    verdictLines(find("#verdicts"), this.runs);
    this.tables.update();
    for (const chart of this.charts) chart.update();
    if (this.scene && !find("#controls").children.length) this.refresh();
    if (atEnd && !this.player.playing) this.player.set(this.player.end);
  }
}

async function start() {
  const began = performance.now();
  const data = JSON.parse(find("#document").textContent);
  find("#document").remove();
  const runs = data.runs.map((run) => new Run(run));
  head(data, runs);
  await Promise.all(runs.map((run) => run.unpackHistories()));
  const page = window.cosurge = new Page(data, runs);
  await page.unpackFrames();
  page.player.set(0);
  if (data.mode === "watch") watch(runs, find("#live"), () => page.grown());
  page.openSeconds = (performance.now() - began) / 1000;
  document.documentElement.dataset.ready = "yes";
}

window.addEventListener("error", (event) => complain(event.error ?? new Error(event.message)));
start().catch(complain);
