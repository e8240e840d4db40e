// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
// A half turn of one joint: the arm where it ends as a ghost, and the way from tip to tip.
import { Group, Vector3 } from "three";
import { postureOf } from "./kinematics.js";
import { ArmBody, stretch, tube } from "./scene_arm.js";
import { letter } from "./scene_world.js";

const STOPS = [0.25, 0.5, 0.75, 1]; // of the way

// Readings of the arm a part of the way from the first posture to the second.
export function readingsAlong([from, to], part) {
  return from.q_deg.map((deg, i) => deg + part * (to.q_deg[i] - deg));
}

// Where the arm gets to on its way.
export function placesOnTheWay({ arm, postures }) {
  return STOPS.flatMap((part) => postureOf(arm, readingsAlong(postures, part)).joints.flatMap(({ corners }) => corners));
}

export class HalfTurn {
  constructor({ arm, postures, turning_joint }, size, materials) {
    this.size = size;
    this.postures = postures;
    const { ghost, fit } = materials;
    const body = new ArmBody(arm.joints.length, size, { joint: ghost, link: ghost, tip: ghost, turning: ghost }, turning_joint);
    body.take(postureOf(arm, postures[1].q_deg));
    const way = tube(fit);
    stretch(way, ...postures.map(({ tip_mm }) => new Vector3(...tip_mm)), size * 0.002);
    this.group = new Group();
    this.group.add(body.group, way);
  }

  enlarge() {} // there are no residuals

  // Letters beside the tips.
  names(ink) {
    const group = new Group();
    for (const { name, tip_mm } of this.postures) {
      const sprite = letter(name, ink, this.size * 0.06);
      sprite.position.set(...tip_mm).add(new Vector3(0, 0, this.size * 0.04));
      group.add(sprite);
    }
    return group;
  }
}
