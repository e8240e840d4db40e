// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
import assert from "node:assert/strict";
import { mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { openBrowser, openReport, showAllFigures } from "./browser.mjs";
import { armcal, example, temporaryFolder } from "./tools.mjs";

const NAMES = [
  "<script>alert(1)</script>",
  "<img src=x onerror=alert(1)>",
  "</script><script>alert(2)</script>",
  "\"'`><b onmouseover=alert(3)>",
  "\u202egnp.exe שלום",
  "bell \u0007 and NUL \u0000",
  "{{title}} {0} \\u003c ${armcalReport}",
];
const LONG = "x".repeat(10_000);
const FREE = ["arm_name", "path", "name", "description", "reason", "group", "file", "parameters", "covariance_of", "command_line"];
const PHONE = { width: 390, height: 844 };
const folder = temporaryFolder();
let browser;
before(async () => (browser = await openBrowser()));
after(() => browser.close());

// What a reader sees: control characters as the pictures that Unicode has for them, marks of direction as their codes.
const SEEN = { "\u0000": "␀", "\u0007": "␇", "\u202e": "[U+202E]" };
const seen = (name) => name.replace(/[\u0000\u0007\u202e]/g, (c) => SEEN[c]);

async function isShownAndHarmless(path, names) {
  const page = await openReport(browser, path, { viewport: PHONE });
  await showAllFigures(page);
  await page.mouse.move(200, 300);
  const text = await page.locator("body").innerText();
  for (const name of names) assert.ok(text.includes(seen(name)), `${name.slice(0, 60)} is not shown`);
  assert.equal(await page.locator("img, body b[onmouseover]").count(), 0);
  assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= PHONE.width, "it widens the page");
  assert.deepEqual(page.complaints, []);
  await page.context().close();
}

// Every text under a free key becomes what `next` gives.
function renamed(value, next, key = "") {
  if (Array.isArray(value)) return value.map((each) => renamed(each, next, key));
  if (value && typeof value === "object") return Object.fromEntries(Object.entries(value).map(([k, v]) => [k, renamed(v, next, k)]));
  return typeof value === "string" && FREE.includes(key) ? next(key) : value;
}

function reportOf(document, file) {
  const json = join(folder, `${file}.json`);
  writeFileSync(json, JSON.stringify(document));
  armcal("report", json, "-o", join(folder, `${file}.html`));
  return join(folder, `${file}.html`);
}

const calibration = JSON.parse(armcal("calibrate", example("calibration", "seats.session.toml"), "--json"));

test("hostile names in a result are texts like any other", async () => {
  let count = 0;
  // Columns of rows name one group and one file each; the same name stays the same.
  await isShownAndHarmless(reportOf(renamed(calibration, () => NAMES[count++ % NAMES.length]), "hostile"), NAMES);
});

test("a name of ten thousand letters is a text like any other", async () => {
  const few = ["arm_name", "path", "command_line"]; // in every row it would only be slow
  const document = { ...calibration, ...Object.fromEntries(few.filter((key) => calibration[key]).map((key) => [key, renamed(calibration[key], () => LONG, key)])) };
  document.inputs = calibration.inputs.map((input) => ({ ...input, path: LONG }));
  await isShownAndHarmless(reportOf(document, "long"), [LONG]);
});

// As users type them: TOML, CSV and names of files and folders.
test("hostile names in every file that is read are texts like any other", async () => {
  const toml = (text) => JSON.stringify(text).replaceAll("\u202e", "\\u202e").replaceAll("\u007f", "\\u007f");
  const place = join(folder, "<b>it's & \"here\"");
  mkdirSync(place);
  const write = (name, text) => {
    writeFileSync(join(place, name), text);
    return join(place, name);
  };
  write("<script>alert(4)<.csv", "position,x_mm,y_mm,z_mm\n" + points(25));
  const [script, image, end, quotes, arabic, bell, template] = NAMES;
  const verification = write(
    "hostile.verification.toml",
    [
      'schema = "armcal.verification/1"',
      `name = ${toml(script)}`,
      "reach_mm = 1200",
      '[[artefact]]',
      `name = ${toml(image)}`,
      'kind = "sphere"',
      "diameter_mm = 20",
      "U_um = 0.5",
      '[[test]]',
      'kind = "probing"',
      `artefact = ${toml(image)}`,
      'file = "<script>alert(4)<.csv"',
      "probe_diameter_mm = 0",
      "mpe_size_um = 30",
      "mpe_form_um = 30",
    ].join("\n"),
  );
  const details = write(
    "hostile.details.toml",
    [
      'schema = "armcal.details/1"',
      `title = ${toml(template)}`,
      `number = ${toml(end)}`,
      "[customer]",
      `name = ${toml(quotes)}`,
      `address = ${toml(arabic)}`,
      "[item]",
      `description = ${toml(bell)}`,
      "[[reference]]",
      `name = ${toml(script)}`,
      `certificate = ${toml(image)}`,
    ].join("\n"),
  );
  const html = join(place, "report.html");
  armcal("verify", "iso10360-12", verification, "--incomplete", "--details", details, "--report", html);
  await isShownAndHarmless(html, [script, end, quotes, arabic, bell, image, template, "<script>alert(4)<.csv"]);
});

function points(count) {
  const rows = [];
  for (let i = 0; i < count; ++i) {
    const z = 1 - (2 * i + 1) / count;
    const turn = 2.4 * i;
    const across = 10 * Math.sqrt(1 - z * z);
    rows.push(`${i % 2 ? "<i>A" : "B&ampB"},${500 + across * Math.cos(turn)},${across * Math.sin(turn)},${300 + 10 * z}`);
  }
  return rows.join("\n") + "\n";
}
