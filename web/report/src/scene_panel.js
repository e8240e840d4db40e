// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
// The controls of a scene: a slider per joint, one for the measured postures, one for the size of residuals.
import { element } from "./element.js";
import { fixedText } from "./number_text.js";
import { say } from "./words.js";

let controls = 0;

function slider({ label, low, high, step, text, change }) {
  const id = `armcal-control-${++controls}`;
  const input = element("input", { type: "range", id, min: low, max: high, step });
  const output = element("output", { for: id });
  const say = (words) => {
    output.textContent = words;
    input.setAttribute("aria-valuetext", words);
  };
  const set = (value) => {
    input.value = value;
    say(text(value));
  };
  input.addEventListener("input", () => {
    say(text(Number(input.value)));
    change(Number(input.value));
  });
  return { row: element("div", { class: "control" }, element("label", { for: id }, label), output, input), set, say };
}

// Encoder readings that a joint is offered: its limits, else a whole turn, and every reading that was taken.
function rangeOf(joint, readings) {
  const low = Math.min(joint.min_deg ?? -180, ...readings);
  const high = Math.max(joint.max_deg ?? 180, ...readings);
  return [Math.floor(low), Math.ceil(high)];
}

// @param isRoomy  joints are shown at once, not only when asked for
export function panelOf(model, isRoomy, actions) {
  const joints = model.arm.joints.map((joint, i) => {
    const [low, high] = rangeOf(joint, model.postures.map((posture) => posture.q_deg[i]));
    return slider({
      label: `${say("joint")} ${i + 1}`,
      low,
      high,
      step: "any",
      text: (value) => `${fixedText(value, 1)}°`,
      change: (value) => actions.turn(i, value),
    });
  });
  const rows = [];
  let posture = null;
  if (model.turning_joint != null) {
    const [from, to] = model.postures.map(({ q_deg }) => q_deg[model.turning_joint]);
    posture = slider({
      label: say("way"),
      low: 0,
      high: 1,
      step: "any",
      text: (part) => `${say("joint")} ${model.turning_joint + 1}: ${fixedText(from + part * (to - from), 0)}°`,
      change: actions.goAlong,
    });
    rows.push(posture.row);
  } else if (model.postures.length > 0) {
    posture = slider({
      label: say("posture"),
      low: 0,
      high: model.postures.length - 1,
      step: 1,
      text: (index) => model.postures[index].name,
      change: actions.choose,
    });
    rows.push(posture.row);
  }
  if (model.postures.some((each) => each.residual_mm)) {
    const around = Math.log10(model.enlargement || 1);
    const enlargement = slider({
      label: say("scale_residuals"),
      low: around - 1.5,
      high: around + 1.5,
      step: "any",
      text: (power) => `× ${roundFactor(10 ** power)}`,
      change: (power) => actions.enlarge(roundFactor(10 ** power)),
    });
    enlargement.set(around);
    rows.push(enlargement.row);
  }
  const folder = element("details", { open: isRoomy }, element("summary", {}, say("joints")), ...joints.map((joint) => joint.row));
  return {
    element: element("div", { class: "panel" }, ...rows, folder),
    // @param chosen  index of the measured posture, or part of the way; null: none
    show(q_deg, chosen) {
      joints.forEach((joint, i) => joint.set(q_deg[i]));
      if (chosen === null) posture?.say(say("none"));
      else posture?.set(chosen);
    },
  };
}

function roundFactor(factor) {
  return Number(factor.toPrecision(2));
}
