// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
// Forward kinematics of docs/theory/kinematics.md: per joint RotZ(theta) TransZ(d) TransY(b) TransX(a) RotX(alpha)
// RotY(beta), after the last joint the tip. 4 x 4 matrices are 16 numbers, row after row; mm and rad.
const RAD = Math.PI / 180;

export function multiply(A, B) {
  const C = new Array(16);
  for (let r = 0; r < 4; ++r) {
    for (let c = 0; c < 4; ++c) {
      let sum = 0;
      for (let k = 0; k < 4; ++k) sum += A[4 * r + k] * B[4 * k + c];
      C[4 * r + c] = sum;
    }
  }
  return C;
}

export function transform(A, [x, y, z]) {
  return [0, 4, 8].map((r) => A[r] * x + A[r + 1] * y + A[r + 2] * z + A[r + 3]);
}

export const translation = (x, y, z) => [1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z, 0, 0, 0, 1];

export function rotationX(angle) {
  const c = Math.cos(angle);
  const s = Math.sin(angle);
  return [1, 0, 0, 0, 0, c, -s, 0, 0, s, c, 0, 0, 0, 0, 1];
}

export function rotationY(angle) {
  const c = Math.cos(angle);
  const s = Math.sin(angle);
  return [c, 0, s, 0, 0, 1, 0, 0, -s, 0, c, 0, 0, 0, 0, 1];
}

export function rotationZ(angle) {
  const c = Math.cos(angle);
  const s = Math.sin(angle);
  return [c, -s, 0, 0, s, c, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
}

// What the joint turns by when its encoder reads so many degrees.
export function jointAngle(joint, encoderDeg) {
  const encoder = encoderDeg * RAD;
  let angle = joint.direction * (encoder + joint.zero_deg * RAD);
  joint.harmonics.forEach(([cosine, sine], k) => {
    angle += cosine * Math.cos((k + 1) * encoder) + sine * Math.sin((k + 1) * encoder);
  });
  return angle;
}

// Where everything is: for each joint the frame before it turns, and the corners of the way from its origin along d,
// b and a; and the tip. In the base.
export function postureOf(arm, encodersDeg) {
  let base_from_here = arm.base_from_first_joint;
  const joints = arm.joints.map((joint, i) => {
    const frame = base_from_here;
    const base_from_turned = multiply(frame, rotationZ(jointAngle(joint, encodersDeg[i])));
    const link = arm.links[i] ?? { ...arm.tip, alpha_deg: 0, beta_deg: 0 };
    const { a_mm: a, b_mm: b, d_mm: d } = link;
    const corners = [[0, 0, 0], [0, 0, d], [0, b, d], [a, b, d]].map((p) => transform(base_from_turned, p));
    const bend = multiply(rotationX(link.alpha_deg * RAD), rotationY(link.beta_deg * RAD));
    base_from_here = multiply(multiply(base_from_turned, translation(a, b, d)), bend);
    return { frame, corners };
  });
  return { joints, tip_mm: joints.at(-1).corners[3], base_from_tip: base_from_here };
}
