// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { openBrowser, openReport, showAllFigures } from "./browser.mjs";
import { reportsOf } from "./reports.mjs";
import { armcal, findTool, run, temporaryFolder } from "./tools.mjs";

const A4 = { width: 595, height: 842 }; // points
const COUNTERS = { en: (x, y) => `Page ${x} of ${y}`, zh: (x, y) => `第 ${x} 页，共 ${y} 页` };
const reports = reportsOf("calibration", "verification");
const folder = temporaryFolder();
let browser;
before(async () => (browser = await openBrowser()));
after(() => browser.close());

// Chromium and Chinese fonts put blanks where a reader sees none.
const squeezed = (text) => text.replace(/\s+/g, "");

for (const [name, path] of Object.entries(reports)) {
  test(`${name} on paper: every page is numbered, nothing is cut`, async () => {
    const language = name.split(".")[1];
    const pdf = join(folder, `${name}.pdf`);
    armcal("report", path, "--pdf", pdf, "--lang", language);
    const page = await openReport(browser, path, { colorScheme: "dark" });
    await showAllFigures(page);
    await page.emulateMedia({ media: "print" });
    const shown = await page.evaluate(() => ({
      paper: getComputedStyle(document.body).backgroundColor,
      live: [...document.querySelectorAll(".live-view")].filter((view) => view.clientHeight > 0).length,
      folded: [...document.querySelectorAll("tr.folded")].filter((row) => row.clientHeight === 0).length,
    }));
    assert.deepEqual(shown, { paper: "rgb(255, 255, 255)", live: 0, folded: 0 });

    const pages = run(findTool("pdftotext"), pdf, "-").split("\f").slice(0, -1);
    pages.forEach((text, i) => assert.ok(squeezed(text).includes(squeezed(COUNTERS[language](i + 1, pages.length))), `page ${i + 1}`));
    if (name === "calibration.en") assert.deepEqual(await wordsNotOn(pages.join(" "), page), []);
    assert.deepEqual(widerThanPaper(pdf), []);
    await page.context().close();
  });
}

// Words of the page that are not on its paper. Words that a line may break, and those with raised or lowered letters,
// are not looked for.
async function wordsNotOn(paper, page) {
  const texts = await page.locator("main :is(td, th, dt, dd, h2, h3, p):visible, h1, .stamp").allInnerTexts();
  const words = new Set(texts.join(" ").split(/\s+/).filter((word) => word.length < 15 && /^[ -ÿ−]*$/.test(word) && !/[-/]./.test(word)));
  return [...words].filter((word) => !paper.includes(word));
}

// Words that reach into the margin or past the paper.
function widerThanPaper(pdf) {
  const words = run(findTool("pdftotext"), "-bbox", pdf, "-");
  const margin = 40; // points; the page has 45
  return [...words.matchAll(/<word xMin="([\d.-]+)" yMin="([\d.-]+)" xMax="([\d.-]+)" yMax="([\d.-]+)">(.*?)<\/word>/g)]
    .filter(([, left, top, right, bottom]) => left < margin || right > A4.width - margin || top < 30 || bottom > A4.height - 15)
    .map(([, , , , , text]) => text);
}

test("paper has our number where the report has one, and fonts are in the file", async () => {
  const html = readFileSync(reports["calibration.en"], "utf8");
  assert.match(html, /@page\{@bottom-left\{content:/);
  const fonts = run(findTool("pdffonts"), join(folder, "calibration.zh.pdf")).split("\n").slice(2).filter(Boolean);
  assert.ok(fonts.length > 0);
  for (const font of fonts) assert.match(font, /\byes\s+(yes|no)\s+(yes|no)\s+\d+\s+\d+\s*$/, font);
});
