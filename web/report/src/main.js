// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
// What scripts add to a report. Without them it is complete: drawings stand where these make charts and scenes.
import { liveChart } from "./charts.js";
import { followContents } from "./contents.js";
import { enliven } from "./figure.js";
import { liveScene } from "./scene.js";
import { setUpTools } from "./theme.js";
import style from "./live.css";
import chartStyle from "uplot/dist/uPlot.min.css";

const report = { charts: [], scenes: [] };
window.armcalReport = report;

document.head.append(Object.assign(document.createElement("style"), { textContent: chartStyle + style }));
setUpTools();
followContents();
enliven({
  chart: (figure, model) => report.charts.push(liveChart(figure, model)),
  scene: (figure, model) => report.scenes.push(liveScene(figure, model)),
});
