// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
// What stands around the arm: ground with a grid of a round size, axes with letters, artefacts.
import { ArrowHelper, CanvasTexture, ConeGeometry, GridHelper, Group, Mesh, Sprite, SpriteMaterial, Vector3 } from "three";
import { ball, stretch, tube } from "./scene_arm.js";

const AXES = [["x", [1, 0, 0]], ["y", [0, 1, 0]], ["z", [0, 0, 1]]];

// 1, 2 or 5 times a power of ten, at most `length`.
export function roundLength(length) {
  const power = 10 ** Math.floor(Math.log10(length));
  return ([5, 2].find((factor) => factor * power <= length) ?? 1) * power;
}

export function letter(text, ink, size) {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 64;
  const context = canvas.getContext("2d");
  context.font = "600 44px sans-serif";
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.fillStyle = ink;
  context.fillText(text, 32, 32);
  const sprite = new Sprite(new SpriteMaterial({ map: new CanvasTexture(canvas), depthTest: false }));
  sprite.scale.setScalar(size);
  return sprite;
}

export function axesOf(size, ink) {
  const group = new Group();
  for (const [name, direction] of AXES) {
    const way = new Vector3(...direction);
    group.add(new ArrowHelper(way, new Vector3(), size, ink, 0.12 * size, 0.06 * size));
    const sprite = letter(name, ink, 0.28 * size);
    sprite.position.copy(way).multiplyScalar(1.15 * size);
    group.add(sprite);
  }
  return group;
}

export function groundOf(reach, spacing, ink) {
  const cells = 2 * Math.ceil(reach / spacing);
  const grid = new GridHelper(cells * spacing, cells, ink, ink);
  grid.rotation.x = Math.PI / 2;
  return grid;
}

function artefactOf({ kind, at_mm, to_mm, radius_mm }, size, material) {
  const at = new Vector3(...at_mm);
  if (kind === "sphere") {
    const mesh = ball(material, Math.max(radius_mm ?? 0, size));
    mesh.position.copy(at);
    return [mesh];
  }
  if (kind === "bar") {
    const rod = tube(material);
    const to = new Vector3(...to_mm);
    stretch(rod, at, to, 0.5 * size);
    return [rod, ...[at, to].map((end) => Object.assign(ball(material, size), {}).translateX(end.x).translateY(end.y).translateZ(end.z))];
  }
  // A point: a cone whose tip is there.
  const cone = new Mesh(new ConeGeometry(size, 2 * size, 16), material);
  cone.rotation.x = Math.PI / 2;
  cone.position.copy(at).setZ(at.z - size);
  return [cone];
}

export function artefactsOf(artefacts, size, material) {
  const group = new Group();
  for (const artefact of artefacts) group.add(...artefactOf(artefact, size, material));
  return group;
}
