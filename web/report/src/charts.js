// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
// A chart to hover over and to zoom, by uPlot, from the same numbers as its drawing.
import uPlot from "uplot";
import { legendOf } from "./chart_legend.js";
import { drawLabels } from "./chart_labels.js";
import { drawLines, drawSeries } from "./chart_marks.js";
import { drawTags } from "./chart_tags.js";
import { describe, nearest, neighbour, pointsOf, tipOf } from "./chart_points.js";
import { element } from "./element.js";
import { livePlace } from "./figure.js";
import { equalRanges, fullRanges, withValue, zoomed } from "./ranges.js";
import { colour, onThemeChange } from "./theme.js";
import { ticksOf } from "./ticks.js";
import { say } from "./words.js";

const HEIGHT = 300;
const WIDE_HEIGHT = 340;
const PER_TICK = { x: 64, y: 36 }; // pixels
const AROUND = 60; // what axes take of a chart's width or height, about
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
      splits: (u) => this.ticks(u, key).map(({ value }) => value),
      values: (u) => this.ticks(u, key).map(({ text }) => text),
      filter: (u, splits) => splits,
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
        axis("x", { label: model.x.label, labelFont: this.font(13), labelSize: 22, labelGap: 2, size: 26 }),
        axis("y", { size: (u, values) => this.widthOf(values) }),
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
      hooks: { ready: [() => this.reset()], draw: [(u) => this.drawWords(u)], setSelect: [(u) => this.zoomTo(u.select)] },
    };
  }

  font(size) {
    return `${size}px ${this.family}`;
  }

  drawWords(u) {
    const font = (size) => this.font(size);
    drawLines(u, this.model.lines);
    drawLabels(u, this.model, font);
    drawTags(u, this.model.series, font);
  }

  ticks(u, key) {
    const { model } = this;
    const length = (key === "x" ? u.width : u.height) - AROUND; // of the plot, which has its old size yet when it is resized
    const isCounted = model.series.every((series) => series[key].every(Number.isInteger));
    return ticksOf(model[key].scale, ...this.ranges[key], Math.max(2, Math.floor(length / PER_TICK[key])), isCounted ? 1 : 0);
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

  // Moves the view so that a point is in it.
  bringIntoView({ x, y }) {
    const moved = { ...this.ranges };
    for (const [key, value] of [["x", x], ["y", y]]) moved[key] = withValue(moved[key], value, this.model[key].scale === "log");
    if (moved.x !== this.ranges.x || moved.y !== this.ranges.y) this.show(moved);
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
      if (this.place.clientWidth === 0 || size.width === u.width) return; // on paper
      u.setSize(size);
      // Once uPlot has laid out the new size: until then equal scales would be those of the old.
      queueMicrotask(() => this.show(this.button.hidden ? this.full : this.ranges));
    }).observe(this.place);
  }

  onKey(event) {
    const steps = { ArrowRight: [1, 0], ArrowLeft: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
    const factors = { "+": 0.7, "-": 1 / 0.7 };
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (steps[event.key]) {
      const next = neighbour(this.points, this.current, ...steps[event.key]);
      if (next) this.bringIntoView(next);
      this.point(next);
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
