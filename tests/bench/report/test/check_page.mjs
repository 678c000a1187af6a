// Opens a report of the synthetic study in Chromium and checks what a reader would see:
// node check_page.mjs REPORT.html UNTESTED.html CHROMIUM PACKAGES, UNTESTED being the same study without
// agreement.json and PACKAGES the folder with node_modules.
import assert from "node:assert/strict";
import { createRequire } from "node:module";
import path from "node:path";
import { pathToFileURL } from "node:url";

const [page, untestedPage, executablePath, packages] = process.argv.slice(2);
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

/** The strips of one layer: rows of pictures that change from snapshot to snapshot, and the legend. */
async function layerShown(tab) {
  const rows = await tab.locator("#photons table.layers tbody tr").evaluateAll((all) => all.map((row) => ({
    method: row.dataset.method, pictures: [...row.querySelectorAll("img")].map((image) => image.src),
  })));
  const low = await tab.locator("#photons .layer-low").textContent();
  const high = await tab.locator("#photons .layer-high").textContent();
  return { rows, low, high, legend: await tab.locator("#photons .layer-legend").textContent() };
}

async function checkPhotons(tab) {
  assert.equal(await tab.locator("#photons article").count(), 1, "one scene's images have layers");
  const headings = await tab.locator("#photons thead th").allTextContents();
  assert.deepEqual(headings, ["Method", "first pass", "after 1 s", "after 2 s", "after 4 s"]);
  const density = await layerShown(tab);
  assert.deepEqual(density.rows.map(({ method }) => method), ["sppm", "better"]);
  for (const { pictures } of density.rows) assert.equal(pictures.length, headings.length - 1);
  assert.match(density.legend, /photons per square scene unit and pass; logarithmic scale/);
  assert.deepEqual([density.low, density.high], ["\u2264 1.3", "\u2265 7900"]);
  for (const [name, range] of [["node error", null], ["node weight", null], ["node boundaries", "0 1"], ["guided share", "0 1"]]) {
    await tab.locator("#photons").getByRole("button", { name }).click();
    const layer = await layerShown(tab);
    assert.deepEqual(layer.rows.map(({ method }) => method), ["better"], name);
    assert.equal(new Set(layer.rows[0].pictures).size, headings.length - 1, `${name} changes over the passes`);
    if (range) assert.equal(`${layer.low} ${layer.high}`, range);
    await checkPictures(tab);
  }
  assert.equal(await tab.locator("#photons button[aria-pressed=true]").textContent(), "guided share");
}

async function biasCells(tab, method) {
  return tab.locator(`#bias tr[data-scene=box][data-method=${method}]`).first().locator("td.number").allTextContents();
}

/** Figures of the synthetic study after 4 s: bias2 of sppm is negative and shown as such. */
async function checkBias(tab) {
  assert.equal(await tab.locator("#bias table.bias tbody tr").count(), scenes * variants * methods.length);
  assert.deepEqual(await biasCells(tab, "sppm"), ["\u22120.00125", "0.251", "0.25", "\u22120.0125", "2.51"]);
  assert.deepEqual(await biasCells(tab, "worse"), ["0.02", "0.48", "0.5", "0.2", "4.8"]);
  assert.equal(await tab.locator("#bias td.negative").count(), 2 * scenes * variants, "negative figures are marked");
}

/** Image figures are 0.5 and 2 times the baseline's, the photon part's 0.25 and 4 times, in one scene. */
async function checkPhotonPart(tab) {
  const choose = (name) => tab.locator("#controls").getByRole("button", { name, exact: true }).click();
  await choose("photon part");
  const ratios = await tab.locator("#ratios tbody .factor").allTextContents();
  assert.equal(ratios.length, variants * 2 * (methods.length - 1));
  for (const text of ratios) assert.ok(Math.abs(Number(text) - 0.25) < 0.02 || Math.abs(Number(text) - 4) < 0.2, text);
  assert.equal(await tab.locator("#ratios td.none").count() > 0, true, "a scene without photon part has none");
  assert.match(await tab.locator("#ratios caption").first().textContent(), /photon part/);
  assert.equal(await tab.locator("#curves .curve-plot").count(), variants);
  assert.equal(await countLines(tab, "#curves .mean-curves path"), variants * methods.length);
  assert.match(await tab.locator("#curves p.missing").textContent(), /no errors of the photon part/);
  assert.deepEqual(await biasCells(tab, "worse"), ["0.01", "0.24", "0.25", "0.1", "2.4"]);
  await choose("whole image");
  await checkBias(tab);
}

const verdictRows = (tab, scene) => tab.locator(`#agreement tr[data-scene="${quoted(scene)}"]`).evaluateAll((rows) =>
  rows.map((row) => [row.dataset.method, ...[...row.querySelectorAll("[data-verdict]")].map(({ dataset }) => dataset.verdict)]));
const quoted = (text) => text.replace(/["\\]/g, "\\$&");

/** Where a plot's mark lies on its scale, in halves of it from its middle. */
async function place(tab, selector) {
  return tab.locator(selector).evaluate((mark) => {
    const [frame, own] = [mark.ownerSVGElement, mark].map((shape) => shape.getBoundingClientRect());
    const at = (x) => 2 * (x - frame.left) / frame.width - 1;
    return { left: at(own.left), middle: at((own.left + own.right) / 2), right: at(own.right) };
  });
}

/** The verdicts of the synthetic study in words and colours, and its ratios where their scale says. */
async function checkAgreement(tab) {
  const attack = "</script><img src=x onerror=alert(1)>";
  assert.deepEqual(await verdictRows(tab, "box"), [["sppm", "agrees"], ["better", "agrees", "agrees"], ["worse", "differs", "open"]]);
  assert.deepEqual(await verdictRows(tab, attack), [["sppm", "open"], ["better", "does not converge"], ["worse"]]);
  const colours = await tab.locator("#agreement [data-verdict]").evaluateAll((all) => all.map((cell) => {
    const { color, backgroundColor, outlineStyle } = getComputedStyle(cell);
    return [cell.dataset.verdict, [color, backgroundColor, outlineStyle].join()];
  }));
  assert.equal(new Map(colours).size, 4);
  assert.equal(new Set(colours.map(([, colour]) => colour)).size, 4, "a verdict has one look of its own");
  assert.equal(await tab.locator("#agreement ol.footnotes li").textContent(), `Can\u2019t find ${attack}.`);
  const row = (method) => `#agreement tr[data-scene=box][data-method=${method}]`;
  assert.match(await tab.locator(`${row("worse")} .where`).textContent(), /^p\s2\.0\s\u00d7\s10\u207b\u2079\sin\sblock\s0,\s5$/);
  const texts = await tab.locator(`${row("sppm")} .factor, ${row("sppm")} .range, ${row("sppm")} td.number`).allInnerTexts();
  assert.deepEqual(texts.map((text) => text.replace(/\s+/g, " ")), ["1.010", "[0.995, 1.025]", "\u22121.3 %", "4.0 %"]);
  // "worse" is off by a fifth and more: the scale ends at a tenth, and an arrow stands for it.
  const line = await place(tab, `${row("sppm")} .interval-line path`);
  assert.ok(Math.abs(line.left + 0.05) < 0.02 && Math.abs(line.right - 0.25) < 0.02, JSON.stringify(line));
  const dot = await place(tab, `${row("sppm")} .ratio-dot circle, ${row("sppm")} .ratio-dot path`);
  assert.ok(Math.abs(dot.middle - 0.1) < 0.02, JSON.stringify(dot));
  const band = await place(tab, `${row("sppm")} .hidden-band rect`);
  assert.ok(Math.abs(band.left + 0.4) < 0.02 && Math.abs(band.right - 0.4) < 0.02, JSON.stringify(band));
  const arrow = await place(tab, `${row("worse")} .beyond path`);
  assert.ok(arrow.middle < -0.9 && arrow.left >= -1, JSON.stringify(arrow));
  const axes = await tab.locator("#agreement .axis").first().locator("text").allTextContents();
  assert.deepEqual(axes, ["0.95", "1", "1.05", "0.95", "1", "1.05"]);
}

/** Nothing sticks out of the page. */
async function checkWidth(tab) {
  const sideways = await tab.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
  assert.ok(sideways <= 0, `the page is ${sideways} px too wide`);
}

/** No text or picture of the tables and strips lies over another. */
async function checkOverlaps(tab) {
  const overlaps = await tab.evaluate(() => {
    const apart = (a, b) => a.right <= b.left + 0.5 || b.right <= a.left + 0.5 || a.bottom <= b.top + 0.5 || b.bottom <= a.top + 0.5;
    const groups = ["#photons th, #photons td img, #photons td .quiet, #photons .layer-legend > *, #photons .layer-legend i", "#bias th, #bias td",
      "#agreement th, #agreement td, #agreement .factor, #agreement .range, #agreement svg, #agreement .key, #agreement .where, #agreement li"];
    return groups.flatMap((group) => {
      const shown = [...document.querySelectorAll(group)];
      return shown.flatMap((one, i) => shown.slice(i + 1)
        .filter((other) => !one.contains(other) && !apart(one.getBoundingClientRect(), other.getBoundingClientRect()))
        .map((other) => `"${one.textContent || one.alt}" and "${other.textContent || other.alt}"`));
    });
  });
  assert.deepEqual(overlaps, []);
}

/** On a screen, a narrow one, and an A4 page. */
async function checkLayout(tab) {
  const viewport = tab.viewportSize();
  for (const [width, media] of [[viewport.width, "screen"], [800, "screen"], [688, "print"]]) {
    await tab.setViewportSize({ ...viewport, width });
    await tab.emulateMedia({ media });
    await checkOverlaps(tab);
    if (media === "screen") await checkWidth(tab);
    const table = await tab.locator("table.agreement").boundingBox();
    const end = await tab.locator("#agreement").boundingBox();
    if (width !== 800) assert.ok(table.x + table.width <= end.x + end.width + 0.5, `the verdicts are ${table.width} px wide in ${media}`);
  }
  await tab.emulateMedia({ media: "screen" });
  await tab.setViewportSize(viewport);
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
  await checkLayout(tab);
  await checkBias(tab);
  await checkAgreement(tab);
  await checkPhotons(tab);
  await checkPhotonPart(tab);
  await checkFlip(tab);
  await checkControls(tab);
  await tab.goto(pathToFileURL(untestedPage).href);
  await tab.locator("#notes").waitFor({ timeout: 20000 });
  assert.equal(await tab.locator("#agreement").count(), 0, "what was not tested has no section");
  assert.deepEqual(complaints, []);
} finally {
  await browser.close();
}
