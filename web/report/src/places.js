// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
// Boxes for texts on a chart: {left, right, top, bottom} in pixels of the canvas.
import { at } from "./chart_marks.js";

export const isInside = (box, { left, top, width, height }) => box.left >= left && box.right <= left + width && box.top >= top && box.bottom <= top + height;

// Of those in the plot the first that covers the least of what is taken; undefined where none is.
export function quietest(boxes, taken, bbox) {
  const covers = (box) => taken.filter((other) => box.left < other.right && other.left < box.right && box.top < other.bottom && other.top < box.bottom).length;
  return boxes.filter((box) => isInside(box, bbox)).reduce((best, box) => (best && covers(best) <= covers(box) ? best : box), undefined);
}

// Where dots are.
export function dotBoxes(u, series, radius) {
  return series
    .filter(({ mark }) => mark === "dots")
    .flatMap(({ x, y }) => x.map((value, i) => [at(u, "x", value), at(u, "y", y[i])]))
    .filter(([x, y]) => !Number.isNaN(x + y))
    .map(([x, y]) => ({ left: x - radius, right: x + radius, top: y - radius, bottom: y + radius }));
}
