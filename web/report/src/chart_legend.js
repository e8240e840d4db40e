// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
import { element } from "./element.js";
import { dashOf, isOutline, seriesColour, shapePath } from "./shapes.js";

const SVG = "http://www.w3.org/2000/svg";

function path(d, style) {
  const made = document.createElementNS(SVG, "path");
  made.setAttribute("d", d);
  Object.assign(made.style, style);
  return made;
}

function sampleOf({ mark, style }) {
  const ink = `var(${seriesColour(style)})`;
  if (mark === "bars") return path("M4 3h14v10h-14z", { fill: ink, fillOpacity: 0.3, stroke: ink });
  if (mark === "dots") {
    const stroked = { stroke: ink, strokeWidth: 1.5, fill: "none" };
    return path(shapePath(style, 11, 8, 4), isOutline(style) ? stroked : { fill: ink });
  }
  return path("M0 8h22", { stroke: ink, strokeWidth: 2, strokeDasharray: dashOf(style).join(" ") });
}

// Names of the series with what marks them; nothing where none has a name.
export function legendOf(series) {
  const list = element("ul", { class: "legend" });
  for (const each of series) {
    if (!each.name) continue;
    const svg = document.createElementNS(SVG, "svg");
    svg.setAttribute("viewBox", "0 0 22 16");
    svg.setAttribute("aria-hidden", "true");
    svg.append(sampleOf(each));
    list.append(element("li", {}, svg, each.name));
  }
  return list;
}
