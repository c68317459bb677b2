// The switches of the scene.
import {kinds} from "./overlay.js";

const element = (tag, attributes = {}, ...children) => {
  const made = Object.assign(document.createElement(tag), attributes);
  made.append(...children);
  return made;
};

const names = {pressure: "pressure", speed: "speed", von_mises: "von Mises stress", none: "one colour"};

function choice(title, values, current, change) {
  const select = element("select", {onchange: () => change(select.value)},
                         ...values.map((value) => element("option", {value, textContent: names[value] ?? value, selected: value === current})));
  return element("label", {}, `${title} `, select);
}

function check(title, checked, change, color) {
  const box = element("input", {type: "checkbox", checked, onchange: () => change(box.checked)});
  const label = element("label", {}, box, ` ${title}`);
  if (color) label.style.setProperty("--line", color);
  label.className = color ? "colored" : "";
  return label;
}

/** Fills the bar of controls of a scene. */
export function controls(root, scene, mode) {
  const {settings, runs} = scene, made = [];
  const has = (member) => runs.some((run) => run.members[member]?.some(Boolean));
  const quantities = (member) => {
    for (const run of runs) for (const frame of run.members[member] ?? []) if (frame) return frame.chunk.quantities.map((q) => q.name);
    return [];
  };
  const draw = () => scene.draw();
  const scaleMax = (member) => {
    const box = element("input", {type: "number", className: "top", placeholder: "auto", min: 0, step: "any", title: "upper end of the colours, in SI units",
      onchange: () => { settings.top[`${member} ${settings[member]}`] = Number(box.value) || 0; draw(); }});
    return element("label", {}, "up to ", box);
  };
  for (const [member, title] of [["fluid", "water"], ["solid", "bodies"]])
    if (has(member)) made.push(choice(title, [...quantities(member), "none"], settings[member], (value) => { settings[member] = value; draw(); }), scaleMax(member));
  if (has("solid") && mode !== "check") {
    const box = element("input", {type: "number", value: 1, min: 0, max: 1000, step: "any", className: "top",
      onchange: () => { settings.exaggeration = Number(box.value) || 1; draw(); }});
    made.push(element("label", {title: "displacements of the bodies are shown larger"}, "displacements × ", box));
  }
  if (has("fluid")) made.push(check("walls", settings.walls, (on) => { settings.walls = on; draw(); }));
  made.push(check("labels", settings.labels, (on) => { settings.labels = on; draw(); }));
  const present = new Set(runs.flatMap((run) => (run.scene?.outlines ?? []).map((part) => part.kind)));
  for (const kind of Object.keys(kinds))
    if (present.has(kind))
      made.push(check(kinds[kind].name, settings.kinds.has(kind), (on) => { settings.kinds[on ? "add" : "delete"](kind); draw(); }, kinds[kind].color));
  if (runs.length > 1) runs.forEach((run, k) => made.push(check(run.document.name, true, (on) => { settings.hidden[on ? "delete" : "add"](k); draw(); })));
  made.push(element("button", {textContent: "whole scene", onclick: () => { scene.camera.home(); draw(); }}));
  root.replaceChildren(...made);
}
