// Which histories share a chart.

const words = (name) => name.replace(/^(fluid|solid|coupling)\//, "").replaceAll("_", " ");

/** [{title, unit, columns: [name], labels: [text]}] of the histories that any of the runs has. */
export function groupsOf(runs) {
  const units = new Map(), moving = new Set();
  for (const run of runs)
    for (const [name, {unit, values}] of run.histories) {
      units.set(name, unit);
      if (run.document.status.state === "unfinished" || values.some((v) => v !== 0)) moving.add(name);
    }
  const left = new Set(units.keys()), groups = [];
  const group = (title, names, labels, always) => {  // those that are zero all the time are among the others, but for probes
    const found = names.filter((name) => left.has(name));
    if (!found.some((name) => always || moving.has(name))) return;
    found.forEach((name) => left.delete(name));
    groups.push({title, unit: units.get(found[0]), columns: found, labels: found.map((name) => labels?.[names.indexOf(name)] ?? words(name))});
  };
  const probes = new Map(runs.flatMap((run) => run.probes().map((probe) => [probe.name, probe])));
  for (const {name, quantity, position} of probes.values()) {
    const at = `${name}: ${quantity} at (${position}) m`;
    if (quantity === "pressure") group(at, [`fluid/${name}`], null, true);
    if (quantity === "displacement") group(at, ["x", "y", "z"].map((a) => `solid/${name}_${a}`), ["x", "y", "z"], true);
    if (quantity === "force") group(at, ["x", "y", "z"].map((a) => `fluid/${name}_${a}`), ["x", "y", "z"], true);
  }
  group("levels of the free surface", [...probes.values()].filter((p) => p.quantity === "level").map((p) => `fluid/${p.name}`), null, true);
  group("load of the water on the structure", ["x", "y", "z"].map((a) => `coupling/force_${a}`), ["x", "y", "z"]);
  group("load on rigid bodies", ["x", "y", "z"].map((a) => `solid/load_${a}`), ["x", "y", "z"]);
  group("energies of the structure, and work of the water on it",
        ["solid/kinetic_energy", "solid/elastic_energy", "solid/gravity_energy", "coupling/work_points", "coupling/work_created"],
        ["kinetic", "elastic", "gravity", "work of the water", "work created by the coupling"]);
  group("energies of the water", ["fluid/kinetic_energy", "fluid/gravity_energy"], ["kinetic", "gravity"]);
  group("front of the water", ["fluid/front"]);
  group("largest speeds", ["fluid/max_speed", "solid/max_speed"], ["water", "structure"]);
  const others = [...left].filter((name) => units.get(name) !== undefined)
    .map((name) => ({title: name.replace("/", ": ").replaceAll("_", " "), unit: units.get(name), columns: [name], labels: [words(name)]}));
  return {groups, others};
}
