// How far the render is.
import { element } from "./dom.js";
import { amount, clock, percent } from "./numbers.js";

function figure(name, value, more = "") {
  const box = element("div");
  const shown = element("dd", value);
  if (more) shown.append(" ", element("small", more));
  box.append(element("dt", name), shown);
  return box;
}

function rate(count, seconds, name) {
  return seconds > 0 && count > 0 ? [figure(name, amount(count / seconds))] : [];
}

export function showFigures(list, render) {
  const { budget } = render;
  const figures = [
    figure("pass", String(render.passes), budget.passes ? `of ${budget.passes}` : ""),
    figure("time", clock(render.seconds), budget.seconds ? `of ${clock(budget.seconds)}` : ""),
    figure("left", render.left == null ? "\u2013" : clock(render.left)),
    figure("error", render.error.now == null ? "\u2013" : percent(render.error.now),
      render.error.target == null ? "" : `\u2192 ${percent(render.error.target)}`),
    ...rate(render.photons, render.seconds, "photons/s"),
    ...rate(render.rays, render.seconds, "rays/s"),
    figure("memory", `${amount(render.memory)}B`),
    figure("image", `${render.width} \u00d7 ${render.height}`),
    figure("integrator", render.integrator),
  ];
  list.replaceChildren(...figures);
}
