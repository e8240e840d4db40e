// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
// Texts in the language of the report.
let words = null;

export function say(key) {
  words ??= JSON.parse(document.getElementById("armcal-words").textContent);
  return words[key] ?? key;
}
