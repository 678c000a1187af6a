// Opens a report of the synthetic study in Chromium and checks what a reader would see:
// node check_page.mjs REPORT.html CHROMIUM PACKAGES, PACKAGES being the folder with node_modules.
import assert from "node:assert/strict";
import { createRequire } from "node:module";
import path from "node:path";
import { pathToFileURL } from "node:url";

const [page, executablePath, packages] = process.argv.slice(2);
const { chromium } = createRequire(path.resolve(packages, "package.json"))("playwright-core");
const methods = ["sppm", "better", "worse"];
const seeds = 2, scenes = 2, variants = 2;

async function checkTables(tab) {
  const cells = await tab.locator("#ratios table.ratios tbody td[data-verdict]").evaluateAll((all) =>
    all.map((cell) => [cell.querySelector(".factor").textContent, cell.dataset.verdict]));
  assert.equal(cells.length, scenes * variants * 2 * (methods.length - 1));
  for (const [text, verdict] of cells) {
    const ratio = Number(text);
    assert.ok(Math.abs(ratio - (verdict === "win" ? 0.5 : 2)) < 0.05, `${text} is a ${verdict}`);
  }
  assert.equal(cells.filter(([, verdict]) => verdict === "win").length, cells.length / 2);
  const speedups = await tab.locator("#speedups .factor").allTextContents();
  assert.ok(speedups.includes("\u2264\u202f0.952"), speedups.join());
  assert.equal(await tab.locator("#phases tbody tr").count(), scenes * methods.length);
}

/** Every path of the selection has at least one segment. */
async function countLines(tab, selector) {
  const paths = await tab.locator(selector).evaluateAll((all) => all.map((line) => line.getAttribute("d")));
  for (const d of paths) assert.match(d, /^M.*L/, `${selector} draws nothing: ${d}`);
  return paths.length;
}

async function checkCurves(tab) {
  const plots = scenes * variants;
  assert.equal(await tab.locator("#curves .curve-plot").count(), plots);
  assert.equal(await countLines(tab, "#curves .mean-curves path"), plots * methods.length);
  assert.equal(await countLines(tab, "#curves .seed-curves path"), plots * methods.length * seeds);
  const slopes = await tab.locator("#curves .slopes td").allTextContents();
  assert.equal(slopes.length, plots * methods.length);
  for (const text of slopes) assert.equal(text, "\u22121.00 (\u22121.00 to \u22121.00)");
  assert.ok(await countLines(tab, "#memory .memory-plot path[stroke]") >= scenes * methods.length);
}

async function checkFlip(tab) {
  const viewer = tab.locator(".flip").first();
  const shown = () => viewer.getAttribute("data-shown");
  const source = () => viewer.locator("img").getAttribute("src");
  assert.equal(await shown(), "reference");
  await viewer.locator("img").click();
  assert.equal(await shown(), "sppm");
  const sppm = await source();
  await viewer.focus();
  await tab.keyboard.press("ArrowRight");
  assert.equal(await shown(), "better");
  const better = await source();
  assert.notEqual(better, sppm);
  await tab.keyboard.press("e");
  assert.notEqual(await source(), better);
  await tab.keyboard.press("4");
  assert.equal(await shown(), "worse");
  await tab.keyboard.press("ArrowRight");
  assert.equal(await shown(), "reference");
  await viewer.getByRole("button", { name: "2 sppm" }).click();
  assert.equal(await shown(), "sppm");
}

async function checkPictures(tab) {
  const widths = await tab.locator("img").evaluateAll((all) => all.map((image) => image.naturalWidth));
  assert.ok(widths.length >= scenes * variants * (2 * methods.length + 1));
  assert.ok(widths.every((width) => width > 0), "an image is broken");
}

async function checkControls(tab) {
  await tab.locator("#controls").getByRole("button", { name: "2 s", exact: true }).click();
  assert.match(await tab.locator("#ratios caption").first().textContent(), /after 2 CPU seconds/);
  await tab.locator("#controls").getByRole("button", { name: "wall-clock seconds" }).click();
  assert.match(await tab.locator("#speedups caption").first().textContent(), /after 2 wall-clock seconds/);
  await tab.locator("#controls").getByRole("button", { name: "MSE", exact: true }).click();
  assert.match(await tab.locator("#curves figcaption").first().textContent(), /: MSE over time/);
  await checkCurves(tab);
}

const root = process.getuid() === 0;
const browser = await chromium.launch({ executablePath, args: root ? ["--no-sandbox"] : [] });
try {
  const tab = await browser.newPage({ viewport: { width: 1400, height: 900 } });
  const complaints = [];
  tab.on("console", (message) => complaints.push(`console: ${message.text()}`));
  tab.on("pageerror", (error) => complaints.push(`error: ${error}`));
  tab.on("dialog", (dialog) => { complaints.push("a dialog opened"); dialog.dismiss(); });
  tab.on("request", (request) => {
    if (!/^(file|data|blob):/.test(request.url())) complaints.push(`request: ${request.url()}`);
  });
  await tab.goto(pathToFileURL(page).href);
  await tab.locator("#notes").waitFor({ timeout: 20000 });
  assert.equal(await tab.locator("h3", { hasText: "onerror=alert" }).count(), 2, "a scene's name is text");
  await checkTables(tab);
  await checkCurves(tab);
  await checkPictures(tab);
  await checkFlip(tab);
  await checkControls(tab);
  assert.deepEqual(complaints, []);
} finally {
  await browser.close();
}
