// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { openBrowser, openReport, showAllFigures } from "./browser.mjs";
import { armcal, example, temporaryFolder } from "./tools.mjs";

const NAMES = {
  "a script": "<script>alert(1)</script>",
  "an image": "<img src=x onerror=alert(1)>",
  "the end of a script": "</script><script>alert(2)</script>",
  "quotes": "\"'`><b onmouseover=alert(3)>",
  "right-to-left text": "\u202egnp.exe שלום",
  "a long name": "x".repeat(10_000),
  "control characters": "bell \u0007 and NUL \u0000",
};
const FREE = ["arm_name", "path", "name", "description", "reason", "group", "file", "parameters", "covariance_of", "command_line"];
const FREE_AND_FEW = ["arm_name", "path", "command_line"]; // a long name in every row and chart would only be slow
const folder = temporaryFolder();
let browser;
before(async () => (browser = await openBrowser()));
after(() => browser.close());

// A calibration in whose result every text that is free is `name`.
const calibration = JSON.parse(armcal("calibrate", example("calibration", "seats.session.toml"), "--json"));

function renamed(value, name, key = "") {
  if (Array.isArray(value)) return value.map((each) => renamed(each, name, key));
  if (value && typeof value === "object") return Object.fromEntries(Object.entries(value).map(([k, v]) => [k, renamed(v, name, k)]));
  return typeof value === "string" && (name.length > 1000 ? FREE_AND_FEW : FREE).includes(key) ? name : value;
}

function reportNaming(name, file) {
  const json = join(folder, `${file}.json`);
  writeFileSync(json, JSON.stringify(renamed(calibration, name)));
  armcal("report", json, "-o", join(folder, `${file}.html`));
  return join(folder, `${file}.html`);
}

let index = 0;
for (const [kind, name] of Object.entries(NAMES)) {
  test(`${kind} is a text like any other`, async () => {
    const path = reportNaming(name, `hostile-${++index}`);
    const page = await openReport(browser, path, { viewport: { width: 390, height: 844 } });
    await showAllFigures(page);
    await page.mouse.move(200, 300);
    const shown = name.replaceAll("\u0000", "␀").replaceAll("\u0007", "␇");
    assert.ok((await page.locator("body").innerText()).includes(shown), "it is shown");
    assert.equal(await page.locator("img, body b[onmouseover]").count(), 0);
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 390, "it widens the page");
    assert.deepEqual(page.complaints, []);
    await page.context().close();
  });
}
