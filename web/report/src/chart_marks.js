// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
// Draws series and lines of a chart on the canvas of uPlot.
import { colour } from "./theme.js";
import { dashOf, isOutline, markRadius, seriesColour, shapePath } from "./shapes.js";

const TONES = { good: "--good", bad: "--bad", warning: "--warning", neutral: "--ink" };

// Pixels of the canvas; NaN where a value has no place on a logarithmic axis.
export function at(u, key, value) {
  const isMissing = value == null || (u.scales[key].distr === 3 && value <= 0);
  return isMissing ? NaN : u.valToPos(value, key, true);
}

export function inPlot(u, draw) {
  const { ctx, bbox } = u;
  ctx.save();
  ctx.beginPath();
  ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  ctx.clip();
  draw(ctx, devicePixelRatio);
  ctx.restore();
}

function drawDots(u, series, ctx, scale) {
  const r = markRadius(series.x.length) * scale;
  const path = new Path2D();
  series.x.forEach((value, i) => {
    const x = at(u, "x", value);
    const y = at(u, "y", series.y[i]);
    if (!Number.isNaN(x + y)) path.addPath(new Path2D(shapePath(series.style, x, y, r)));
  });
  ctx.globalAlpha = 0.8;
  ctx.lineWidth = 1.5 * scale;
  if (isOutline(series.style)) ctx.stroke(path);
  else ctx.fill(path);
}

function drawLine(u, series, ctx, scale) {
  ctx.lineWidth = 2 * scale;
  ctx.lineJoin = "round";
  ctx.setLineDash(dashOf(series.style).map((length) => length * scale));
  ctx.beginPath();
  let previous = NaN;
  series.x.forEach((value, i) => {
    const x = at(u, "x", value);
    const y = at(u, "y", series.y[i]);
    if (Number.isNaN(x + y)) {
      previous = NaN;
      return;
    }
    if (Number.isNaN(previous)) ctx.moveTo(x, y);
    else {
      if (series.mark === "steps") ctx.lineTo(x, previous);
      ctx.lineTo(x, y);
    }
    previous = y;
  });
  ctx.stroke();
}

function drawBars(u, series, ctx, scale) {
  const { min, max, distr } = u.scales.y;
  const ground = at(u, "y", distr === 3 ? min : Math.min(Math.max(0, min), max));
  const path = new Path2D();
  series.y.forEach((value, i) => {
    const left = at(u, "x", series.x[i]);
    const right = at(u, "x", series.x[i + 1]);
    const top = at(u, "y", value);
    if (value && !Number.isNaN(left + right + top)) path.rect(left, top, right - left, ground - top);
  });
  ctx.lineWidth = scale;
  ctx.globalAlpha = 0.3;
  ctx.fill(path);
  ctx.globalAlpha = 1;
  ctx.stroke(path);
}

const MARKS = { dots: drawDots, line: drawLine, steps: drawLine, bars: drawBars };

export function drawSeries(u, series) {
  inPlot(u, (ctx, scale) => {
    ctx.strokeStyle = ctx.fillStyle = colour(seriesColour(series.style));
    MARKS[series.mark](u, series, ctx, scale);
  });
}

// Limits and means.
export function drawLines(u, lines) {
  inPlot(u, (ctx, scale) => {
    const { left, top, width, height } = u.bbox;
    for (const line of lines) {
      const place = at(u, line.vertical ? "x" : "y", line.at);
      if (Number.isNaN(place)) continue;
      ctx.strokeStyle = lineColour(line);
      ctx.lineWidth = 1.6 * scale;
      ctx.setLineDash((line.tone === "neutral" ? [2, 3] : [6, 3]).map((length) => length * scale));
      ctx.beginPath();
      ctx.moveTo(line.vertical ? place : left, line.vertical ? top : place);
      ctx.lineTo(line.vertical ? place : left + width, line.vertical ? top + height : place);
      ctx.stroke();
    }
  });
}

export const lineColour = ({ tone }) => colour(TONES[tone] ?? "--ink");
