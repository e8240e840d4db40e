// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
// Short texts beside dots: each where it covers the fewest dots and other texts.
import { at, inPlot } from "./chart_marks.js";
import { dotBoxes, quietest } from "./places.js";
import { colour } from "./theme.js";

const SIZE = 12;
const GAP = 6;

export function drawTags(u, series, font) {
  inPlot(u, (ctx, scale) => {
    ctx.font = font(SIZE * scale);
    ctx.textAlign = "left";
    ctx.textBaseline = "middle";
    ctx.lineJoin = "round";
    const taken = dotBoxes(u, series, GAP * scale);
    for (const { x, y, tags } of series) {
      tags?.forEach((tag, i) => {
        const boxes = boxesAbout(at(u, "x", x[i]), at(u, "y", y[i]), ctx.measureText(tag).width, scale);
        const box = quietest(boxes, taken, u.bbox);
        if (!box) return; // its dot is not in view
        taken.push(box);
        ctx.lineWidth = 4 * scale;
        ctx.strokeStyle = colour("--paper");
        ctx.strokeText(tag, box.left, (box.top + box.bottom) / 2);
        ctx.fillStyle = colour("--ink");
        ctx.fillText(tag, box.left, (box.top + box.bottom) / 2);
      });
    }
  });
}

function boxesAbout(x, y, width, scale) {
  const height = SIZE * scale;
  const gap = (GAP + 1) * scale;
  const corners = [
    [x + gap, y - height / 2],
    [x - gap - width, y - height / 2],
    [x - width / 2, y - gap - height],
    [x - width / 2, y + gap],
  ];
  return corners.map(([left, top]) => ({ left, top, right: left + width, bottom: top + height }));
}
