// The report's page: a study's data, drawn.
import { agreementSection } from "./agreement.js";
import { biasSection } from "./bias.js";
import { curveSection } from "./curves.js";
import { choice, element } from "./dom.js";
import { clockNames, methodLooks, metricNames, partNames } from "./looks.js";
import { failureNote, notesSection } from "./notes.js";
import { photonSection } from "./photon_strips.js";
import { pictureSection } from "./pictures.js";
import { ratioSection } from "./ratios.js";
import { memorySection, phaseSection } from "./resources.js";
import { speedupSection } from "./speedups.js";
import { titleBlock } from "./title.js";

const data = JSON.parse(document.getElementById("report-data").textContent);
const study = data.study;
const clocks = study.clock === "both" ? ["cpu", "wall"] : [study.clock];
const parts = Object.keys(partNames).filter((part) =>
  part === "image" || data.comparisons.some((entry) => entry.part === part) || data.seed_statistics.some((entry) => entry[part]));

/** What the reader chose; everything is drawn from it anew. */
const chosen = { clock: clocks[0], budget: study.budgets_s.at(-1), metric: "relmse", part: "image" };
const context = { data, study, chosen, parts, looks: methodLooks(study) };

function choose(name, value) {
  chosen[name] = value;
  draw();
}

function controls() {
  return element("nav", { id: "controls" },
    choice("Equal time", study.budgets_s.map((value) => ({ value, text: `${value} s` })), chosen.budget,
      (value) => choose("budget", value)),
    clocks.length > 1
      ? choice("Clock", clocks.map((value) => ({ value, text: clockNames[value] })), chosen.clock,
        (value) => choose("clock", value))
      : null,
    parts.length > 1
      ? choice("Part", parts.map((value) => ({ value, text: partNames[value] })), chosen.part,
        (value) => choose("part", value))
      : null,
    choice("Curves", Object.entries(metricNames).map(([value, text]) => ({ value, text })), chosen.metric,
      (value) => choose("metric", value)));
}

// Pictures stay as they are: they show one moment, and keep what their viewers show.
const pictures = pictureSection(context);
const photons = photonSection(context);

function draw() {
  const top = window.scrollY;
  document.getElementById("report").replaceChildren(...[
    titleBlock(context),
    controls(),
    failureNote(context),
    ratioSection(context),
    curveSection(context),
    biasSection(context),
    agreementSection(context),
    pictures,
    photons,
    speedupSection(context),
    memorySection(context),
    phaseSection(context),
    notesSection(context),
  ].filter(Boolean));
  window.scrollTo(0, top);
}

draw();
