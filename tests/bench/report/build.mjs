// Bundles the report's page into one HTML file: node build.mjs PACKAGES OUTPUT, PACKAGES being the
// folder that has node_modules.
import { createRequire } from "node:module";
import { readFileSync, writeFileSync } from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";

const [packages, output] = process.argv.slice(2);
if (!output) {
  console.error("usage: node build.mjs PACKAGES OUTPUT.html");
  process.exit(2);
}
const folder = path.join(path.dirname(fileURLToPath(import.meta.url)), "page");
const esbuild = createRequire(path.resolve(packages, "package.json"))("esbuild");

function bundle(entry) {
  const result = esbuild.buildSync({
    entryPoints: [path.join(folder, entry)],
    nodePaths: [path.resolve(packages, "node_modules")],
    bundle: true,
    minify: true,
    format: "iife",
    target: "es2020",
    legalComments: "inline",
    charset: "ascii",
    write: false,
    logLevel: "warning",
  });
  return result.outputFiles[0].text;
}

// Functions as replacements: a "$" in the bundle has no meaning.
const page = readFileSync(path.join(folder, "page.html"), "utf8")
  .replace("/* style */", () => bundle("style.css"))
  .replace("/* script */", () => bundle("main.js"));
writeFileSync(output, page);
