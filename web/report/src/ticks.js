// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
// Marks of an axis: the same as in the drawings (src/armcal/report/chart/scale.cc), which both tests hold against
// test/tick_cases.json.
import { fixedText } from "./number_text.js";

const FEWER = 0.8; // of a step: a few ticks more rather than half as many
const MOST_PER_NAME = 5; // decades that have a mark each, if only one of so many a name
const FEWEST_NAMED = 3;
const ROUNDING = 1e-9; // of a step
const SUPERSCRIPTS = "⁰¹²³⁴⁵⁶⁷⁸⁹";

const exponentOf = (positive) => Math.floor(Math.log10(positive) + ROUNDING);
const superscript = (exponent) => `${exponent < 0 ? "⁻" : ""}${[...String(Math.abs(exponent))].map((c) => SUPERSCRIPTS[c]).join("")}`;

export function niceStep(atLeast) {
  const power = 10 ** Math.floor(Math.log10(atLeast));
  return ([1, 2, 5].find((factor) => factor * power >= atLeast * (1 - ROUNDING)) ?? 10) * power;
}

function powerText(factor, exponent) {
  if (exponent >= -4 && exponent <= 4) return fixedText(factor * 10 ** exponent, Math.max(0, -exponent));
  const power = `10${superscript(exponent)}`;
  return factor === 1 ? power : `${factor}×${power}`;
}

// One text for all ticks of an axis: as many decimals as the step needs, powers where these are many.
function tickText(value, step, largest) {
  if (value === 0) return "0";
  const stepExponent = exponentOf(step);
  const exponent = exponentOf(largest);
  if (exponent < 6 && stepExponent > -6) return fixedText(value, Math.max(0, -stepExponent));
  return `${fixedText(value / 10 ** exponent, Math.min(Math.max(exponent - stepExponent, 0), 12))}×10${superscript(exponent)}`;
}

function linearTicks(low, high, about, leastStep) {
  const step = Math.max(leastStep, niceStep((FEWER * (high - low)) / Math.max(1, about)));
  const largest = Math.max(Math.abs(low), Math.abs(high));
  const ticks = [];
  for (let i = Math.ceil(low / step - ROUNDING); i <= Math.floor(high / step + ROUNDING); ++i) {
    const value = i === 0 ? 0 : Math.min(Math.max(i * step, low), high);
    ticks.push({ value, text: tickText(i === 0 ? 0 : i * step, step, largest) });
  }
  return ticks;
}

function decadeTicks(low, high, about, namesBetween) {
  const decades = Math.log10(high) - Math.log10(low);
  const every = Math.max(1, Math.ceil(decades / Math.max(1, about)));
  const ticks = [];
  for (let exponent = exponentOf(low); exponent <= exponentOf(high); ++exponent) {
    for (const factor of [1, 2, 5]) {
      const value = factor * 10 ** exponent;
      const isInside = value >= low * (1 - ROUNDING) && value <= high * (1 + ROUNDING);
      const isNamed = factor === 1 ? exponent % every === 0 : namesBetween;
      const hasRoom = factor === 1 ? every <= MOST_PER_NAME : every === 1;
      if (!isInside || !(isNamed || hasRoom)) continue;
      ticks.push({ value: Math.min(Math.max(value, low), high), text: isNamed ? powerText(factor, exponent) : "" });
    }
  }
  return ticks;
}

// @param about      so many with texts
// @param leastStep  of a linear axis: 1 where things are counted
// @return [{value, text}], the text empty for a small mark
export function ticksOf(scale, low, high, about, leastStep = 0) {
  if (scale !== "log") return linearTicks(low, high, about, leastStep);
  const decades = Math.log10(high) - Math.log10(low);
  for (const namesBetween of 3 * decades <= about ? [true] : [false, true]) {
    const ticks = decadeTicks(low, high, about, namesBetween);
    if (ticks.filter(({ text }) => text).length >= FEWEST_NAMED) return ticks;
  }
  return linearTicks(low, high, about, 0);
}
