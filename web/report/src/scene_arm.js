// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
// The arm in space: a housing about each joint's axis, tubes along its links, a ball at the tip.
import { CylinderGeometry, Group, Mesh, SphereGeometry, Vector3 } from "three";

const UP = new Vector3(0, 1, 0); // axis of three's cylinders
const TUBE = new CylinderGeometry(1, 1, 1, 20);
const BALL = new SphereGeometry(1, 24, 16);

// Puts a cylinder of unit length and radius between two places; hides it where they are one.
export function stretch(mesh, from, to, radius) {
  const way = new Vector3().subVectors(to, from);
  const length = way.length();
  mesh.visible = length > 1e-6;
  if (!mesh.visible) return;
  mesh.position.addVectors(from, to).multiplyScalar(0.5);
  mesh.quaternion.setFromUnitVectors(UP, way.divideScalar(length));
  mesh.scale.set(radius, length, radius);
}

export function tube(material) {
  return new Mesh(TUBE, material);
}

export function ball(material, radius) {
  const mesh = new Mesh(BALL, material);
  mesh.scale.setScalar(radius);
  return mesh;
}

export class ArmBody {
  // @param size  a length to which the arm's thickness is in proportion, mm
  // @param turning  a joint with a colour of its own, or none
  constructor(count, size, materials, turning = null) {
    this.group = new Group();
    this.thickness = (i) => size * 0.016 * (1 - (0.5 * i) / count);
    this.joints = [];
    for (let i = 0; i < count; ++i) {
      const joint = {
        housing: tube(i === turning ? materials.turning : materials.joint),
        tubes: [0, 1, 2].map(() => tube(materials.link)),
        elbows: [0, 1].map(() => ball(materials.link, this.thickness(i))),
      };
      this.group.add(joint.housing, ...joint.tubes, ...joint.elbows);
      this.joints.push(joint);
    }
    this.foot = tube(materials.joint);
    this.tip = ball(materials.tip, size * 0.012);
    this.group.add(this.foot, this.tip);
  }

  // @param posture  of postureOf()
  take(posture) {
    posture.joints.forEach(({ frame, corners }, i) => {
      const { housing, tubes, elbows } = this.joints[i];
      const radius = this.thickness(i);
      const points = corners.map((corner) => new Vector3(...corner));
      const axis = new Vector3(frame[2], frame[6], frame[10]).multiplyScalar(1.9 * radius);
      stretch(housing, points[0].clone().sub(axis), points[0].clone().add(axis), 1.7 * radius);
      tubes.forEach((mesh, k) => stretch(mesh, points[k], points[k + 1], radius));
      elbows.forEach((mesh, k) => {
        mesh.position.copy(points[k + 1]);
      });
    });
    const [x, y, z] = posture.joints[0].corners[0];
    stretch(this.foot, new Vector3(x, y, 0), new Vector3(x, y, z), 1.3 * this.thickness(0));
    this.tip.position.set(...posture.tip_mm);
  }
}
