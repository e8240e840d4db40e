// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
import assert from "node:assert/strict";
import { readFileSync, statSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { openBrowser, openReport } from "./browser.mjs";
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
    .replace("count = 60", `count = ${POSES}`);
  writeFileSync(join(folder, "thousand.scenario.toml"), scenario);
  armcal("simulate", join(folder, "thousand.scenario.toml"), "-o", join(folder, "readings"));
  path = join(folder, "thousand.html");
  armcal("calibrate", join(folder, "readings", "thousand.session.toml"), "--report", path);
});
after(() => browser.close());

test(`a report of ${POSES} poses stays small`, () => {
  assert.ok(embeddedDocument(path).groups.some(({ count }) => count >= POSES));
  assert.ok(statSync(path).size < MOST_BYTES, `${statSync(path).size} bytes`);
});

test(`a report of ${POSES} poses opens within ${MOST_SECONDS} s`, async (context) => {
  const seconds = [];
  for (let attempt = 0; attempt < 3; ++attempt) {
    const page = await openReport(browser, path);
    await page.evaluate(() => new Promise((done) => requestIdleCallback(done)));
    seconds.push((await page.evaluate(() => performance.now())) / 1000);
    await page.context().close();
  }
  context.diagnostic(`opened in ${seconds.map((s) => s.toFixed(2)).join(", ")} s`);
  assert.ok(Math.min(...seconds) < MOST_SECONDS, `${seconds}`);
});
