// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
// Numbers as the drawings write them: a true minus, no thousands separators, the same in every language.
const withMinus = (text) => text.replace("-", "−");

export function fixedText(value, decimals) {
  const text = value.toFixed(decimals);
  return withMinus(Number(text) === 0 ? (0).toFixed(decimals) : text);
}

// Six digits are more than any figure shows.
export function numberText(value) {
  if (!Number.isFinite(value)) return "";
  return withMinus(String(Number(value.toPrecision(6))));
}
