// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
// Which part of the plane a chart shows.

function extent(values, range, isLog) {
  for (const value of values) {
    if (value == null || (isLog && value <= 0)) continue;
    if (value < range[0]) range[0] = value;
    if (value > range[1]) range[1] = value;
  }
}

function padded([low, high], axis) {
  if (axis.scale === "log") {
    if (!(low < Infinity)) return [0.1, 10];
    const grow = low === high ? 2 : (high / low) ** 0.04;
    return [low / grow, high * grow];
  }
  if (!(low < Infinity)) return [0, 1];
  const pad = low === high ? Math.abs(low) * 0.1 || 1 : 0.04 * (high - low);
  // An end that was asked for is where the axis ends.
  return [axis.low != null && low >= axis.low ? axis.low : low - pad, axis.high != null && high <= axis.high ? axis.high : high + pad];
}

// Ranges that hold everything: {x: [low, high], y: [low, high]}.
export function fullRanges(model) {
  const ranges = {};
  for (const key of ["x", "y"]) {
    const axis = model[key];
    const isLog = axis.scale === "log";
    const range = [Infinity, -Infinity];
    for (const series of model.series) {
      extent(series[key], range, isLog);
      if (key === "y" && series.mark === "bars" && !isLog) extent([0], range, isLog);
    }
    for (const line of model.lines) if (line.vertical === (key === "x")) extent([line.at], range, isLog);
    extent([axis.low, axis.high], range, isLog);
    const stands = key === "y" && axis.low == null && model.series.some((series) => series.mark === "bars");
    ranges[key] = padded(range, stands ? { ...axis, low: 0 } : axis);
  }
  return ranges;
}

// A millimetre as long either way: the axis with more room gets the longer range.
export function equalRanges(ranges, width, height) {
  const spans = { x: ranges.x[1] - ranges.x[0], y: ranges.y[1] - ranges.y[0] };
  const perUnit = Math.min(width / spans.x, height / spans.y);
  const grown = (range, more) => [range[0] - more / 2, range[1] + more / 2];
  return { x: grown(ranges.x, width / perUnit - spans.x), y: grown(ranges.y, height / perUnit - spans.y) };
}

// The same, `factor` times as long about its middle.
export function zoomed(range, factor, isLog) {
  const to = isLog ? Math.log : (v) => v;
  const from = isLog ? Math.exp : (v) => v;
  const middle = (to(range[0]) + to(range[1])) / 2;
  const half = ((to(range[1]) - to(range[0])) / 2) * factor;
  return [from(middle - half), from(middle + half)];
}

// The same range where a value is in it, else one as long about the value.
export function withValue(range, value, isLog) {
  if (value >= range[0] && value <= range[1]) return range;
  if (isLog) {
    const half = Math.sqrt(range[1] / range[0]);
    return [value / half, value * half];
  }
  const half = (range[1] - range[0]) / 2;
  return [value - half, value + half];
}
