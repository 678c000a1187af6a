// Equal-error speed-ups against the baseline.
import { element, section } from "./dom.js";
import { clockNames, ofPart, variantNames } from "./looks.js";
import { ratioTable } from "./ratio_table.js";

const metrics = [["relmse", "relMSE"], ["mse", "MSE"]];

function finder({ data, chosen }, variant) {
  const found = new Map();
  for (const entry of data.speedups) {
    if (entry.variant !== variant || entry.part !== chosen.part || entry.clock !== chosen.clock || entry.budget_s !== chosen.budget) continue;
    found.set(`${entry.scene}\n${entry.method}\n${entry.metric}`, { ...entry, value: entry.speedup });
  }
  return (scene, method, metric) => found.get(`${scene}\n${method}\n${metric}`);
}

export function speedupSection(context) {
  const { study, chosen, looks } = context;
  const methods = study.methods.filter((method) => method !== study.baseline);
  return section("speedups", `Speed-up at equal error, against ${study.baseline}`,
    `Time that ${study.baseline} takes to the error that it has after ${chosen.budget} ${clockNames[chosen.clock]}, divided by the time that the method takes to the same error; above 1 the method is faster. Nothing is extrapolated: \u2265 where the method was there before its first snapshot, \u2264 where it never got there, \u2013 where seeds lie on both sides or an error is not positive.`,
    ...study.variants.map((variant) => element("div", { class: "variant" },
      element("h3", null, variantNames[variant]),
      ratioTable({
        caption: `Speed-ups to the error of ${study.baseline} after ${chosen.budget} ${clockNames[chosen.clock]}${ofPart(context)}`,
        scenes: study.scenes, methods, metrics, find: finder(context, variant),
        lowerWins: false, studySeeds: study.seeds.length, looks,
      }))));
}
