// Layers of the render, in false colours over the image.
import { $, element } from "./dom.js";
import { colours, paintScale } from "./colours.js";
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
    const { values, low, high, logarithmic } = meaning.values(layer, picture);
    this.canvas.width = layer.width;
    this.canvas.height = layer.height;
    const context = this.canvas.getContext("2d");
    const pixels = context.createImageData(layer.width, layer.height);
    colours(values, low, high, logarithmic, pixels.data, meaning.transparent);
    context.putImageData(pixels, 0, 0);
    $("legend-low").textContent = `${logarithmic ? "\u2264 " : ""}${number(low, 2)}`;
    $("legend-high").textContent = `${logarithmic ? "\u2265 " : ""}${number(high, 2)}`;
    $("legend-unit").textContent = meaning.unit;
    document.body.dataset.overlay = this.names[layer.index];
    this.viewer.cover({ canvas: this.canvas, opacity, name: meaning.title, read: (index) => [values[index]] });
  }
}
