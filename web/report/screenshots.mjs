// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
//
// node screenshots.mjs REPORTS IMAGES: pictures of REPORTS/report.en.html and report.zh.html (scripts/screenshots).
import { join } from "node:path";
import { openBrowser, openReport, painted, showAllFigures } from "./test/browser.mjs";
import { findTool, run } from "./test/tools.mjs";

const [reports, images] = process.argv.slice(2);
const report = (language) => join(reports, `report.${language}.html`);
const browser = await openBrowser();

async function picture(name, language, options, selector = null) {
  const page = await openReport(browser, report(language), options);
  await showAllFigures(page);
  await page.evaluate((wanted) => (wanted ? document.querySelector(wanted).scrollIntoView({ behavior: "instant" }) : scrollTo(0, 0)), selector);
  for (let i = 0; i < 5; ++i) await painted(page);
  await page.screenshot({ path: join(images, `${name}.png`) });
  await page.context().close();
}

async function paper(name, language) {
  const page = await openReport(browser, report(language));
  const pdf = join(reports, `${language}.pdf`);
  await page.pdf({ path: pdf, preferCSSPageSize: true });
  run(findTool("pdftoppm"), "-r", "80", "-f", "1", "-l", "1", "-singlefile", "-png", pdf, join(images, name));
  await page.context().close();
}

const desk = { viewport: { width: 1280, height: 900 } };
const phone = { viewport: { width: 390, height: 844 }, deviceScaleFactor: 2, isMobile: true, hasTouch: true };
await picture("report-light", "en", { ...desk, colorScheme: "light" });
await picture("report-dark", "en", { ...desk, colorScheme: "dark" }, "figure:has(.scene)");
await picture("report-phone", "zh", { ...phone, colorScheme: "light" });
await paper("report-paper", "en");
await browser.close();
