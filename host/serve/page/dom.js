// Elements of the page.
export const $ = (id) => document.getElementById(id);

export function element(name, text = "", properties = {}) {
  const made = Object.assign(document.createElement(name), properties);
  made.textContent = text;
  return made;
}
