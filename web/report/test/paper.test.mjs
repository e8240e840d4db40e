// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
import assert from "node:assert/strict";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { openBrowser, openReport, showAllFigures } from "./browser.mjs";
import { reportsOf } from "./reports.mjs";
import { armcal, example, findTool, run, temporaryFolder } from "./tools.mjs";

const A4 = { width: 595, height: 842 }; // points
const COUNTERS = { en: (x, y) => `Page ${x} of ${y}`, zh: (x, y) => `第 ${x} 页，共 ${y} 页` };
const reports = reportsOf("calibration", "verification");
const folder = temporaryFolder();
let browser;
before(async () => (browser = await openBrowser()));
after(() => browser.close());

const pagesOf = (pdf) => run(findTool("pdftotext"), pdf, "-").split("\f").slice(0, -1);
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

    const pages = pagesOf(pdf);
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

// Tables of 45 rows about as high as a page, and of 8 rows near its foot, a little further down on each page.
test("no row of a table stands alone on a page", async () => {
  const page = await openReport(browser, reportsOf("fit")["fit.en"], { javaScriptEnabled: false });
  await page.evaluate(() => {
    const table = (name, count) => {
      const rows = Array.from({ length: count }, (_, i) => `<tr><th class="text">${name}row${i}</th><td class="num">1</td></tr>`);
      return `<div class="table"><p class="caption">${name}caption</p><div class="scroll"><table><thead><tr><th class="text">Name</th><th class="num">n</th></tr></thead><tbody>${rows.join("")}</tbody></table></div><p class="note">${name}note</p></div>`;
    };
    const pages = [[5, 45], [212, 8]].flatMap(([from_mm, count]) =>
      Array.from({ length: 10 }, (_, k) => `<section style="break-before: page"><div style="height: ${from_mm + 1.3 * k}mm"></div>${table(`t${count}n${k}`, count)}</section>`),
    );
    document.querySelector("main").innerHTML = pages.join("");
  });
  const pdf = join(folder, "rows.pdf");
  await page.pdf({ path: pdf, preferCSSPageSize: true });
  let rows = 0;
  for (const text of pagesOf(pdf)) {
    const found = text.match(/t\d+n\d+row\d+/g) ?? [];
    rows += found.length;
    assert.notEqual(found.length, 1, `${found} is alone`);
    if (/caption|note/.test(text)) assert.ok(found.length > 1, `${text} has no rows`);
  }
  assert.equal(rows, 10 * (45 + 8));
  await page.context().close();
});

const REPORT = { en: "Report 2026-0117", zh: "报告编号 2026-0117" };

for (const [language, number] of Object.entries(REPORT)) {
  test(`paper in ${language} has our number and its own on every page, and fonts are in the file`, () => {
    const pdf = join(folder, `numbered.${language}.pdf`);
    const html = join(folder, `numbered.${language}.html`);
    armcal("calibrate", example("calibration", "tracker.session.toml"), "--details", example("report", "laboratory.details.toml"), "--report", html, "--lang", language);
    armcal("report", html, "--pdf", pdf, "--lang", language);
    const pages = pagesOf(pdf);
    assert.ok(pages.length > 2);
    pages.forEach((text, i) => {
      assert.ok(squeezed(text).includes(squeezed(number)), `no number on page ${i + 1}`);
      assert.ok(squeezed(text).includes(squeezed(COUNTERS[language](i + 1, pages.length))), `page ${i + 1} is not counted`);
    });
    const fonts = run(findTool("pdffonts"), pdf).split("\n").slice(2).filter(Boolean);
    assert.ok(fonts.length > 0);
    for (const font of fonts) assert.match(font, /\byes\s+(yes|no)\s+(yes|no)\s+\d+\s+\d+\s*$/, font);
  });
}
