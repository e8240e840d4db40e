// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
// Dark or light: as the system has it until the button says otherwise. Colours live in report.css alone.
const watchers = [];
const preference = matchMedia("(prefers-color-scheme: dark)");
let probe = null;

export function isDark() {
  const chosen = document.documentElement.dataset.theme;
  return chosen ? chosen === "dark" : preference.matches;
}

// The value of a colour of the style sheet now: "--ink" gives "rgb(22, 32, 43)".
export function colour(name) {
  if (!probe) {
    probe = document.createElement("i");
    probe.hidden = true;
    document.body.append(probe);
  }
  probe.style.color = `var(${name})`;
  return getComputedStyle(probe).color;
}

export function onThemeChange(watcher) {
  watchers.push(watcher);
}

function tell() {
  document.getElementById("armcal-theme").setAttribute("aria-pressed", String(isDark()));
  for (const watcher of watchers) watcher();
}

export function setUpTools() {
  document.querySelector(".tools").hidden = false;
  document.getElementById("armcal-print").addEventListener("click", () => window.print());
  document.getElementById("armcal-theme").addEventListener("click", () => {
    document.documentElement.dataset.theme = isDark() ? "light" : "dark";
    tell();
  });
  preference.addEventListener("change", tell);
  tell();
}
