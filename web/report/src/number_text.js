// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
// Numbers as the drawings write them: a true minus, no thousands separators, the same in every language.
const SUPERSCRIPTS = "⁰¹²³⁴⁵⁶⁷⁸⁹";

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

export function powerText(value) {
  const exponent = Math.floor(Math.log10(value) + 1e-9);
  const factor = Math.round(value / 10 ** exponent);
  if (exponent >= -3 && exponent <= 4) return fixedText(value, Math.max(0, -exponent));
  const power = `10${exponent < 0 ? "⁻" : ""}${[...String(Math.abs(exponent))].map((c) => SUPERSCRIPTS[c]).join("")}`;
  return factor === 1 ? power : `${factor}·${power}`;
}
