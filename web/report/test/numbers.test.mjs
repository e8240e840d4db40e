// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { openBrowser, openReport } from "./browser.mjs";
import { embeddedDocument, reportsOf } from "./reports.mjs";
import { armcal } from "./tools.mjs";

const reports = reportsOf("calibration");
let browser;
before(async () => (browser = await openBrowser()));
after(() => browser.close());

test("the document in a report is what --extract gives back", () => {
  const extracted = armcal("report", reports["calibration.en"], "--extract");
  assert.deepEqual(JSON.parse(extracted), embeddedDocument(reports["calibration.en"]));
});

// From the unit of the document to the one that is shown.
const FACTORS = { mm: 1, "deg": 180 / Math.PI, "°": 180 / Math.PI, urad: 1e6, "µrad": 1e6, rad: 1, "1": 1 };

function isRoundingOf(text, value) {
  const decimals = (text.split(".")[1] ?? "").length;
  return Math.abs(Number(text.replace("−", "-")) - value) <= 0.5000001 * 10 ** -decimals;
}

for (const [name, path] of Object.entries(reports)) {
  test(`the table of parameters of ${name} says what the document says`, async () => {
    const { parameters } = embeddedDocument(path);
    const page = await openReport(browser, path, { javaScriptEnabled: false });
    const rows = await page.locator("#parameters table").first().locator("tbody tr").evaluateAll((all) => all.map((row) => [...row.cells].map((cell) => cell.textContent.trim())));
    assert.ok(rows.length >= 20);
    for (const [parameter, nominal, value, change, u, unit] of rows) {
      const said = parameters.find((each) => each.name === parameter);
      const factor = FACTORS[unit];
      assert.ok(said && factor, `${parameter} in ${unit}`);
      assert.ok(isRoundingOf(nominal, said.nominal * factor), `${parameter}: ${nominal}`);
      assert.ok(isRoundingOf(value, said.value * factor), `${parameter}: ${value}`);
      if (said.status === "held") continue;
      assert.ok(isRoundingOf(change, (said.value - said.nominal) * factor), `${parameter}: ${change}`);
      assert.ok(isRoundingOf(u, said.u * factor), `${parameter}: ${u}`);
      const digits = u.replace(/^0*\.?0*/, "").replace(".", "").length;
      assert.ok(digits >= 2, `${parameter}: u = ${u} has fewer than two digits`);
    }
    await page.context().close();
  });
}
