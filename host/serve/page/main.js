// Asks the render for its state, again and again, and shows what is new.
import { Curve } from "./curve.js";
import { showFigures } from "./figures.js";
import { Overlay } from "./overlay.js";
import { ask, askPicture, order } from "./server.js";
import { showLights, showMaterials } from "./tables.js";
import { Viewer } from "./viewer.js";
import { $ } from "./dom.js";

const INTERVAL = 500; // milliseconds from answer to question

const curve = new Curve($("curve"), $("no-curve"));
const viewer = new Viewer();
const overlay = new Overlay(viewer);
let imageNumber = 0;
let ended = false;
let render = null;
let orders = { pause: false, stop: false };

const WORDS = {
  preparing: "preparing", rendering: "rendering", paused: "paused", pausing: "pausing",
  stopping: "stopping", saving: "saving", ended: "ended", lost: "no answer",
};

function showPhase(phase) {
  document.body.dataset.phase = phase;
  $("phase").textContent = WORDS[phase] ?? phase;
}

function notice(text) {
  $("notice").textContent = text;
  $("notice").hidden = !text;
}

function phaseOf(state) {
  const { phase } = state.render;
  if (phase !== "rendering" && phase !== "paused") return phase;
  if (state.stop) return "stopping";
  if (state.pause && phase === "rendering") return "pausing";
  return !state.pause && phase === "paused" ? "rendering" : phase;
}

function showOrders(state) {
  orders = { pause: state.pause, stop: state.stop };
  const over = state.stop || ["saving", "ended"].includes(state.render.phase);
  $("pause").textContent = state.pause ? "Resume" : "Pause";
  $("pause").disabled = over;
  $("stop").disabled = over;
}

async function show(state) {
  render = state.render;
  if (!render) return;
  showPhase(phaseOf(state));
  showOrders(state);
  // At once, and not after images that are still to come.
  if (render.phase === "ended") notice(render.message ?? "");
  document.title = `${render.title} \u2013 lxsrender`;
  document.body.dataset.passes = render.passes;
  $("title").textContent = render.title;
  $("title").title = render.title;
  showFigures($("figures"), render);
  curve.show(render.error);
  showLights($("lights"), $("lights-section"), render.lights);
  showMaterials($("materials"), $("materials-section"), render.materials);
  overlay.offer(render.layers ?? [], render.hint ?? "");
  if (state.image !== imageNumber) {
    const picture = await askPicture("image");
    if (picture) {
      imageNumber = picture.number;
      viewer.showImage(picture);
      $("waiting").hidden = true;
    }
  }
  await overlay.update(state);
  ended = render.phase === "ended";
}

async function watch() {
  try {
    await show(await ask("state"));
    if (!ended) notice("");
  } catch (error) {
    showPhase("lost");
    notice("lxsrender does not answer: the render has ended, or was killed. This is the last image that it gave.");
    for (const id of ["pause", "stop"]) $(id).disabled = true;
  }
  if (!ended) setTimeout(watch, INTERVAL);
}

async function give(what) {
  try {
    await show(await order(what));
  } catch (error) {
    notice(`That did not reach lxsrender: ${error.message}`);
  }
}

$("pause").addEventListener("click", () => give(orders.pause ? "resume" : "pause"));
$("stop").addEventListener("click", () => give("stop"));
watch();
