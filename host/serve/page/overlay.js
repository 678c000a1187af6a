// Layers of the render, in false colours over the image.
import { $, element } from "./dom.js";
import { colourOf, colours, numberColours, paintScale } from "./colours.js";
import { meaningOf } from "./layers.js";
import { number } from "./numbers.js";
import { askPicture, ask } from "./server.js";

export class Overlay {
  constructor(viewer) {
    this.viewer = viewer;
    this.names = [];
    this.layer = null; // the picture last got
    this.canvas = document.createElement("canvas");
    $("overlay").addEventListener("change", () => this.choose());
    $("opacity").addEventListener("input", () => this.paint());
    paintScale($("legend-scale"));
  }

  /** `layers`: names of what there is; `hint`: what there could be. */
  offer(layers, hint) {
    const names = layers.map(({ name }) => name);
    $("overlay-note").textContent = this.chosen() == null ? hint : meaningOf(names[this.chosen()] ?? "").note;
    if (names.join("\n") === this.names.join("\n")) return;
    const before = this.names[this.chosen()];
    this.names = names;
    const options = names.map((name, index) => element("option", meaningOf(name).title, { value: String(index) }));
    $("overlay").replaceChildren(element("option", "none", { value: "" }), ...options);
    if (before != null) $("overlay").value = String(names.indexOf(before));
  }

  chosen() {
    const { value } = $("overlay");
    return value === "" ? null : Number(value);
  }

  async choose() {
    const chosen = this.chosen();
    this.layer = null;
    this.paint();
    if (chosen == null) await fetch("layer/none", { cache: "no-store" });
    else await this.update(await ask("state"));
  }

  async update(state) {
    const chosen = this.chosen();
    if (chosen == null) return;
    const current = this.layer && this.layer.index === chosen && state.layer === chosen && state["layer image"] === this.layer.number;
    if (!current) {
      const picture = await askPicture(`layer/${chosen}`);
      if (chosen !== this.chosen() || !picture) return;
      this.layer = { ...picture, index: chosen };
    }
    this.paint();
  }

  paint() {
    const opacity = Number($("opacity").value), { layer } = this, { picture } = this.viewer;
    $("opacity-row").hidden = this.chosen() == null;
    $("opacity-text").textContent = `${Math.round(100 * opacity)} %`;
    $("legend").hidden = !layer;
    if (!layer || !picture || layer.width !== picture.width || layer.height !== picture.height) {
      $("legend").hidden = true;
      document.body.dataset.overlay = "";
      return this.viewer.cover(null);
    }
    const meaning = meaningOf(this.names[layer.index]);
    const shown = meaning.values(layer, picture), { values } = shown;
    this.canvas.width = layer.width;
    this.canvas.height = layer.height;
    const context = this.canvas.getContext("2d");
    const pixels = context.createImageData(layer.width, layer.height);
    if (shown.categories) numberColours(values, pixels.data);
    else colours(values, shown.low, shown.high, shown.logarithmic, pixels.data, meaning.transparent);
    context.putImageData(pixels, 0, 0);
    this.explain(shown, meaning.unit);
    document.body.dataset.overlay = this.names[layer.index];
    this.viewer.cover({ canvas: this.canvas, opacity, name: meaning.title, read: (index) => [shown.categories ? shown.categories(values[index]) : values[index]] });
  }

  /** The scale below the image; of numbers, those that most of the image shows. */
  explain({ values, low, high, logarithmic, categories }, unit) {
    const most = 8;
    $("legend-unit").textContent = unit;
    $("legend-scale").hidden = Boolean(categories);
    $("legend-low").replaceChildren();
    $("legend-high").replaceChildren();
    if (!categories) {
      $("legend-low").textContent = `${logarithmic ? "\u2264 " : ""}${number(low, 2)}`;
      $("legend-high").textContent = `${logarithmic ? "\u2265 " : ""}${number(high, 2)}`;
      return;
    }
    const counts = new Map();
    for (const value of values) if (value > 0) counts.set(value, (counts.get(value) ?? 0) + 1);
    const first = [...counts].sort((a, b) => b[1] - a[1]).slice(0, most).map(([value]) => value).sort((a, b) => a - b);
    $("legend-low").replaceChildren(...first.map((value) => {
      const swatch = element("i");
      swatch.style.background = `rgb(${colourOf(value).join(" ")})`;
      const entry = element("span");
      entry.append(swatch, categories(value));
      return entry;
    }));
    if (counts.size > most) $("legend-high").textContent = `and ${counts.size - most} more`;
  }
}
