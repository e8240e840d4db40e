// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
import { element } from "./element.js";
import { say } from "./words.js";

const whenIdle = window.requestIdleCallback ?? ((work) => setTimeout(work, 50)); // not in every Safari

// Gives each figure that has something to play with its live view, once it comes near the screen and the page has
// nothing else to do: a report of many figures opens as fast as one of none. The drawing stays for paper.
export function enliven(makers) {
  const observer = new IntersectionObserver(
    (entries) => {
      for (const { target, isIntersecting } of entries) {
        if (!isIntersecting) continue;
        observer.unobserve(target);
        whenIdle(() => make(target, makers), { timeout: 1000 });
      }
    },
    { rootMargin: "400px" },
  );
  for (const script of document.querySelectorAll("figure > script.live")) observer.observe(script.parentElement);
}

// A half turn is told better by its drawing: it comes to life when asked.
function make(figure, makers) {
  const model = JSON.parse(figure.querySelector(":scope > script.live").textContent);
  const enliven = () => makers[model.kind]?.(figure, model);
  if (model.turning_joint == null) return enliven();
  const button = element("button", { type: "button", class: "enliven" }, say("move"));
  button.addEventListener("click", () => {
    button.remove();
    enliven();
  });
  figure.querySelector(":scope > figcaption").prepend(button);
}

// The place of a live view. The figure shows it in place of the drawing from show() on.
export function livePlace(figure) {
  const place = element("div", { class: "live-view" });
  figure.querySelector(":scope > .drawing").after(place);
  return { place, show: () => figure.classList.add("is-live") };
}
