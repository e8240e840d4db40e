// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { openBrowser, openReport, painted, showAllFigures } from "./browser.mjs";
import { postureOf } from "../src/kinematics.js";
import { liveModels, reportsOf } from "./reports.mjs";

const NANOMETRE = 1e-6; // mm: what printing a tip in decimals and back may lose
const reports = reportsOf("calibration", "symmetric-point");
let browser;
let page;
before(async () => {
  browser = await openBrowser();
  page = await openReport(browser, reports["calibration.en"]);
  await showAllFigures(page);
});
after(() => browser.close());

const distance = (a, b) => Math.hypot(...a.map((v, k) => v - b[k]));
const tip = () => page.evaluate(() => armcalReport.scenes[0].tip());

test("the kinematics of the script are those of the calibration", () => {
  const scene = liveModels(reports["calibration.en"]).find(({ kind }) => kind === "scene");
  assert.ok(scene.postures.length > 10);
  for (const { name, q_deg, tip_mm } of scene.postures) {
    assert.ok(distance(postureOf(scene.arm, q_deg).tip_mm, tip_mm) < NANOMETRE, name);
  }
});

test("the arm stands in a measured posture where its tip was", async () => {
  const [shown, said] = await page.evaluate(() => {
    const [scene] = armcalReport.scenes;
    scene.setPosture(3);
    return [scene.tip(), scene.postures[3].tip_mm];
  });
  assert.ok(distance(shown, said) < NANOMETRE);
});

test("every slider turns its joint", async () => {
  const sliders = page.locator(".panel details input[type=range]");
  const count = await sliders.count();
  assert.equal(count, await page.evaluate(() => armcalReport.scenes[0].joints().length));
  for (let i = 0; i < count; ++i) {
    const before = await page.evaluate(() => armcalReport.scenes[0].joints());
    await sliders.nth(i).focus();
    await page.keyboard.press(before[i] > Number(await sliders.nth(i).getAttribute("min")) + 5 ? "ArrowLeft" : "ArrowRight");
    const joints = await page.evaluate(() => armcalReport.scenes[0].joints());
    assert.notEqual(joints[i], before[i], `joint ${i + 1}`);
    assert.deepEqual(joints.toSpliced(i, 1), before.toSpliced(i, 1));
    const wanted = await page.evaluate((q) => armcalReport.scenes[0].tipOf(q), joints);
    assert.ok(distance(await tip(), wanted) < 1e-12);
  }
});

test("the arm is drawn anew when it moves, and only then", async () => {
  const frames = () => page.evaluate(() => armcalReport.scenes[0].frames());
  const settle = async () => {
    for (let i = 0; i < 3; ++i) await painted(page);
  };
  await settle();
  const still = await frames();
  await settle();
  assert.equal(await frames(), still);
  await page.evaluate(() => armcalReport.scenes[0].setJoint(0, 12));
  await settle();
  assert.ok((await frames()) > still);
});

test("without 3-D graphics the drawing stays, and the reader is told", async () => {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 } });
  await context.addInitScript(() => {
    const getContext = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
      return kind.startsWith("webgl") ? null : getContext.call(this, kind, ...rest);
    };
  });
  const poor = await context.newPage();
  await poor.goto(page.url());
  await showAllFigures(poor);
  const figure = poor.locator("figure:has(> p.note)");
  assert.ok(await figure.locator(".drawing svg").isVisible());
  await context.close();
});

test("keys turn the view and bring it nearer", async () => {
  const canvas = page.locator(".scene canvas").first();
  const look = () => canvas.evaluate((element) => element.toDataURL());
  const looks = [await look()];
  await canvas.focus();
  for (const key of ["ArrowRight", "ArrowUp", "+"]) {
    await page.keyboard.press(key);
    await painted(page);
    looks.push(await look());
  }
  assert.equal(new Set(looks).size, looks.length);
});

test("the slider of residuals makes their arrows longer", async () => {
  const canvas = page.locator(".scene canvas").first();
  const look = () => canvas.evaluate((element) => element.toDataURL());
  const before = await look();
  const slider = page.getByLabel("Residuals enlarged");
  const said = await slider.getAttribute("aria-valuetext");
  await slider.focus();
  for (let i = 0; i < 5; ++i) await page.keyboard.press("PageUp");
  await painted(page);
  assert.notEqual(await slider.getAttribute("aria-valuetext"), said);
  assert.notEqual(await look(), before);
});

test("a half turn is drawn, and turns from A to B when asked", async () => {
  const other = await openReport(browser, reports["symmetric-point.en"]);
  const figure = other.locator("#posture-1");
  await figure.scrollIntoViewIfNeeded();
  const button = figure.getByRole("button", { name: "Move in space" });
  await button.waitFor();
  assert.ok(await figure.locator(".drawing svg").isVisible());
  await button.click();
  await figure.locator(".scene").waitFor();
  const way = figure.getByLabel("From A to B");
  const tips = [];
  for (const key of ["Home", "End"]) {
    await way.focus();
    await other.keyboard.press(key);
    tips.push(await other.evaluate(() => armcalReport.scenes[0].tip()));
  }
  const ends = await other.evaluate(() => armcalReport.scenes[0].postures.map(({ tip_mm }) => tip_mm));
  tips.forEach((tip, i) => assert.ok(distance(tip, ends[i]) < NANOMETRE));
  assert.ok(Math.abs(distance(...tips) - 352.968) < 1e-2, "the paper's distance");
  assert.deepEqual(other.complaints, []);
  await other.context().close();
});

test("a half turn is whole in its view on every width, and nothing covers it", async () => {
  for (const width of [1280, 390]) {
    const other = await openReport(browser, reports["symmetric-point.en"], { viewport: { width, height: 844 } });
    await showAllFigures(other);
    await painted(other);
    const reaches = await other.evaluate(() => armcalReport.scenes.map((scene) => scene.reach()));
    assert.ok(reaches.length > 3);
    for (const reach of reaches) assert.ok(reach > 0.4 && reach < 0.78, `${reach} of the view on ${width} px`);
    const view = await other.locator(".scene .view").first().boundingBox();
    const readout = await other.locator(".scene .readout").first().boundingBox();
    assert.ok(readout.y >= view.y + view.height);
    assert.equal(await other.locator(".scene .legend").first().getByText("Drag to turn the view").count(), 1);
    await other.context().close();
  }
});
