// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
import assert from "node:assert/strict";
import { readFileSync, statSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { openBrowser, openReport, painted, showAllFigures } from "./browser.mjs";
import { embeddedDocument } from "./reports.mjs";
import { armcal, example, temporaryFolder } from "./tools.mjs";

const POSES = 1000;
const MOST_BYTES = 3e6;
const MOST_SECONDS = 1;

let browser;
let path;
before(async () => {
  browser = await openBrowser();
  const folder = temporaryFolder();
  const scenario = readFileSync(example("scenarios", "demo.scenario.toml"), "utf8")
    .replace("../wang2016/nominal.arm.toml", example("wang2016", "nominal.arm.toml"))
    .replace("count = 60", `count = ${POSES - 3 * 60 - 60}`)
    .replace("points = 500", "points = 60");
  writeFileSync(join(folder, "thousand.scenario.toml"), scenario);
  armcal("simulate", join(folder, "thousand.scenario.toml"), "-o", join(folder, "readings"));
  path = join(folder, "thousand.html");
  armcal("calibrate", join(folder, "readings", "thousand.session.toml"), "--report", path);
});
after(() => browser.close());

test(`a report of ${POSES} poses stays small`, () => {
  assert.ok(embeddedDocument(path).rows.group.length >= POSES);
  assert.ok(statSync(path).size < MOST_BYTES, `${statSync(path).size} bytes`);
});

// From the click to the page as it can be read: everything laid out and painted. What scripts add comes when the page is
// idle. Time of the processor, which other work on the machine hardly lengthens; the clock's is told.
test(`a report of ${POSES} poses opens within ${MOST_SECONDS} s`, async (context) => {
  const page = await openReport(browser, "/dev/null");
  const session = await page.context().newCDPSession(page);
  await session.send("Performance.enable");
  const used = async () => Object.fromEntries((await session.send("Performance.getMetrics")).metrics.map(({ name, value }) => [name, value])).ProcessTime;
  const before = await used();
  await page.goto(pathToFileURL(path).href);
  await painted(page);
  const seconds = (await used()) - before;
  const clock = (await page.evaluate(() => performance.now())) / 1000;
  context.diagnostic(`${seconds.toFixed(2)} s of the processor, ${clock.toFixed(2)} s by the clock`);
  assert.ok(seconds > 0 && seconds < MOST_SECONDS, `${seconds} s`);
  await showAllFigures(page);
  assert.equal(await page.evaluate(() => armcalReport.scenes.length), 1);
  await page.context().close();
});
