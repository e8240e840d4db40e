// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
// A chart to hover over and to zoom, by uPlot, from the same numbers as its drawing.
import uPlot from "uplot";
import { legendOf } from "./chart_legend.js";
import { drawLines, drawSeries } from "./chart_marks.js";
import { drawTags } from "./chart_tags.js";
import { describe, nearest, neighbour, pointsOf, tipOf } from "./chart_points.js";
import { element } from "./element.js";
import { livePlace } from "./figure.js";
import { fixedText, logTicks, powerTexts } from "./number_text.js";
import { equalRanges, fullRanges, zoomed } from "./ranges.js";
import { colour, onThemeChange } from "./theme.js";
import { say } from "./words.js";

const HEIGHT = 300;
const WIDE_HEIGHT = 340;
const WHOLE_STEPS = [1, 2, 5].flatMap((step) => [1, 10, 100, 1000, 10000].map((power) => step * power)).sort((a, b) => a - b); // of what is counted
const EQUAL_HEIGHTS = [260, 560];

export function liveChart(figure, model) {
  return new LiveChart(figure, model).api();
}

class LiveChart {
  constructor(figure, model) {
    this.figure = figure;
    this.model = model;
    this.points = pointsOf(model);
    this.full = fullRanges(model);
    this.ranges = this.full;
    this.family = getComputedStyle(document.body).fontFamily;
    const { place, show } = livePlace(figure);
    this.place = place;
    show();
    this.build();
    this.listen();
  }

  api() {
    return {
      id: this.figure.id,
      element: this.place,
      ranges: () => this.ranges,
      points: () => this.points.length,
      reset: () => this.reset(),
    };
  }

  build() {
    const title = this.figure.querySelector("figcaption h3").textContent;
    this.plot = element("div", { class: "plot", tabindex: 0, role: "application", "aria-label": title, "aria-roledescription": say("chart"), "aria-description": say("chart_keys") });
    this.tip = element("div", { class: "tip", hidden: true });
    this.ring = element("div", { class: "ring", hidden: true });
    this.spoken = element("div", { class: "spoken", "aria-live": "polite" });
    this.button = element("button", { type: "button", class: "reset", hidden: true }, say("reset_view"));
    this.place.append(
      element("div", { class: "above" }, element("span", { class: "y-label" }, this.model.y.label), legendOf(this.model.series), this.button),
      this.plot,
      this.spoken,
    );
    this.u = new uPlot(this.options(), [null, ...this.model.series.map(({ x, y }) => [x, y])], this.plot);
    this.u.over.append(this.ring, this.tip);
  }

  options() {
    const { model } = this;
    const axis = (key, more) => ({
      scale: key,
      stroke: () => colour("--muted"),
      font: this.font(12),
      grid: { stroke: () => colour("--grid"), width: 1 },
      ticks: { stroke: () => colour("--edge"), width: 1, size: 4 },
      gap: 5,
      ...(model.series.every((series) => series[key].every(Number.isInteger)) ? { incrs: WHOLE_STEPS } : {}),
      ...(model[key].scale === "log" ? { splits: (u, i, low, high) => logTicks(low, high) } : {}),
      values: (u, splits, i, space, step) => (model[key].scale === "log" ? powerTexts(splits) : tickTexts(splits, step)),
      ...(model[key].scale === "log" ? { filter: (u, splits) => splits } : {}),
      ...more,
    });
    const scale = (key) => ({ time: false, distr: model[key].scale === "log" ? 3 : 1, range: () => this.ranges[key] });
    return {
      mode: 2,
      ...this.size(),
      padding: [8, 14, 0, 0],
      legend: { show: false },
      scales: { x: scale("x"), y: scale("y") },
      axes: [
        axis("x", { label: model.x.label, labelFont: this.font(13), labelSize: 22, labelGap: 2, size: 26, space: 64 }),
        axis("y", { size: (u, values) => this.widthOf(values), space: 36 }),
      ],
      series: [
        null,
        ...model.series.map((series) => ({
          facets: [{ scale: "x", auto: true }, { scale: "y", auto: true }],
          paths: (u) => {
            drawSeries(u, series);
            return null;
          },
        })),
      ],
      cursor: { points: { show: false }, drag: { x: true, y: true, uni: 24, setScale: false }, bind: { dblclick: () => () => this.reset() }, dataIdx: () => null },
      hooks: { ready: [() => this.reset()], draw: [(u) => drawLines(u, model.lines, (size) => this.font(size)), (u) => drawTags(u, model.series, (size) => this.font(size))], setSelect: [(u) => this.zoomTo(u.select)] },
    };
  }

  font(size) {
    return `${size}px ${this.family}`;
  }

  widthOf(values) {
    const longest = Math.max(0, ...(values ?? []).map((text) => (text ?? "").length));
    return Math.ceil(longest * 7.2 + 12);
  }

  size() {
    const width = Math.max(200, Math.floor(this.place.clientWidth));
    if (!this.model.equal) return { width, height: this.figure.classList.contains("wide") ? WIDE_HEIGHT : HEIGHT };
    const { x, y } = this.full;
    const wanted = ((width - 60) * (y[1] - y[0])) / (x[1] - x[0]) + 60;
    return { width, height: Math.round(Math.min(Math.max(wanted, EQUAL_HEIGHTS[0]), EQUAL_HEIGHTS[1])) };
  }

  // Shows `ranges`, grown where a millimetre shall be as long either way.
  show(ranges) {
    const { over } = this.u;
    this.ranges = this.model.equal ? equalRanges(ranges, over.clientWidth, over.clientHeight) : ranges;
    this.u.batch(() => {
      for (const key of ["x", "y"]) this.u.setScale(key, { min: this.ranges[key][0], max: this.ranges[key][1] });
    });
    this.button.hidden = ranges === this.full;
    this.point(null);
  }

  reset() {
    this.show(this.full);
  }

  zoomTo({ left, top, width, height }) {
    if (width < 4 && height < 4) return;
    const { u } = this;
    const all = { width: u.over.clientWidth, height: u.over.clientHeight };
    const [x, y] = [width < 4 ? [0, all.width] : [left, left + width], height < 4 ? [0, all.height] : [top, top + height]];
    u.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
    this.show({ x: x.map((p) => u.posToVal(p, "x")), y: y.map((p) => u.posToVal(p, "y")).reverse() });
  }

  // Rings a point and says what it is.
  point(point) {
    this.current = point;
    this.ring.hidden = this.tip.hidden = !point;
    if (!point) return;
    const { u } = this;
    const [left, top] = [u.valToPos(point.x, "x"), u.valToPos(point.y, "y")];
    this.ring.style.transform = `translate(${left}px, ${top}px)`;
    this.tip.replaceChildren(...tipOf(describe(this.model, point)));
    const { clientWidth, clientHeight } = u.over;
    const x = left + 14 + this.tip.offsetWidth > clientWidth ? Math.max(0, left - 14 - this.tip.offsetWidth) : left + 14;
    const y = Math.min(Math.max(0, top - this.tip.offsetHeight / 2), Math.max(0, clientHeight - this.tip.offsetHeight));
    this.tip.style.transform = `translate(${x}px, ${y}px)`;
  }

  listen() {
    const { u } = this;
    const hover = (event) => {
      const box = u.over.getBoundingClientRect();
      this.point(nearest(u, this.model, this.points, event.clientX - box.left, event.clientY - box.top));
    };
    u.over.addEventListener("pointermove", hover);
    u.over.addEventListener("pointerdown", hover);
    u.over.addEventListener("pointerleave", () => this.point(null));
    this.button.addEventListener("click", () => this.reset());
    this.plot.addEventListener("keydown", (event) => this.onKey(event));
    this.plot.addEventListener("blur", () => this.point(null));
    onThemeChange(() => u.redraw(false, true));
    new ResizeObserver(() => {
      const size = this.size();
      if (size.width === u.width) return;
      u.setSize(size);
      this.show(this.model.equal ? this.full : this.button.hidden ? this.full : this.ranges);
    }).observe(this.place);
  }

  onKey(event) {
    const steps = { ArrowRight: [1, 0], ArrowLeft: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
    const factors = { "+": 0.7, "-": 1 / 0.7 };
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (steps[event.key]) {
      this.point(neighbour(this.points, this.current, ...steps[event.key]));
      if (this.current) this.spoken.textContent = describe(this.model, this.current).map(([, name, value]) => `${name} ${value}`).join(", ");
    } else if (factors[event.key]) {
      const { x, y } = this.ranges;
      this.show({ x: zoomed(x, factors[event.key], this.model.x.scale === "log"), y: zoomed(y, factors[event.key], this.model.y.scale === "log") });
    } else if (event.key === "Escape") {
      this.reset();
    } else {
      return;
    }
    event.preventDefault();
  }
}

// With as many decimals as the step needs.
function tickTexts(ticks, step) {
  let decimals = 0;
  while (decimals < 12 && Math.abs(step * 10 ** decimals - Math.round(step * 10 ** decimals)) > 1e-6) ++decimals;
  return ticks.map((tick) => fixedText(tick, decimals));
}
