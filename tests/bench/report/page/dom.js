// Elements made from data. Strings become text, never markup.

/** element("td", {class: "win"}, "0.5", child, ...); a null child is left out. */
export function element(tag, properties, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(properties ?? {})) {
    if (value === null || value === undefined || value === false) continue;
    if (name.startsWith("on")) made.addEventListener(name.slice(2), value);
    else made.setAttribute(name, value === true ? "" : value);
  }
  made.append(...children.flat().filter((child) => child !== null && child !== undefined));
  return made;
}

/** A section with its heading and a sentence or two on how to read it. */
export function section(id, heading, explanation, ...content) {
  return element("section", { id },
    element("h2", null, heading),
    element("p", { class: "explanation" }, ...[explanation].flat()),
    ...content);
}

/** A row of buttons of which one is chosen. */
export function choice(label, options, chosen, choose) {
  const buttons = options.map(({ value, text }) =>
    element("button", {
      type: "button",
      "aria-pressed": String(value === chosen),
      onclick: () => choose(value),
    }, text));
  return element("div", { class: "choice", role: "group", "aria-label": label },
    element("span", { class: "choice-label" }, label), ...buttons);
}
