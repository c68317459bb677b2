// Time of the scene: play, pause, the slider.

export class Player {
  /** `show(t)` is called for each time to be shown, `seen(t)` a few times a second while it plays. */
  constructor(root, end, show) {
    Object.assign(this, {show, end, time: 0, playing: false, frames: 0});
    this.button = root.querySelector(".play");
    this.slider = root.querySelector(".slider");
    this.clock = root.querySelector(".clock");
    this.speed = root.querySelector(".rate");
    this.button.addEventListener("click", () => this.playing ? this.pause() : this.play());
    this.slider.addEventListener("input", () => { this.pause(); this.set(this.end * this.slider.value / 1000); });
    document.addEventListener("keydown", (event) => this.key(event));
    this.setEnd(end);
  }

  setEnd(end) {
    this.end = end;
    this.update();
  }

  key(event) {
    if (["INPUT", "SELECT", "TEXTAREA"].includes(event.target.tagName) && event.target.type !== "range") return;
    if (event.key === " ") this.playing ? this.pause() : this.play();
    else if (event.key === "ArrowRight" || event.key === "ArrowLeft") {
      this.pause();
      this.set(this.time + (event.key === "ArrowRight" ? 1 : -1) * this.end / 200);
    } else return;
    event.preventDefault();
  }

  /** The whole run takes eight seconds at rate 1. */
  play() {
    if (!(this.end > 0)) return;
    if (this.time >= this.end) this.time = 0;
    this.playing = true;
    this.last = performance.now();
    this.button.textContent = "❚❚";
    this.button.setAttribute("aria-label", "pause");
    requestAnimationFrame((now) => this.step(now));
  }

  pause() {
    this.playing = false;
    this.button.textContent = "▶";
    this.button.setAttribute("aria-label", "play");
  }

  step(now) {
    if (!this.playing) return;
    const length = 8 / Number(this.speed.value);
    const passed = Math.max(0, now - this.last) / 1000;
    this.last = now;
    ++this.frames;
    const next = this.time + passed * this.end / length;
    this.set(next >= this.end ? this.end : next);
    if (next >= this.end) this.pause();
    else requestAnimationFrame((later) => this.step(later));
  }

  set(time) {
    this.time = Math.min(this.end, Math.max(0, time));
    this.update();
    this.show(this.time);
  }

  update() {
    this.slider.value = this.end > 0 ? 1000 * this.time / this.end : 0;
    this.clock.textContent = `t = ${this.time.toFixed(4)} s of ${Number(this.end.toPrecision(6))} s`;
  }
}
