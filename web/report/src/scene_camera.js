// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
// From where a scene is seen.
import { PerspectiveCamera, Vector3 } from "three";

const VIEW_DEG = 35; // from top to bottom
const FILLED = 0.85; // part of the view that everything takes at first
const FILLED_BY_TURN = 0.75; // of a half turn, whose letters and thickness reach further out
const FROM = new Vector3(0.55, -0.75, 0.42).normalize();
const TURNS = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] }; // around, over; rad
const FACTORS = { "+": 0.85, "-": 1 / 0.85 };
const STEEPEST = 0.05; // rad between camera and the vertical

// @param size  of the scene, mm
export function cameraFor(size) {
  const camera = new PerspectiveCamera(VIEW_DEG, 1, size / 100, size * 20);
  camera.up.set(0, 0, 1);
  return camera;
}

// Goes where all places are just in view about the middle.
export function lookAt(camera, middle, places, aspect, isTurn = false) {
  const right = new Vector3().crossVectors(camera.up, FROM).normalize();
  const up = new Vector3().crossVectors(FROM, right);
  const rise = (isTurn ? FILLED_BY_TURN : FILLED) * Math.tan((VIEW_DEG * Math.PI) / 360);
  const run = rise * aspect;
  const distance = places.reduce((least, place) => {
    const from = new Vector3(...place).sub(middle);
    return Math.max(least, from.dot(FROM) + Math.max(Math.abs(from.dot(right)) / run, Math.abs(from.dot(up)) / rise));
  }, 1);
  camera.position.copy(middle).addScaledVector(FROM, distance);
}

// Turns about the target or goes nearer; false where the key means nothing here.
export function moveByKey(camera, target, key) {
  const way = new Vector3().subVectors(camera.position, target);
  if (TURNS[key]) {
    const [around, over] = TURNS[key];
    const side = new Vector3().crossVectors(camera.up, way).normalize();
    const tilted = way.clone().applyAxisAngle(side, over);
    const slope = tilted.angleTo(camera.up);
    if (slope > STEEPEST && slope < Math.PI - STEEPEST) way.copy(tilted);
    way.applyAxisAngle(camera.up, around);
  } else if (FACTORS[key]) {
    way.multiplyScalar(FACTORS[key]);
  } else {
    return false;
  }
  camera.position.addVectors(target, way);
  return true;
}
