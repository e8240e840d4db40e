// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
// Points of a chart that can be pointed at: by mouse the nearest, by keys one after the other.
import { element } from "./element.js";
import { numberText } from "./number_text.js";

const REACH = 28; // pixels about the mouse

// {series, index, x, y}: of a bar the middle of its top.
export function pointsOf(model) {
  const points = [];
  model.series.forEach((series, s) => {
    const bars = series.mark === "bars";
    series.y.forEach((y, i) => {
      const x = bars ? (series.x[i] + series.x[i + 1]) / 2 : series.x[i];
      const hasPlace = x != null && y != null && !(model.x.scale === "log" && x <= 0) && !(model.y.scale === "log" && y <= 0);
      if (hasPlace) points.push({ series: s, index: i, x, y });
    });
  });
  return points;
}

// What is nearest to a place of the plot in pixels; null where nothing is near.
export function nearest(u, model, points, left, top) {
  let best = null;
  let least = REACH ** 2;
  for (const point of points) {
    const series = model.series[point.series];
    const dx = u.valToPos(point.x, "x") - left;
    const dy = u.valToPos(point.y, "y") - top;
    if (series.mark === "bars") {
      const from = u.valToPos(series.x[point.index], "x");
      const to = u.valToPos(series.x[point.index + 1], "x");
      if (left >= from && left < to && best == null) best = point;
      continue;
    }
    const distance = dx * dx + dy * dy;
    if (distance < least) {
      least = distance;
      best = point;
    }
  }
  return best;
}

// Beside a point: name of its series, its label, its values.
export function describe(model, point) {
  const series = model.series[point.series];
  const label = series.labels?.[point.index];
  const x = series.mark === "bars" ? `${numberText(series.x[point.index])} … ${numberText(series.x[point.index + 1])}` : numberText(point.x);
  return [
    ...[label, series.name].filter(Boolean).map((text, i) => [i === 0 ? "first" : "name", text, ""]),
    ["value", model.x.label, x],
    ["value", model.y.label, numberText(point.y)],
  ];
}

export function tipOf(rows) {
  return rows.map(([kind, name, value]) => element("div", { class: kind }, element("span", {}, name), value ? element("b", {}, value) : ""));
}

// The point `step` further along x in the same series, or the first of the next series.
export function neighbour(points, current, dx, dSeries) {
  const inOrder = (s) => points.filter((point) => point.series === s).sort((a, b) => a.x - b.x);
  if (!current) return points.length ? inOrder(points[0].series)[0] : null;
  if (dSeries) {
    const all = [...new Set(points.map((point) => point.series))];
    const next = all[(all.indexOf(current.series) + dSeries + all.length) % all.length];
    return inOrder(next).reduce((a, b) => (Math.abs(b.x - current.x) < Math.abs(a.x - current.x) ? b : a));
  }
  const row = inOrder(current.series);
  return row[Math.min(Math.max(row.indexOf(current) + dx, 0), row.length - 1)];
}
