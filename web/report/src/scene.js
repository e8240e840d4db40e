// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
// The arm in space, to be turned by its joints: built from the model alone, drawn only when something has changed.
import { AmbientLight, Color, DirectionalLight, HemisphereLight, MeshStandardMaterial, Scene, Vector2, Vector3, WebGLRenderer } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { element } from "./element.js";
import { livePlace } from "./figure.js";
import { postureOf } from "./kinematics.js";
import { fixedText, numberText } from "./number_text.js";
import { ArmBody } from "./scene_arm.js";
import { cameraFor, lookAt, moveByKey } from "./scene_camera.js";
import { panelOf } from "./scene_panel.js";
import { Measured } from "./scene_postures.js";
import { HalfTurn, placesOnTheWay, readingsAlong } from "./scene_turn.js";
import { artefactsOf, axesOf, groundOf, roundLength } from "./scene_world.js";
import { colour, onThemeChange } from "./theme.js";
import { say } from "./words.js";

const INKS = { joint: "--scene-joint", link: "--scene-link", tip: "--ink", fit: "--series-0", check: "--series-1", turning: "--series-1", artefact: "--series-2", ghost: "--scene-joint" };

// One renderer for all scenes of a page: browsers allow few. Null where there are no 3-D graphics.
let renderer;
function sharedRenderer() {
  if (renderer === undefined) {
    const canvas = document.createElement("canvas");
    const hasGraphics = Boolean(canvas.getContext("webgl2", { antialias: true, alpha: true }));
    renderer = hasGraphics ? new WebGLRenderer({ canvas, antialias: true, alpha: true }) : null;
  }
  return renderer;
}

// Frees what the graphics hold of an object and all in it.
function dispose(object) {
  object.traverse(({ geometry, material }) => {
    geometry?.dispose();
    material?.map?.dispose();
    material?.dispose();
  });
}

export function liveScene(figure, model) {
  if (!sharedRenderer()) {
    figure.append(element("p", { class: "note" }, say("no_webgl")));
    return { id: figure.id, missing: true };
  }
  return new LiveScene(figure, model).api();
}

class LiveScene {
  constructor(figure, model) {
    this.figure = figure;
    this.model = model;
    this.frames = 0; // drawn so far
    this.isTurn = model.turning_joint != null;
    this.chosen = this.isTurn ? 0 : Math.floor(model.postures.length / 2); // of the measured postures; null: turned by hand
    this.q_deg = this.first();
    this.measure();
    this.furnish();
    this.layOut();
    this.listen();
    this.paint();
    this.reset();
  }

  api() {
    return {
      id: this.figure.id,
      element: this.place,
      tip: () => [...this.posture.tip_mm],
      tipOf: (q_deg) => postureOf(this.model.arm, q_deg).tip_mm,
      joints: () => [...this.q_deg],
      setJoint: (i, deg) => this.turn(i, deg),
      setPosture: (index) => this.choose(index),
      postures: this.model.postures,
      frames: () => this.frames,
      reach: () => this.reach(),
    };
  }

  // The readings that it begins with: of the middle one of the measured postures, else zeros within limits.
  first() {
    const { postures, arm } = this.model;
    if (postures.length > 0) return [...postures[this.chosen].q_deg];
    this.chosen = null;
    return arm.joints.map(({ min_deg, max_deg }) => Math.min(Math.max(0, min_deg ?? 0), max_deg ?? 0));
  }

  // How large everything is, and where its middle lies.
  measure() {
    this.posture = postureOf(this.model.arm, this.q_deg);
    const places = (this.places = [
      [0, 0, 0],
      ...this.posture.joints.flatMap(({ corners }) => corners),
      ...(this.isTurn ? placesOnTheWay(this.model) : []),
      ...this.model.postures.map(({ tip_mm }) => tip_mm),
      ...this.model.artefacts.flatMap(({ kind, at_mm, to_mm }) => (kind === "bar" ? [at_mm, to_mm] : [at_mm])),
    ]);
    const low = [0, 1, 2].map((k) => places.reduce((least, p) => Math.min(least, p[k]), Infinity));
    const high = [0, 1, 2].map((k) => places.reduce((most, p) => Math.max(most, p[k]), -Infinity));
    this.middle = new Vector3(...low.map((v, k) => (v + high[k]) / 2));
    this.size = Math.max(1, Math.hypot(...low.map((v, k) => high[k] - v)));
    this.around = Math.max(Math.abs(low[0]), Math.abs(low[1]), high[0], high[1]);
    this.spacing = roundLength(this.size / 8);
  }

  furnish() {
    const { model, size } = this;
    this.materials = Object.fromEntries(Object.keys(INKS).map((name) => [name, new MeshStandardMaterial({ roughness: 0.55, metalness: 0.05 })]));
    Object.assign(this.materials.artefact, { transparent: true, opacity: 0.75 });
    Object.assign(this.materials.ghost, { transparent: true, opacity: 0.25, depthWrite: false });
    this.scene = new Scene();
    this.arm = new ArmBody(model.arm.joints.length, size, this.materials, model.turning_joint);
    this.measured = this.isTurn ? new HalfTurn(model, size, this.materials) : new Measured(model.postures, size * 0.004, this.materials);
    this.measured.enlarge(model.enlargement || 1);
    this.scene.add(new AmbientLight(0xffffff, 0.7), new HemisphereLight(0xffffff, 0x888888, 1.4));
    const sun = new DirectionalLight(0xffffff, 1.6);
    sun.position.set(1, -1.5, 2.5);
    this.scene.add(sun, this.arm.group, this.measured.group, artefactsOf(model.artefacts, size * 0.008, this.materials.artefact));
    this.arm.take(this.posture);
    this.camera = cameraFor(size);
  }

  layOut() {
    const title = this.figure.querySelector("figcaption h3").textContent;
    this.canvas = element("canvas");
    for (const [key, value] of Object.entries({ tabindex: 0, role: "application", "aria-label": title, "aria-description": say("scene_keys") })) {
      this.canvas.setAttribute(key, value);
    }
    this.readout = element("p", { class: "readout" });
    this.panel = panelOf(this.model, this.figure.classList.contains("wide"), {
      turn: (i, deg) => this.turn(i, deg),
      choose: (index) => this.choose(index),
      goAlong: (part) => this.goAlong(part),
      enlarge: (factor) => {
        this.measured.enlarge(factor);
        this.draw();
      },
    });
    this.button = element("button", { type: "button", class: "reset" }, say("reset_view"));
    const { place, show } = livePlace(this.figure);
    this.place = place;
    this.view = element("div", { class: "view" }, this.canvas, this.button);
    place.classList.add("scene");
    place.append(this.view, this.readout, this.panel.element, this.legend());
    show();
    this.panel.show(this.q_deg, this.chosen);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.enableZoom = false; // until it is asked for: the wheel scrolls the page
    this.canvas.style.touchAction = "pan-y";
  }

  legend() {
    const has = (check) => !this.isTurn && this.model.postures.some((posture) => posture.check === check);
    const item = (mark, style, text) => element("li", {}, element("span", { class: `mark s${style}`, "aria-hidden": "true" }, mark), text);
    return element(
      "ul",
      { class: "legend" },
      ...(has(false) ? [item("●", 0, say("fit_rows"))] : []),
      ...(has(true) ? [item("◆", 1, say("check_rows"))] : []),
      ...(this.model.artefacts.length > 0 ? [item("■", 2, say("artefacts"))] : []),
      element("li", {}, `${say("grid")} ${numberText(this.spacing)} mm`),
      element("li", {}, say("scene_hint")),
    );
  }

  listen() {
    this.controls.addEventListener("change", () => this.draw());
    this.canvas.addEventListener("pointerdown", () => (this.controls.enableZoom = true));
    this.canvas.addEventListener("pointerleave", () => (this.controls.enableZoom = false));
    this.canvas.addEventListener("dblclick", () => this.reset());
    this.canvas.addEventListener("keydown", (event) => this.onKey(event));
    this.button.addEventListener("click", () => this.reset());
    new ResizeObserver(() => this.draw()).observe(this.view);
    onThemeChange(() => this.paint());
  }

  // How far everything goes from the middle of the view; 1: to its edge.
  reach() {
    const seen = this.places.map((place) => new Vector3(...place).project(this.camera));
    return Math.max(...seen.flatMap(({ x, y }) => [Math.abs(x), Math.abs(y)]));
  }

  turn(i, deg) {
    this.q_deg[i] = deg;
    this.chosen = null;
    this.move();
  }

  choose(index) {
    this.q_deg = [...this.model.postures[index].q_deg];
    this.chosen = index;
    this.move();
  }

  // A part of the way from the first posture to the second.
  goAlong(part) {
    this.q_deg = readingsAlong(this.model.postures, part);
    this.chosen = null;
    this.move(part);
  }

  // @param part  of the way, where the arm is on it
  move(part = null) {
    this.posture = postureOf(this.model.arm, this.q_deg);
    this.arm.take(this.posture);
    this.panel.show(this.q_deg, part ?? this.chosen);
    this.say();
    this.draw();
  }

  // The tip in numbers, the residual of a measured posture, and how far the nominal arm would miss.
  say() {
    const { tip_mm } = this.posture;
    const residual_mm = this.model.postures[this.chosen]?.residual_mm;
    const lines = [`${say("tip")} ${tip_mm.map((v) => fixedText(v, 3)).join("  ")} mm`];
    if (residual_mm) lines.push(`${say("residual")} ${fixedText(Math.hypot(...residual_mm), 4)} mm`);
    if (this.model.nominal) {
      const nominal = postureOf(this.model.nominal, this.q_deg).tip_mm;
      lines.push(`${say("nominal_differs")} ${fixedText(Math.hypot(...nominal.map((v, k) => v - tip_mm[k])), 3)} mm`);
    }
    this.readout.replaceChildren(...lines.map((line) => element("span", {}, line)));
  }

  reset() {
    this.controls.target.copy(this.middle);
    lookAt(this.camera, this.middle, this.places, this.view.clientWidth / this.view.clientHeight || 1, this.isTurn);
    this.controls.update();
    this.say();
    this.draw();
  }

  onKey(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === "Escape") return this.reset();
    if (!moveByKey(this.camera, this.controls.target, event.key)) return;
    event.preventDefault();
    this.controls.update();
    this.draw();
  }

  // The colours of the theme.
  paint() {
    for (const [name, ink] of Object.entries(INKS)) this.materials[name].color.set(colour(ink));
    const ink = new Color(colour("--muted"));
    const lines = new Color(colour("--grid"));
    for (const object of this.drawn ?? []) {
      this.scene.remove(object);
      dispose(object);
    }
    this.drawn = [groundOf(this.around, this.spacing, lines), axesOf(this.size * 0.16, `#${ink.getHexString()}`), this.measured.names(colour("--ink"))];
    this.scene.add(...this.drawn);
    this.draw();
  }

  draw() {
    if (this.isWaiting) return;
    this.isWaiting = true;
    requestAnimationFrame(() => {
      this.isWaiting = false;
      const { clientWidth: width, clientHeight: height } = this.view;
      if (width === 0 || height === 0) return; // on paper
      this.camera.aspect = width / height;
      this.camera.updateProjectionMatrix();
      this.render(width, height);
    });
  }

  render(width, height) {
    const shared = sharedRenderer();
    const size = shared.getSize(new Vector2());
    if (shared.getPixelRatio() !== devicePixelRatio) shared.setPixelRatio(devicePixelRatio);
    if (size.x !== width || size.y !== height) shared.setSize(width, height, false);
    shared.render(this.scene, this.camera);
    const { width: columns, height: rows } = shared.domElement;
    Object.assign(this.canvas, { width: columns, height: rows });
    this.canvas.getContext("2d").drawImage(shared.domElement, 0, 0);
    this.frames += 1;
  }
}
