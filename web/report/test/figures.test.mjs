// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { openBrowser, openReport, painted, showAllFigures } from "./browser.mjs";
import { reportsOf } from "./reports.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const WIDTHS = [1280, 768, 390]; // px
const reports = reportsOf();
let browser;
before(async () => (browser = await openBrowser()));
after(() => browser.close());

async function seriousViolations(page) {
  await page.evaluate(axe);
  const { violations } = await page.evaluate(() => axe.run({ resultTypes: ["violations"] }));
  return violations
    .filter(({ impact }) => ["serious", "critical"].includes(impact))
    .map(({ id, nodes }) => `${id}: ${nodes.slice(0, 3).map((node) => `${node.html.slice(0, 160)} (${node.failureSummary})`).join("; ")}`);
}

// Drawings without marks, and live charts and scenes of hardly any colours.
async function emptyFigures(page) {
  const drawings = await page.locator("figure .drawing").evaluateAll((all) =>
    all
      .filter((drawing) => !drawing.querySelector("svg")?.querySelector("path, rect, circle, line, polygon, polyline, text"))
      .map((drawing) => `drawing of ${drawing.closest("figure").id}`),
  );
  const canvases = await page.locator(".live-view canvas").evaluateAll((all) => {
    const copy = document.createElement("canvas").getContext("2d", { willReadFrequently: true });
    const colours = (canvas) => {
      Object.assign(copy.canvas, { width: canvas.width, height: canvas.height });
      copy.drawImage(canvas, 0, 0);
      return new Set(new Uint32Array(copy.getImageData(0, 0, canvas.width, canvas.height).data.buffer)).size;
    };
    return all.filter((canvas) => colours(canvas) < 4).map((canvas) => `live ${canvas.closest("figure").id}`);
  });
  return [...drawings, ...canvases];
}

for (const [name, path] of Object.entries(reports)) {
  test(`${name} is whole and well, in the light and in the dark, on every width`, async () => {
    const page = await openReport(browser, path);
    await showAllFigures(page);
    for (const colorScheme of ["light", "dark"]) {
      await page.emulateMedia({ colorScheme });
      assert.deepEqual(await emptyFigures(page), []);
      assert.deepEqual(await seriousViolations(page), []);
    }
    for (const width of WIDTHS) {
      await page.setViewportSize({ width, height: 844 });
      await painted(page);
      assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= width, `wider than ${width} px`);
    }
    assert.deepEqual(page.complaints, []);
    await page.context().close();
  });
}

test("a calibration is shown in charts and in space", async () => {
  const page = await openReport(browser, reports["calibration.en"]);
  await showAllFigures(page);
  assert.ok((await page.evaluate(() => armcalReport.charts.length)) >= 3);
  assert.equal(await page.evaluate(() => armcalReport.scenes.length), 1);
  await page.context().close();
});

test("the button changes the colours of everything", async () => {
  const page = await openReport(browser, reports["calibration.en"], { colorScheme: "light" });
  await showAllFigures(page);
  const look = async () => {
    await painted(page);
    return page.evaluate(() => [getComputedStyle(document.body).backgroundColor, ...[...document.querySelectorAll(".live-view canvas")].map((canvas) => canvas.toDataURL())]);
  };
  const before = await look();
  await page.click("#armcal-theme");
  const after = await look();
  assert.ok(before.length > 4);
  assert.deepEqual(before.map((picture, i) => picture !== after[i]), before.map(() => true));
  assert.equal(await page.getAttribute("#armcal-theme", "aria-pressed"), "true");
  await page.context().close();
});

// Ticks were those of the size before, and paper left a chart with those of hardly any.
test("charts are the same again after paper and after a narrow window", async () => {
  const page = await openReport(browser, reports["calibration.en"]);
  await showAllFigures(page);
  const look = async () => {
    for (let i = 0; i < 3; ++i) await painted(page);
    return page.evaluate(() => [...document.querySelectorAll(".plot canvas")].map((canvas) => canvas.toDataURL()));
  };
  const before = await look();
  await page.emulateMedia({ media: "print" });
  await painted(page);
  await page.emulateMedia({ media: "screen" });
  assert.deepEqual((await look()).map((picture, i) => picture === before[i]), before.map(() => true), "after paper");
  await page.setViewportSize({ width: 390, height: 844 });
  await look();
  await page.setViewportSize({ width: 1280, height: 900 });
  assert.deepEqual((await look()).map((picture, i) => picture === before[i]), before.map(() => true), "after a narrow window");
  await page.context().close();
});

test("charts zoom, and come back", async () => {
  const page = await openReport(browser, reports["calibration.en"]);
  await showAllFigures(page);
  const chart = page.locator(".plot").first();
  const ranges = () => chart.evaluate((plot) => armcalReport.charts.find(({ element }) => element.contains(plot)).ranges());
  const whole = await ranges();
  await chart.focus();
  await page.keyboard.press("ArrowRight");
  assert.notEqual(await page.locator(".live-view:not(.scene) .spoken").first().textContent(), "");
  assert.ok(await chart.locator(".tip").isVisible());
  await page.keyboard.press("+");
  assert.ok((await ranges()).x[1] < whole.x[1]);
  await page.keyboard.press("Escape");
  assert.deepEqual(await ranges(), whole);

  await chart.scrollIntoViewIfNeeded();
  const box = await chart.locator(".u-over").boundingBox();
  await page.mouse.move(box.x + 0.3 * box.width, box.y + 0.3 * box.height);
  await page.mouse.down();
  await page.mouse.move(box.x + 0.6 * box.width, box.y + 0.7 * box.height, { steps: 4 });
  await page.mouse.up();
  const part = await ranges();
  const spans = (r) => (r.x[1] - r.x[0]) / (whole.x[1] - whole.x[0]);
  assert.ok(Math.abs(spans(part) - 0.3) < 0.02, `${JSON.stringify(part)} of ${JSON.stringify(whole)}`);
  await page.locator(".live-view:not(.scene) .reset").first().click();
  assert.deepEqual(await ranges(), whole);
  await page.context().close();
});
