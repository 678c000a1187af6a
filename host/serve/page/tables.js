// What became of the light of each lamp and of the photons that met each material.
import { element } from "./dom.js";
import { amount, percent } from "./numbers.js";

function table(place, headings, rows, more) {
  const head = element("tr");
  head.append(...headings.map(([text, title]) => element("th", text, { title })));
  const lines = rows.map((cells) => {
    const line = element("tr");
    line.append(...cells.map((cell) => {
      const made = element("td", cell.text ?? cell, { title: cell.title ?? "" });
      if (cell.share != null) {
        made.className = "bar";
        made.style.setProperty("--share", `${Math.round(100 * cell.share)}%`);
      }
      return made;
    }));
    return line;
  });
  if (more > 0) {
    const line = element("tr");
    line.append(element("td", `and ${more} more`, { colSpan: headings.length }));
    lines.push(line);
  }
  place.replaceChildren(head, ...lines);
}

const share = (part, whole) => (whole > 0 ? { text: percent(part / whole), share: part / whole } : "\u2013");

export function showLights(place, section, lights) {
  section.hidden = !lights?.rows.length;
  if (section.hidden) return;
  table(place, [["light", ""], ["photons", "paths that began at the light"],
    ["counted", "of these, the share that left light where the camera sees"],
    ["of image", "its share of the image's luminance"],
    ["by photons", "what of that photons brought"]],
    lights.rows.map((light) => [
      { text: light.name, title: light.title },
      amount(light.photons), share(light.counted, light.photons),
      share(light.luminance, lights.luminance), share(light["by photons"], light.luminance),
    ]), lights.more);
}

export function showMaterials(place, section, materials) {
  section.hidden = !materials?.rows.length;
  if (section.hidden) return;
  table(place, [["material", ""], ["photons", "that met it"], ["taken", "light what the camera sees"],
    ["unseen", "nothing near is in view"], ["direct", "left to shadow rays"], ["pass", "mirror, glass or gloss: they only go on"]],
    materials.rows.map((material) => [
      { text: material.name || "without a name", title: material.name },
      amount(material.hits), share(material.taken, material.hits), share(material.unseen, material.hits),
      share(material.direct, material.hits), share(material.passing, material.hits),
    ]), materials.more);
}
