// The image: exposure and tone map, zoom and place, pixels with their values.
import { $ } from "./dom.js";
import { number } from "./numbers.js";
import { automaticStops, luminance, toneMap } from "./tone.js";

const FROM_VALUES = 44; // screen pixels that a pixel needs to show its values
const FARTHEST = 0.05, NEAREST = 128;

/** Of an overlay: a number, or a name. */
const shownValue = (value, digits) => (typeof value === "string" ? value : number(value, digits));

function layerCanvas() {
  const canvas = document.createElement("canvas");
  return { canvas, context: canvas.getContext("2d") };
}

export class Viewer {
  constructor() {
    this.view = $("view");
    this.context = this.view.getContext("2d");
    this.shown = layerCanvas();
    this.covering = null; // { canvas, opacity, read(pixel) }
    this.picture = null;
    this.scale = 0; // screen pixels to a pixel; 0: fits
    this.centre = { x: 0, y: 0 }; // in the image
    this.automatic = true;
    this.listenToPointer();
    this.listenToControls();
    new ResizeObserver(() => this.draw()).observe(this.view);
  }

  showImage(picture) {
    this.picture = picture;
    this.develop();
  }

  /** Lays a canvas of the image's size over it; null: none. */
  cover(covering) {
    this.covering = covering;
    this.draw();
  }

  develop() {
    if (!this.picture) return;
    const { width, height } = this.picture, { canvas, context } = this.shown;
    if (this.automatic) this.setStops(automaticStops(this.picture));
    canvas.width = width;
    canvas.height = height;
    const pixels = context.createImageData(width, height);
    toneMap(this.picture, Number($("exposure").value), $("tone").value, pixels.data);
    context.putImageData(pixels, 0, 0);
    this.developed = pixels.data;
    this.draw();
  }

  setStops(stops) {
    $("exposure").value = stops;
    $("stops").textContent = Number($("exposure").value).toFixed(1);
  }

  fitting() {
    const { width, height } = this.picture;
    return Math.min((this.view.clientWidth - 32) / width, (this.view.clientHeight - 36 - 32) / height);
  }

  /** Where the image lies on the screen. */
  place() {
    const { width, height } = this.picture;
    if (!this.scale) this.centre = { x: width / 2, y: height / 2 };
    const scale = this.scale || this.fitting();
    return {
      scale,
      left: this.view.clientWidth / 2 - this.centre.x * scale,
      top: (this.view.clientHeight - 36) / 2 - this.centre.y * scale,
    };
  }

  draw() {
    const ratio = window.devicePixelRatio || 1, { view, context } = this;
    view.width = Math.round(view.clientWidth * ratio);
    view.height = Math.round(view.clientHeight * ratio);
    if (!this.picture) return;
    const { scale, left, top } = this.place(), { width, height } = this.picture;
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.imageSmoothingEnabled = scale * ratio < 1;
    context.imageSmoothingQuality = "high";
    context.drawImage(this.shown.canvas, left, top, width * scale, height * scale);
    if (this.covering) {
      context.globalAlpha = this.covering.opacity;
      context.drawImage(this.covering.canvas, left, top, width * scale, height * scale);
      context.globalAlpha = 1;
    }
    if (scale >= FROM_VALUES) this.writeValues(scale, left, top);
    $("zoom").textContent = `${Math.round(scale * 100)} %`;
    view.dataset.zoom = scale;
    this.readOut();
  }

  /** What stands in pixel `index`: the image's values, or the overlay's. */
  valuesOf(index) {
    return this.covering?.read?.(index) ?? [...this.picture.values.subarray(3 * index, 3 * index + 3)];
  }

  writeValues(scale, left, top) {
    const { context, picture: { width, height }, view } = this;
    const size = Math.min(14, scale / 4.4);
    context.font = `${size}px ui-monospace, "DejaVu Sans Mono", monospace`;
    context.textAlign = "center";
    context.textBaseline = "middle";
    const first = { x: Math.max(0, Math.floor(-left / scale)), y: Math.max(0, Math.floor(-top / scale)) };
    const last = {
      x: Math.min(width, Math.ceil((view.clientWidth - left) / scale)),
      y: Math.min(height, Math.ceil((view.clientHeight - top) / scale)),
    };
    for (let y = first.y; y < last.y; ++y) {
      for (let x = first.x; x < last.x; ++x) {
        const b = 4 * (y * width + x);
        const covered = this.covering && this.covering.opacity > 0.5;
        const bright = luminance(...this.developed.subarray(b, b + 3)) > 110;
        context.fillStyle = bright && !covered ? "#101010" : "#f4f4f4";
        const lines = this.valuesOf(y * width + x);
        context.strokeStyle = "#000000b0";
        context.lineWidth = 2;
        lines.forEach((value, line) => {
          const at = [left + (x + 0.5) * scale, top + (y + 0.5) * scale + (line - (lines.length - 1) / 2) * size * 1.25];
          if (covered) context.strokeText(shownValue(value, 3), ...at);
          context.fillText(shownValue(value, 3), ...at);
        });
      }
    }
    view.dataset.values = `${first.x},${first.y}`;
  }

  pixelAt({ x, y }) {
    if (!this.picture) return null;
    const { scale, left, top } = this.place();
    const pixel = { x: Math.floor((x - left) / scale), y: Math.floor((y - top) / scale) };
    const inside = pixel.x >= 0 && pixel.y >= 0 && pixel.x < this.picture.width && pixel.y < this.picture.height;
    return inside ? pixel : null;
  }

  readOut() {
    const pixel = this.pointer && this.pixelAt(this.pointer);
    if (!pixel) return void ($("pixel").textContent = "\u00a0");
    const index = pixel.y * this.picture.width + pixel.x;
    const rgb = this.picture.values.subarray(3 * index, 3 * index + 3);
    const covering = this.covering?.read?.(index);
    const over = covering ? `${this.covering.name} ${covering.map((value) => shownValue(value, 3)).join(" ")}   ` : "";
    const text = `${pixel.x}, ${pixel.y}   ${over}R ${number(rgb[0])}  G ${number(rgb[1])}  B ${number(rgb[2])}  Y ${number(luminance(...rgb))}`;
    $("pixel").textContent = text;
  }

  /** Zooms by `factor`, the place `at` of the screen staying where it is. */
  zoom(factor, at = { x: this.view.clientWidth / 2, y: (this.view.clientHeight - 36) / 2 }) {
    if (!this.picture) return;
    const { scale, left, top } = this.place();
    const next = Math.min(NEAREST, Math.max(FARTHEST, scale * factor));
    this.scale = next;
    const seen = { x: (at.x - left) / scale, y: (at.y - top) / scale };
    this.centre = {
      x: seen.x - (at.x - this.view.clientWidth / 2) / next,
      y: seen.y - (at.y - (this.view.clientHeight - 36) / 2) / next,
    };
    this.draw();
  }

  move(dx, dy) {
    if (!this.picture) return;
    const { scale } = this.place();
    this.scale = scale;
    this.centre = { x: this.centre.x - dx / scale, y: this.centre.y - dy / scale };
    this.draw();
  }

  fit() {
    this.scale = 0;
    this.draw();
  }

  zoomTo(scale) {
    if (this.picture) this.zoom(scale / this.place().scale);
  }

  listenToPointer() {
    const { view } = this;
    const at = (event) => ({ x: event.offsetX, y: event.offsetY });
    view.addEventListener("wheel", (event) => {
      event.preventDefault();
      this.zoom(2 ** (-event.deltaY / 240), at(event));
    }, { passive: false });
    view.addEventListener("pointerdown", (event) => {
      view.setPointerCapture(event.pointerId);
      this.dragged = at(event);
      view.classList.add("moving");
    });
    view.addEventListener("pointermove", (event) => {
      this.pointer = at(event);
      if (this.dragged) {
        this.move(this.pointer.x - this.dragged.x, this.pointer.y - this.dragged.y);
        this.dragged = this.pointer;
      }
      this.readOut();
    });
    const release = () => {
      this.dragged = null;
      view.classList.remove("moving");
    };
    view.addEventListener("pointerup", release);
    view.addEventListener("pointercancel", release);
    view.addEventListener("pointerleave", () => {
      this.pointer = null;
      this.readOut();
    });
    view.addEventListener("keydown", (event) => this.pressed(event));
  }

  pressed(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const step = 48;
    const act = {
      "+": () => this.zoom(1.5), "=": () => this.zoom(1.5), "-": () => this.zoom(1 / 1.5),
      0: () => this.fit(), 1: () => this.zoomTo(1), v: () => this.zoomTo(64),
      ArrowLeft: () => this.move(step, 0), ArrowRight: () => this.move(-step, 0),
      ArrowUp: () => this.move(0, step), ArrowDown: () => this.move(0, -step),
    }[event.key];
    if (!act) return;
    event.preventDefault();
    act();
  }

  listenToControls() {
    $("exposure").addEventListener("input", () => this.setAutomatic(false));
    $("tone").addEventListener("change", () => this.develop());
    $("auto").addEventListener("click", () => this.setAutomatic(!this.automatic));
    $("fit").addEventListener("click", () => this.fit());
    $("one").addEventListener("click", () => this.zoomTo(1));
    $("values").addEventListener("click", () => this.zoomTo(64));
  }

  setAutomatic(automatic) {
    this.automatic = automatic;
    $("auto").setAttribute("aria-pressed", automatic);
    this.setStops(Number($("exposure").value));
    this.develop();
  }
}
