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

// Ticks of a logarithmic axis: all as decimals where these are short, else all as powers.
export function powerTexts(ticks) {
  const decimals = ticks.every((tick) => tick > 0.9e-3 && tick < 1.1e4);
  return ticks.map((tick) => (decimals ? withMinus(String(tick)) : powerText(tick)));
}

function powerText(value) {
  const exponent = Math.floor(Math.log10(value) + 1e-9);
  const factor = Math.round(value / 10 ** exponent);
  const power = `10${exponent < 0 ? "⁻" : ""}${[...String(Math.abs(exponent))].map((c) => SUPERSCRIPTS[c]).join("")}`;
  return factor === 1 ? power : `${factor}·${power}`;
}

// Powers of ten between two ends, a dozen at most; with their doubles and fivefolds where powers alone are few.
export function logTicks(low, high) {
  const first = Math.floor(Math.log10(low));
  const last = Math.ceil(Math.log10(high));
  const stride = Math.max(1, Math.ceil((last - first) / 8));
  const factors = last - first <= 3 ? [1, 2, 5] : [1];
  const ticks = [];
  for (let power = first; power <= last; power += stride) for (const factor of factors) ticks.push(Number(`${factor}e${power}`));
  return ticks.filter((tick) => tick >= low && tick <= high);
}
