// Bundles the page into one HTML text and writes it as C++: node build.mjs PACKAGES OUTPUT.cpp,
// PACKAGES being the folder that has node_modules.
import { createHash } from "node:crypto";
import { readFileSync, writeFileSync } from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";

import { bundler } from "./bundle.mjs";

const [packages, output] = process.argv.slice(2);
if (!output) {
  console.error("usage: node build.mjs PACKAGES OUTPUT.cpp");
  process.exit(2);
}
const folder = path.join(path.dirname(fileURLToPath(import.meta.url)), "page");
const bundle = bundler(packages, folder);

const checksum = (text) => `'sha256-${createHash("sha256").update(text).digest("base64")}'`;
const style = bundle("style.css"), script = bundle("main.js");
// Functions as replacements: a "$" in the bundle has no meaning.
const page = readFileSync(path.join(folder, "page.html"), "utf8")
  .replace("/* style */", () => style)
  .replace("/* script */", () => script);
const policy = [
  "default-src 'none'", `script-src ${checksum(script)}`, `style-src ${checksum(style)}`,
  "connect-src 'self'", "img-src data:", "base-uri 'none'", "form-action 'none'",
  "frame-ancestors 'none'",
].join("; ");

/** As an array: compilers bound the length of a literal. */
function array(name, text) {
  const bytes = [...Buffer.from(text, "utf8")];
  const lines = [];
  for (let i = 0; i < bytes.length; i += 32) lines.push(`${bytes.slice(i, i + 32).join(",")},`);
  return `const unsigned char ${name}[] = {\n${lines.join("\n")}\n};\n`;
}

writeFileSync(output, `// The page of host/serve/page, by build.mjs.
#include "lxs/serve/page.h"

namespace lxs::serve {
namespace {

${array("kPage", page)}
${array("kPolicy", policy)}
}  // namespace

std::string_view page_text() {
    return {reinterpret_cast<const char*>(kPage), sizeof kPage};
}

std::string_view page_policy() {
    return {reinterpret_cast<const char*>(kPolicy), sizeof kPolicy};
}

}  // namespace lxs::serve
`);
