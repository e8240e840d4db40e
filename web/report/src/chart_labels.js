// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
// Words of limits and means, over the data: each at the end and on the side of its line where it covers the least.
import { at, inPlot, lineColour } from "./chart_marks.js";
import { dotBoxes, quietest } from "./places.js";
import { colour } from "./theme.js";

const SIZE = 12;
const GAP = 4;

export function drawLabels(u, { lines, series }, font) {
  inPlot(u, (ctx, scale) => {
    ctx.font = font(SIZE * scale);
    ctx.textAlign = "left";
    ctx.textBaseline = "middle";
    ctx.lineJoin = "round";
    const taken = dotBoxes(u, series, 3 * scale);
    for (const line of lines) {
      const place = at(u, line.vertical ? "x" : "y", line.at);
      if (!line.label || Number.isNaN(place)) continue;
      const box = quietest(boxesAlong(line, place, ctx.measureText(line.label).width, u.bbox, scale), taken, u.bbox);
      if (!box) continue;
      taken.push(box);
      ctx.lineWidth = 4 * scale;
      ctx.strokeStyle = colour("--paper");
      ctx.strokeText(line.label, box.left, (box.top + box.bottom) / 2);
      ctx.fillStyle = lineColour(line);
      ctx.fillText(line.label, box.left, (box.top + box.bottom) / 2);
    }
  });
}

function boxesAlong({ vertical }, place, width, { left, top, width: across, height: down }, scale) {
  const gap = GAP * scale;
  const height = SIZE * scale;
  const corners = vertical
    ? [top + gap, top + down - gap - height].flatMap((y) => [[place + gap, y], [place - gap - width, y]])
    : [left + across - gap - width, left + gap, left + (across - width) / 2].flatMap((x) => [[x, place - gap - height], [x, place + gap]]);
  return corners.map(([x, y]) => ({ left: x, top: y, right: x + width, bottom: y + height }));
}
