// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
// Real reports, made by armcal from the examples.
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { armcal, example } from "./tools.mjs";

const HISTORY = "check @check/week-NN.csv --arm @arms/seven-joint.arm.toml --length 400 --limit 0.08 --length-limit 0.05 --history &checks.db";

// Words that begin with @ are files of the examples, with & files beside the reports. The first five, which have every
// kind of figure, in every language; the others have the same kinds of blocks.
const ORDERS = {
  calibration: "calibrate @calibration/seats.session.toml",
  tracker: "calibrate @calibration/tracker.session.toml",
  "symmetric-point": "symmetric-point @wang2016/as-printed.symmetric.toml",
  verification: "verify iso10360-12 @verification/reverification.verification.toml",
  sphere: "verify sphere @sphere/five-articulations.csv --arm @arms/romer-infinite-2.0.arm.toml --diameter 15.8754 --tip-diameter 6",
  check: `${HISTORY.replace("NN", "12")} --time 2026-03-23`,
  "plan-verification": "plan verification @arms/seven-joint.arm.toml --standard b89.4.22",
  "plan-symmetric-point": "plan symmetric-point @arms/romer-infinite-2.0.arm.toml --readings 30 --grid 90",
  compare: "compare --methods nominal --methods c* --methods half-turns-40",
  probe: "probe @arms/romer-infinite-2.0.arm.toml @sphere/five-articulations.csv --sphere-diameter 15.8754 --tip-diameter 6 --limit 0.03",
  diff: "diff @calibration/tracker.calibration.json @calibration/seats.calibration.json",
  fit: "fit sphere @points/sphere.csv",
  predict: "predict @calibration/tracker.calibration.json @angles/six-joints.csv",
  convert: "convert @arms/puma-560.arm.toml --to dh-classic",
};
const LANGUAGES = ["en", "zh"];
const IN_ENGLISH_ONLY = Object.keys(ORDERS).slice(5);
const languagesOf = (order) => (IN_ENGLISH_ONLY.includes(order) ? ["en"] : LANGUAGES);

const folder = () => process.env.ARMCAL_REPORTS;
const path = (order, language) => join(folder(), `${order}.${language}.html`);
const places = { "@": (name) => example(...name.split("/")), "&": (name) => join(folder(), name) };
const wordsOf = (order) => order.split(" ").map((word) => places[word[0]]?.(word.slice(1)) ?? word);

// Every report in its languages, into the folder ARMCAL_REPORTS. Called once, before the tests.
export function makeReports() {
  for (let week = 1; week < 12; ++week) armcal(...wordsOf(HISTORY.replace("NN", String(week).padStart(2, "0"))), "--time", day(week));
  for (const [order, words] of Object.entries(ORDERS)) {
    const [first, ...others] = languagesOf(order);
    armcal(...wordsOf(words), "--report", path(order, first), "--lang", first);
    for (const language of others) armcal("report", path(order, first), "-o", path(order, language), "--lang", language);
  }
}

const day = (week) => new Date(Date.UTC(2026, 0, 7 * week - 2)).toISOString().slice(0, 10);

// {"calibration.en": path, ..}
export function reportsOf(...orders) {
  const wanted = orders.length > 0 ? orders : Object.keys(ORDERS);
  return Object.fromEntries(wanted.flatMap((order) => languagesOf(order).map((language) => [`${order}.${language}`, path(order, language)])));
}

// What the scripts of a report are given.
export function liveModels(path) {
  const html = readFileSync(path, "utf8");
  return [...html.matchAll(/<script type="application\/json" class="live">(.*?)<\/script>/gs)].map(([, json]) => JSON.parse(json));
}

export function embeddedDocument(path) {
  const html = readFileSync(path, "utf8");
  return JSON.parse(/<script type="application\/json" id="armcal-result"[^>]*>(.*?)<\/script>/s.exec(html)[1]);
}
