// Opens the page of a render that goes on and on in Chromium, and uses it as a watcher would:
// node check_page.mjs LINK CHROMIUM PACKAGES [SCREENSHOT.png], PACKAGES being the folder with
// node_modules. In the end the render is stopped.
import assert from "node:assert/strict";
import { createRequire } from "node:module";
import path from "node:path";

const [link, executablePath, packages, screenshot] = process.argv.slice(2);
const { chromium } = createRequire(path.resolve(packages, "package.json"))("playwright-core");
const PATIENCE = 60000;

/** Until `holds` gives true: the page's policy lets no test evaluate texts in it. */
async function until(holds, what) {
  const end = Date.now() + PATIENCE;
  while (Date.now() < end) {
    if (await holds()) return;
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
  assert.fail(`never happened: ${what}`);
}

const data = (tab) => tab.evaluate(() => ({ ...document.body.dataset }));
const passes = async (tab) => Number((await data(tab)).passes);

/** Bytes of the canvas, and how many colours are in it. */
async function drawn(tab) {
  return tab.evaluate(() => {
    const view = document.getElementById("view");
    const { data: bytes } = view.getContext("2d").getImageData(0, 0, view.width, view.height);
    const colours = new Set(), pixels = new Uint32Array(bytes.buffer);
    let sum = 0;
    for (const pixel of pixels) {
      colours.add(pixel);
      sum = (sum * 31 + pixel) % 4294967291;
    }
    return { colours: colours.size, sum };
  });
}

async function checkImage(tab) {
  await tab.locator("#waiting").waitFor({ state: "hidden", timeout: PATIENCE });
  assert.ok((await drawn(tab)).colours > 50, "the image is drawn");
  const before = await passes(tab);
  await until(async () => (await passes(tab)) > before, "passes go on");
  assert.equal(await tab.locator("#phase").textContent(), "rendering");
  assert.equal(await tab.locator("#title").textContent(), "scene.lxs");
}

async function pause(tab) {
  await tab.getByRole("button", { name: "Pause" }).click();
  await until(async () => (await data(tab)).phase === "paused", "the render pauses");
  await tab.waitForTimeout(1200); // the last image has come
}

async function resume(tab) {
  const before = await passes(tab);
  await tab.getByRole("button", { name: "Resume" }).click();
  await until(async () => (await passes(tab)) > before, "the render goes on");
}

async function checkDisplay(tab) {
  const before = await drawn(tab);
  await tab.locator("#exposure").fill("4");
  const brighter = await drawn(tab);
  assert.notEqual(brighter.sum, before.sum, "exposure changes the picture");
  assert.equal(await tab.locator("#auto").getAttribute("aria-pressed"), "false");
  await tab.locator("#tone").selectOption("clipped");
  assert.notEqual((await drawn(tab)).sum, brighter.sum, "so does the tone map");
  await tab.locator("#tone").selectOption("filmic");
  await tab.locator("#auto").click();
  assert.equal((await drawn(tab)).sum, before.sum, "and back");
}

/** The pixel in the middle, as the page tells it, against the picture that the server gives. */
async function checkValues(tab) {
  await tab.locator("#values").click();
  assert.equal(await tab.locator("#zoom").textContent(), "6400 %");
  const box = await tab.locator("#view").boundingBox();
  await tab.mouse.move(box.x + box.width / 2 + 5, box.y + (box.height - 36) / 2 + 5);
  const text = await tab.locator("#pixel").textContent();
  const [, x, y, red] = text.match(/^(\d+), (\d+) +R ([\d.e+-]+)/);
  const truth = await tab.evaluate(async ([column, row]) => {
    const bytes = await (await fetch("image")).arrayBuffer();
    const [width] = new Uint32Array(bytes, 0, 1);
    return new Float32Array(bytes, 16)[3 * (row * width + column)];
  }, [Number(x), Number(y)]);
  // Dark values are told by three digits.
  assert.ok(Math.abs(Number(red) - truth) <= 5e-3 * Math.abs(truth), `${text}: ${truth}`);
  assert.ok((await drawn(tab)).colours > 20, "the values are written");
  await tab.mouse.wheel(0, 240);
  assert.equal(await tab.locator("#zoom").textContent(), "3200 %");
  const before = await drawn(tab);
  await tab.mouse.down();
  await tab.mouse.move(box.x + box.width / 2 + 65, box.y + box.height / 2);
  await tab.mouse.up();
  assert.notEqual((await drawn(tab)).sum, before.sum, "dragging moves the image");
  await tab.locator("#view").press("0");
  await tab.mouse.move(5, 5);
}

async function checkOverlays(tab) {
  const names = await tab.locator("#overlay option").allTextContents();
  for (const name of ["error", "share carried by photons", "photon density", "guide: regions", "learned lights"])
    assert.ok(names.includes(name), `${name} is among ${names}`);
  const seen = new Set([(await drawn(tab)).sum]);
  for (const name of names.slice(1)) {
    await tab.locator("#overlay").selectOption({ label: name });
    await until(async () => (await data(tab)).overlay, `overlay ${name}`);
    assert.ok(await tab.locator("#legend").isVisible(), `${name} has a legend`);
    if (name === "learned lights") assert.match(await tab.locator("#legend").textContent(), /light 0.*light 1/);
    seen.add((await drawn(tab)).sum);
    await tab.locator("#overlay").selectOption("");
  }
  assert.ok(seen.size > names.length - 2, "overlays differ");
  assert.ok(await tab.locator("#legend").isHidden());
}

async function checkPanel(tab) {
  assert.ok(Number(await tab.locator("#curve").getAttribute("data-points")) > 0, "the error's curve has points");
  assert.equal(await tab.locator("#curve canvas").count(), 1);
  assert.match(await tab.locator("#figures").textContent(), /\u2192 0\.01 %/, "the target is told");
  assert.match(await tab.locator("#lights").textContent(), /0 area/);
  assert.match(await tab.locator("#materials").textContent(), /ground/);
  const sideways = await tab.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
  assert.ok(sideways <= 0, `the page is ${sideways} px too wide`);
}

async function stop(tab) {
  await tab.getByRole("button", { name: "Stop and save" }).click();
  await until(async () => (await data(tab)).phase === "ended", "the render ends");
  const written = /Written: a\.exr and a\.png/;
  await until(async () => written.test(await tab.locator("#notice").textContent()), "the page says what is written");
  assert.ok(await tab.locator("#stop").isDisabled());
  assert.ok((await drawn(tab)).colours > 50, "the last image stays");
}

const root = process.getuid() === 0;
const browser = await chromium.launch({ executablePath, args: root ? ["--no-sandbox"] : [] });
try {
  const tab = await browser.newPage({ viewport: { width: 1280, height: 800 } });
  const complaints = [];
  tab.on("console", (message) => {
    // This test itself reads the canvas back, again and again.
    if (!message.text().includes("willReadFrequently")) complaints.push(`console: ${message.text()}`);
  });
  tab.on("pageerror", (error) => complaints.push(`error: ${error}`));
  tab.on("request", (request) => {
    if (!request.url().startsWith(link) && !request.url().startsWith("data:")) complaints.push(`request: ${request.url()}`);
  });
  await tab.goto(link);
  await checkImage(tab);
  await pause(tab);
  await checkDisplay(tab);
  await checkValues(tab);
  await checkOverlays(tab);
  await checkPanel(tab);
  if (screenshot) await tab.screenshot({ path: screenshot });
  await resume(tab);
  await stop(tab);
  assert.deepEqual(complaints, []);
} finally {
  await browser.close();
}
