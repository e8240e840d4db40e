// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
//
// node build.mjs OUTPUT: one script of everything in src/, small enough to stand in every report.
import { build } from "esbuild";
import { existsSync, readFileSync, writeFileSync } from "node:fs";

const MOST_BYTES = 800_000; // all assets of a report shall stay below a megabyte
// What would end the script element, begin a comment of HTML, or end the raw string of C++ that the script stands in.
const FORBIDDEN = [/<\/script/i, /<!--/, /\)armcal-file"/];

const output = process.argv[2];
const { outputFiles } = await build({
  entryPoints: ["src/main.js"],
  bundle: true,
  minify: true,
  write: false,
  format: "iife",
  target: "es2022",
  charset: "ascii",
  legalComments: "none",
  loader: { ".css": "text" },
});
const notice = readFileSync("NOTICE.txt", "utf8").trim();
const script = `/*\n${notice}\n*/\n${outputFiles[0].text}`;
for (const pattern of FORBIDDEN) {
  if (pattern.test(script)) throw new Error(`the script holds ${pattern}`);
}
if (script.length > MOST_BYTES) throw new Error(`the script has ${script.length} bytes, more than ${MOST_BYTES}`);
if (!existsSync(output) || readFileSync(output, "utf8") !== script) writeFileSync(output, script);
console.log(`${output}: ${script.length} bytes`);
