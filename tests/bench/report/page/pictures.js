// Pictures at equal time: crops side by side, signed errors, and a viewer to flip between them.
import { choice, element, section } from "./dom.js";
import { clockNames, variantNames } from "./looks.js";
import { figure } from "./numbers.js";

const percent = (value) => `${figure(100 * value)} %`;

function errorLegend(images, palette) {
  if (images.error_scale === null) return null;
  return element("div", { class: "error-legend" },
    element("span", null, `too dark, \u2212${percent(images.error_scale)}`),
    element("span", { class: "gradient", style: `background:linear-gradient(to right, ${palette.join(", ")})` },
      element("i", null, "0")),
    element("span", null, `+${percent(images.error_scale)}, too bright`));
}

/** What the strip and the viewer show of a variant: the reference first. */
function views(images, variant, baseline) {
  const reference = images.reference === null ? []
    : [{ name: "reference", image: images.reference, error: null, tile: null }];
  const tiles = images.tiles.filter((tile) => tile.variant === variant)
    .map((tile) => ({ name: tile.method, image: tile.image, error: tile.error, tile }));
  tiles.sort((a, b) => (b.name === baseline) - (a.name === baseline));
  return [...reference, ...tiles];
}

function picture(source, text, images) {
  return element("img", {
    src: source, alt: text, width: images.crop.width_px, height: images.crop.height_px, class: "pixels",
  });
}

function strip(images, variant, context) {
  const shown = views(images, variant, context.study.baseline);
  const columns = shown.map(({ name, image, error, tile }) => element("div", { class: "tile" },
    element("b", null,
      tile ? element("span", { class: "swatch", style: `background:${context.looks.get(name).colour}` }) : null, name),
    picture(image, `${images.scene}, ${name}`, images),
    error === null ? element("div", { class: "no-error" }, tile ? "no reference" : "signed error \u2192")
      : picture(error, `${images.scene}, signed error of ${name}`, images),
    element("span", { class: "quiet" }, tile
      ? `relMSE ${figure(tile.relmse)} after ${figure(tile.seconds)} s, ${tile.passes} passes`
      : "mean of both references")));
  const across = columns.length > 6 ? Math.ceil(columns.length / 2) : columns.length;
  return element("div", { class: "strip", style: `--columns:${across}` }, columns);
}

/** Flips between methods in place: differences jump to the eye that are missed side by side. */
class FlipViewer {
  constructor(images, context) {
    this.images = images;
    this.context = context;
    this.variant = context.study.variants[0];
    this.index = 0;
    this.errors = false;
    this.root = element("div", {
      class: "flip", tabindex: "0", role: "group", "aria-label": `Flip viewer of ${images.scene}`,
      onkeydown: (event) => this.key(event),
    });
    this.draw();
  }

  get views() {
    return views(this.images, this.variant, this.context.study.baseline);
  }

  show(index) {
    const count = this.views.length;
    this.index = (index + count) % count;
    this.draw();
  }

  key(event) {
    const digit = "123456789".indexOf(event.key);
    if (event.key === "ArrowRight" || event.key === " ") this.show(this.index + 1);
    else if (event.key === "ArrowLeft") this.show(this.index - 1);
    else if (digit >= 0 && digit < this.views.length) this.show(digit);
    else if (event.key === "e") this.toggleErrors();
    else return;
    event.preventDefault();
  }

  toggleErrors() {
    this.errors = !this.errors;
    this.draw();
  }

  draw() {
    const shown = this.views;
    this.index = Math.min(this.index, shown.length - 1);
    const { name, image, error } = shown[this.index];
    const source = this.errors && error !== null ? error : image;
    const hadFocus = this.root.contains(document.activeElement);
    const view = picture(source, `${this.images.scene}, ${this.errors && error !== null ? "signed error of " : ""}${name}`, this.images);
    view.addEventListener("click", (event) => this.show(this.index + (event.shiftKey ? -1 : 1)));
    this.root.dataset.shown = name;
    this.root.replaceChildren(
      element("div", { class: "flip-controls" },
        choice("Show", shown.map((entry, value) => ({ value, text: `${value + 1} ${entry.name}` })), this.index, (value) => this.show(value)),
        this.context.study.variants.length > 1
          ? choice("Radius", this.context.study.variants.map((value) => ({ value, text: variantNames[value] })), this.variant,
            (value) => { this.variant = value; this.draw(); })
          : null,
        choice("As", [{ value: false, text: "image" }, { value: true, text: "signed error (e)" }], this.errors,
          (value) => { this.errors = value; this.draw(); })),
      element("div", { class: "flip-picture" }, view, element("span", { class: "flip-name" }, name)),
      element("p", { class: "quiet hint" }, "Click (Shift-click: back), arrow keys or digits flip; e shows the signed error."));
    if (hadFocus) this.root.focus({ preventScroll: true });
  }
}

function overview(images, scene) {
  if (images.overview === null) return null;
  const { x, y, width_px: width, height_px: height } = images.crop;
  const share = (value, whole) => `${(100 * value) / whole}%`;
  return element("figure", { class: "overview" },
    element("div", null, element("img", { src: images.overview, alt: `${images.scene}, reference` }),
      element("i", { style: `left:${share(x, scene.width_px)};top:${share(y, scene.height_px)};width:${share(width, scene.width_px)};height:${share(height, scene.height_px)}` })),
    element("figcaption", { class: "quiet" },
      `Reference, ${scene.width_px} \u00d7 ${scene.height_px} px. The frame, ${width} \u00d7 ${height} px at (${x}, ${y}), is where the methods together differ most from it as displayed.`));
}

function scenePictures(images, context) {
  const { data, study } = context;
  const scene = data.scenes.find(({ name }) => name === images.scene);
  const facts = `After ${images.budget_s} ${clockNames[images.clock]}, seed ${images.seed}. All images: exposure \u00d7 ${figure(images.exposure)}, gamma ${images.gamma}.`;
  return element("article", { class: "scene pictures", "data-scene": images.scene },
    element("h3", null, images.scene, element("span", { class: "quiet" }, ` ${facts}`)),
    element("div", { class: "flip-row" }, new FlipViewer(images, context).root, overview(images, scene)),
    ...study.variants.flatMap((variant) => [
      element("h4", null, `${variantNames[variant]}: image above, signed relative error below`),
      strip(images, variant, context)]),
    errorLegend(images, data.error_palette));
}

export function pictureSection(context) {
  const { data } = context;
  return section("pictures", "Images at equal time",
    "Crops of the snapshots taken for the largest budget. Signed errors are of luminance, relative to the references: (I \u2212 R) / (R + 1 % of the mean luminance); one scale for all methods of a scene.",
    ...(data.images.length ? data.images.map((images) => scenePictures(images, context))
      : [element("p", { class: "missing" }, "The study has no images.")]));
}
