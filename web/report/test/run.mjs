// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
//
// node run.mjs ARMCAL EXAMPLES [TEST ..]: tests of reports in a real browser, all or those named ("pace").
// Leaves with 77, and says why, where there is none.
import { spawnSync } from "node:child_process";
import { readdirSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { makeReports } from "./reports.mjs";
import { findTool, temporaryFolder } from "./tools.mjs";

function skip(why) {
  console.log(`skipped: ${why}`);
  process.exit(77);
}

if (Number(process.versions.node.split(".")[0]) < 20) skip(`playwright-core needs Node 20 (this is ${process.version})`);
for (const [tool, source] of [["chromium", "chromium"], ["pdftotext", "poppler-utils"], ["pdftoppm", "poppler-utils"]]) {
  if (!findTool(tool)) skip(`${tool} is not here (Debian: ${source})`);
}
try {
  createRequire(import.meta.url).resolve("playwright-core");
} catch {
  skip("npm ci has not installed playwright-core");
}

const [armcal, examples] = process.argv.slice(2, 4).map((path) => resolve(path));
const wanted = process.argv.slice(4).map((name) => `${name}.test.mjs`);
Object.assign(process.env, { ARMCAL: armcal, ARMCAL_EXAMPLES: examples, ARMCAL_REPORTS: temporaryFolder() });
makeReports();
const here = dirname(fileURLToPath(import.meta.url));
const tests = readdirSync(here)
  .filter((name) => (wanted.length > 0 ? wanted.includes(name) : name.endsWith(".test.mjs")))
  .map((name) => join(here, name));
const { status } = spawnSync(process.execPath, ["--test", "--test-concurrency=2", "--test-reporter=spec", ...tests], { stdio: "inherit" });
process.exitCode = status ?? 1;
