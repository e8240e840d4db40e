// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
// The controls of a scene: a slider per joint, one for the measured postures, one for the size of residuals.
import { element } from "./element.js";
import { fixedText } from "./number_text.js";
import { say } from "./words.js";

let controls = 0;

function slider({ label, low, high, step, value, text, change }) {
  const id = `armcal-control-${++controls}`;
  const input = element("input", { type: "range", id, min: low, max: high, step });
  const output = element("output", { for: id });
  const show = () => {
    output.textContent = text(Number(input.value));
    input.setAttribute("aria-valuetext", output.textContent);
  };
  input.value = value;
  show();
  input.addEventListener("input", () => {
    show();
    change(Number(input.value));
  });
  const set = (next) => {
    input.value = next;
    show();
  };
  return { row: element("div", { class: "control" }, element("label", { for: id }, label), output, input), set };
}

// Encoder readings that a joint is offered: its limits, else a whole turn, and every reading that was taken.
function rangeOf(joint, readings) {
  const low = Math.min(joint.min_deg ?? -180, ...readings);
  const high = Math.max(joint.max_deg ?? 180, ...readings);
  return [Math.floor(low), Math.ceil(high)];
}

export function panelOf(model, q_deg, actions) {
  const joints = model.arm.joints.map((joint, i) => {
    const [low, high] = rangeOf(joint, model.postures.map((posture) => posture.q_deg[i]));
    return slider({
      label: `${say("joint")} ${i + 1}`,
      low,
      high,
      step: "any",
      value: q_deg[i],
      text: (value) => `${fixedText(value, 1)}°`,
      change: (value) => actions.turn(i, value),
    });
  });
  const rows = [];
  let posture = null;
  if (model.postures.length > 0) {
    posture = slider({
      label: say("posture"),
      low: 0,
      high: model.postures.length,
      step: 1,
      value: 0,
      text: (value) => (value === 0 ? say("none") : model.postures[value - 1].name),
      change: (value) => actions.choose(value - 1),
    });
    rows.push(posture.row);
  }
  if (model.postures.some((each) => each.residual_mm)) {
    const around = Math.log10(model.enlargement || 1);
    rows.push(
      slider({
        label: say("scale_residuals"),
        low: around - 1.5,
        high: around + 1.5,
        step: 0.01,
        value: around,
        text: (value) => `× ${roundFactor(10 ** value)}`,
        change: (value) => actions.enlarge(roundFactor(10 ** value)),
      }).row,
    );
  }
  const legend = element("fieldset", {}, element("legend", {}, say("joints")), ...joints.map((joint) => joint.row));
  return {
    element: element("div", { class: "panel" }, ...rows, legend),
    showJoints: (next) => joints.forEach((joint, i) => joint.set(next[i])),
    showPosture: (index) => posture?.set(index + 1),
  };
}

function roundFactor(factor) {
  return Number(factor.toPrecision(2));
}
