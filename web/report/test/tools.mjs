// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
import { execFileSync } from "node:child_process";
import { accessSync, constants, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { delimiter, join } from "node:path";

// Path of a program that is called by its name; null where there is none.
export function findTool(name) {
  for (const folder of (process.env.PATH ?? "").split(delimiter)) {
    const path = join(folder, name);
    try {
      accessSync(path, constants.X_OK);
      return path;
    } catch {
      // not in this folder
    }
  }
  return null;
}

export function run(program, ...args) {
  return execFileSync(program, args, { encoding: "utf8", maxBuffer: 1 << 28, stdio: ["ignore", "pipe", "pipe"] });
}

// Runs armcal; a finding (exit code 1) is a result like any other.
export function armcal(...args) {
  try {
    return run(process.env.ARMCAL, ...args);
  } catch (error) {
    if (error.status === 1) return error.stdout;
    throw new Error(`armcal ${args.join(" ")}: ${error.stderr}`);
  }
}

export function example(...parts) {
  return join(process.env.ARMCAL_EXAMPLES, ...parts);
}

export function temporaryFolder() {
  const folder = mkdtempSync(join(tmpdir(), "armcal-report-"));
  process.on("exit", () => rmSync(folder, { recursive: true, force: true }));
  return folder;
}
