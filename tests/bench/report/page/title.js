// Title block: what was measured, on what, when, and how.
import { element } from "./dom.js";

const list = (values) => values.join(", ");

function facts({ data, study }) {
  const machine = data.machine;
  const threads = study.threads || machine?.hardware_threads;
  const threadsText = threads === 1 ? "1 thread" : `${threads ?? "?"} threads`;
  const clock = { both: "CPU and wall", cpu: "CPU", wall: "wall" }[study.clock];
  return [
    ["Machine", machine ? `${machine.processor}, ${machine.hardware_threads} hardware threads; ${machine.system}` : "unknown"],
    ["Date", data.created.replace("T", " ").replace("Z", " UTC")],
    ["Revision", list(data.revisions)],
    ["Budgets", `${list(study.budgets_s)} s (${clock} time of the passes)`],
    ["Runs", `${study.seeds.length} ${study.seeds.length === 1 ? "seed" : "seeds"} per method, ${threadsText} per run`],
    ["Images", study.width_px ? `${study.width_px} px wide` : "the scenes\u2019 own sizes"],
    ["Overrides", study.set.length ? list(study.set) : "none"],
    ["Baseline", study.baseline],
  ];
}

function methodList({ data, study, looks }) {
  return element("ul", { class: "methods" }, data.methods.map(({ name, description }) =>
    element("li", null,
      element("span", { class: "swatch", style: `background:${looks.get(name).colour}` }),
      element("b", null, name), name === study.baseline ? " (baseline)" : "",
      element("span", { class: "quiet" }, ` ${description.replace(/: the baseline\.$/, ".")}`))));
}

export function titleBlock(context) {
  const { study } = context;
  return element("header", { id: "title" },
    element("p", { class: "kicker" }, "AIPS benchmark"),
    element("h1", null, "Run time against error"),
    element("p", { class: "lead" },
      `${study.methods.length} methods on ${study.scenes.length} ${study.scenes.length === 1 ? "scene" : "scenes"}, each against ${study.baseline} at equal time and at equal error.`),
    element("div", { class: "columns" },
      element("dl", { class: "facts" }, facts(context).flatMap(([name, value]) =>
        [element("dt", null, name), element("dd", null, value)])),
      methodList(context)));
}
