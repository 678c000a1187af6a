// Bundles a file of a page's folder with what it imports, as text: for build.mjs here and for that of
// the benchmark's report.
import { createRequire } from "node:module";
import path from "node:path";

/** A function from the name of a file in `folder` to its bundle. PACKAGES has node_modules. */
export function bundler(packages, folder) {
  const esbuild = createRequire(path.resolve(packages, "package.json"))("esbuild");
  return (entry) => esbuild.buildSync({
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
  }).outputFiles[0].text;
}
