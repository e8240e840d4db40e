// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { openBrowser, openReport } from "./browser.mjs";
import { reportsOf } from "./reports.mjs";

const reports = reportsOf("calibration", "verification");
let browser;
before(async () => (browser = await openBrowser()));
after(() => browser.close());

for (const [name, path] of Object.entries(reports)) {
  test(`${name} is whole without scripts`, async () => {
    const page = await openReport(browser, path, { javaScriptEnabled: false });
    assert.equal(await page.locator("button:visible").count(), 0);
    const hidden = await page.locator("figure .drawing").evaluateAll((all) => all.filter((drawing) => drawing.clientHeight < 50).map((drawing) => drawing.closest("figure").id));
    assert.deepEqual(hidden, []);
    const folded = page.locator("tr.folded");
    if (await folded.count()) {
      assert.ok(await folded.first().isHidden());
      await page.locator(".fold input").first().check();
      assert.ok(await folded.first().isVisible());
    }
    assert.deepEqual(page.complaints, []);
    await page.context().close();
  });
}
