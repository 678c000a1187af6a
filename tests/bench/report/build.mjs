// Bundles the report's page into one HTML file: node build.mjs PACKAGES OUTPUT, PACKAGES being the
// folder that has node_modules.
import { readFileSync, writeFileSync } from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";

import { bundler } from "../../../host/serve/bundle.mjs";

const [packages, output] = process.argv.slice(2);
if (!output) {
  console.error("usage: node build.mjs PACKAGES OUTPUT.html");
  process.exit(2);
}
const folder = path.join(path.dirname(fileURLToPath(import.meta.url)), "page");
const bundle = bundler(packages, folder);

// Functions as replacements: a "$" in the bundle has no meaning.
const page = readFileSync(path.join(folder, "page.html"), "utf8")
  .replace("/* style */", () => bundle("style.css"))
  .replace("/* script */", () => bundle("main.js"));
writeFileSync(output, page);
