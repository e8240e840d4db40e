// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
// Real reports, made by armcal from the examples.
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { armcal, example } from "./tools.mjs";

// Words that begin with @ are files of the examples.
const ORDERS = {
  calibration: "calibrate @calibration/seats.session.toml",
  tracker: "calibrate @calibration/tracker.session.toml",
  "symmetric-point": "symmetric-point @wang2016/as-printed.symmetric.toml",
  verification: "verify iso10360-12 @verification/reverification.verification.toml",
  sphere: "verify sphere @sphere/five-articulations.csv --arm @arms/romer-infinite-2.0.arm.toml --diameter 15.8754 --tip-diameter 6",
};
const LANGUAGES = ["en", "zh"];

const path = (order, language) => join(process.env.ARMCAL_REPORTS, `${order}.${language}.html`);

// Every report in every language, into the folder ARMCAL_REPORTS. Called once, before the tests.
export function makeReports() {
  for (const [order, words] of Object.entries(ORDERS)) {
    const [first, ...others] = LANGUAGES;
    const named = words.split(" ").map((word) => (word.startsWith("@") ? example(...word.slice(1).split("/")) : word));
    armcal(...named, "--report", path(order, first), "--lang", first);
    for (const language of others) armcal("report", path(order, first), "-o", path(order, language), "--lang", language);
  }
}

// {"calibration.en": path, ..}
export function reportsOf(...orders) {
  const wanted = orders.length > 0 ? orders : Object.keys(ORDERS);
  return Object.fromEntries(wanted.flatMap((order) => LANGUAGES.map((language) => [`${order}.${language}`, path(order, language)])));
}

// What the scripts of a report are given.
export function liveModels(path) {
  const html = readFileSync(path, "utf8");
  return [...html.matchAll(/<script type="application\/json" class="live">(.*?)<\/script>/gs)].map(([, json]) => JSON.parse(json));
}

export function embeddedDocument(path) {
  const html = readFileSync(path, "utf8");
  return JSON.parse(/<script type="application\/json" id="armcal-result">(.*?)<\/script>/s.exec(html)[1]);
}
