// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
// A browser and reports open in it, watched: nothing may be fetched, nothing complained about.
import { chromium } from "playwright-core";
import { pathToFileURL } from "node:url";
import { findTool } from "./tools.mjs";

export async function openBrowser() {
  const args = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--hide-scrollbars"];
  return chromium.launch({ executablePath: findTool("chromium"), args });
}

// options: of browser.newContext(): viewport, colorScheme, javaScriptEnabled
export async function openReport(browser, path, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, ...options });
  const page = await context.newPage();
  page.complaints = [];
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type())) page.complaints.push(message.text());
  });
  page.on("pageerror", (error) => page.complaints.push(error.message));
  page.on("dialog", (dialog) => {
    page.complaints.push(`dialog: ${dialog.message()}`);
    dialog.dismiss();
  });
  const url = pathToFileURL(path).href;
  page.on("request", (request) => {
    if (request.url() !== url) page.complaints.push(`request: ${request.url().slice(0, 200)}`);
  });
  await page.goto(url);
  return page;
}

// Scrolls to every live figure in turn, so that each is made, and waits until all are painted.
export async function showAllFigures(page) {
  for (const figure of await page.locator("figure:has(> script.live)").elementHandles()) {
    await figure.evaluate((element) => element.scrollIntoView({ block: "center", behavior: "instant" }));
    const button = await page.waitForFunction((element) => element.matches(".is-live, :has(> .note)") || element.querySelector(".enliven"), figure);
    await button.evaluate((found) => found.click?.());
    await page.waitForFunction((element) => element.matches(".is-live, :has(> .note)"), figure);
  }
  await painted(page);
}

export async function painted(page) {
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
}
