// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { ticksOf } from "../src/ticks.js";

const cases = JSON.parse(readFileSync(new URL("tick_cases.json", import.meta.url), "utf8"));

// The drawings are held against the same table (src/armcal/report/chart/scale_test.cc).
for (const { scale, low, high, about, ticks } of cases) {
  test(`a ${scale} axis from ${low} to ${high} has the marks of its drawing`, () => {
    const found = ticksOf(scale, low, high, about);
    assert.deepEqual(found.map(({ text }) => text), ticks.map(([, text]) => text));
    found.forEach(({ value }, i) => assert.ok(Math.abs(value - ticks[i][0]) <= 1e-9 * Math.abs(ticks[i][0])));
  });
}

test("no range is without marks, and all are in it", () => {
  for (let i = 0; i < 500; ++i) {
    const low = 10 ** (((i * 7) % 40) - 20);
    const high = low * 10 ** (0.02 + ((i * 13) % 100) / 10);
    const found = ticksOf("log", low, high, 5);
    assert.ok(found.length >= 2, `${low} .. ${high}`);
    for (const { value } of found) assert.ok(value >= low && value <= high);
  }
});

test("what is counted has no half", () => {
  assert.deepEqual(ticksOf("linear", 0.5, 3.5, 9, 1).map(({ text }) => text), ["1", "2", "3"]);
});
