// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
// Where the arm measured: a mark at each tip and an arrow along its residual. Rows that were fitted are balls, rows held
// out for checking are octahedra, so that colour is not the only difference.
import { ConeGeometry, CylinderGeometry, Group, InstancedMesh, Matrix4, OctahedronGeometry, Quaternion, SphereGeometry, Vector3 } from "three";

const UP = new Vector3(0, 1, 0);
const NOTHING = new Matrix4().makeScale(0, 0, 0);

class Kind {
  constructor(postures, geometry, material, size) {
    this.postures = postures;
    this.size = size;
    this.marks = new InstancedMesh(geometry, material, postures.length);
    this.shafts = new InstancedMesh(new CylinderGeometry(1, 1, 1, 8), material, postures.length);
    this.heads = new InstancedMesh(new ConeGeometry(1, 1, 12), material, postures.length);
    for (const mesh of [this.marks, this.shafts, this.heads]) mesh.frustumCulled = false;
    postures.forEach(({ tip_mm }, i) => {
      const scale = new Vector3().setScalar(size);
      this.marks.setMatrixAt(i, new Matrix4().compose(new Vector3(...tip_mm), new Quaternion(), scale));
    });
  }

  enlarge(factor) {
    this.postures.forEach(({ tip_mm, residual_mm }, i) => {
      const way = new Vector3(...(residual_mm ?? [0, 0, 0])).multiplyScalar(factor);
      const length = way.length();
      const head = Math.min(2.6 * this.size, 0.6 * length);
      if (!(length > 1e-9)) {
        this.shafts.setMatrixAt(i, NOTHING);
        this.heads.setMatrixAt(i, NOTHING);
        return;
      }
      const along = way.divideScalar(length);
      const turn = new Quaternion().setFromUnitVectors(UP, along);
      const tip = new Vector3(...tip_mm);
      const place = (distance) => tip.clone().addScaledVector(along, distance);
      const thick = 0.3 * this.size;
      this.shafts.setMatrixAt(i, new Matrix4().compose(place((length - head) / 2), turn, new Vector3(thick, length - head, thick)));
      this.heads.setMatrixAt(i, new Matrix4().compose(place(length - head / 2), turn, new Vector3(0.4 * head, head, 0.4 * head)));
    });
    this.shafts.instanceMatrix.needsUpdate = this.heads.instanceMatrix.needsUpdate = true;
  }
}

export class Measured {
  // @param size  of the marks, mm
  constructor(postures, size, materials) {
    this.group = new Group();
    const parts = [
      [postures.filter((posture) => !posture.check), new SphereGeometry(1, 12, 8), materials.fit, size],
      [postures.filter((posture) => posture.check), new OctahedronGeometry(1.5), materials.check, size],
    ];
    this.kinds = parts.filter(([some]) => some.length > 0).map((part) => new Kind(...part));
    for (const kind of this.kinds) this.group.add(kind.marks, kind.shafts, kind.heads);
  }

  names() {
    return new Group(); // too many to be written
  }

  enlarge(factor) {
    for (const kind of this.kinds) kind.enlarge(factor);
  }
}
