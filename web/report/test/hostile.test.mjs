// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
import assert from "node:assert/strict";
import { cpSync, readFileSync, writeFileSync } from "node:fs";
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
const folder = temporaryFolder();
let browser;
before(async () => (browser = await openBrowser()));
after(() => browser.close());

// A calibration whose every text is `name`: of the arm, of the customer, of parameters, of files.
function reportNaming(name, file) {
  const saved = JSON.parse(armcal("calibrate", example("calibration", "seats.session.toml"), "--json"));
  const json = join(folder, `${file}.json`);
  const html = join(folder, `${file}.html`);
  writeFileSync(json, JSON.stringify(renamed(saved, name)));
  const details = join(folder, "details.toml");
  writeFileSync(details, `[report]\nnumber = ${JSON.stringify(name.slice(0, 60)).replaceAll("\\u202e", "")}\n`);
  armcal("report", json, "-o", html, "--force");
  return html;
}

// Every text that says nothing to the program, which knows some by name.
function renamed(value, name, key = "") {
  if (Array.isArray(value)) return value.map((each) => renamed(each, name, key));
  if (value && typeof value === "object") return Object.fromEntries(Object.entries(value).map(([k, v]) => [k, renamed(v, name, k)]));
  const names = ["arm", "name", "file", "path", "message", "place", "label", "title", "customer"];
  return typeof value === "string" && names.includes(key) ? name : value;
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
