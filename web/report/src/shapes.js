// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
// Shapes and dashes of series: the same as in the drawings (src/armcal/report/chart/marks.cc), so that neither colour
// nor the change from drawing to live chart carries meaning.
const DASHES = [[], [7, 4], [2, 3], [9, 3, 2, 3], [12, 4], [4, 2]];

export const styleOf = (number) => ((number % 6) + 6) % 6;
export const seriesColour = (number) => `--series-${styleOf(number)}`;
export const dashOf = (number) => DASHES[styleOf(number)];
// Drawn by stroke alone: plus, cross and the second six.
export const isOutline = (number) => styleOf(number) >= 4 || Math.floor(number / 6) % 2 !== 0;

// An outline about (x, y), as a path of SVG and of canvases.
export function shapePath(number, x, y, r) {
  switch (styleOf(number)) {
    case 0:
      return `M${x - r} ${y}a${r} ${r} 0 1 1 0 .01z`;
    case 1: {
      const d = 1.25 * r;
      return `M${x} ${y - d}l${d} ${d}l${-d} ${d}l${-d} ${-d}z`;
    }
    case 2:
      return `M${x} ${y - r}l${r} ${1.8 * r}h${-2 * r}z`;
    case 3:
      return `M${x - 0.85 * r} ${y - 0.85 * r}h${1.7 * r}v${1.7 * r}h${-1.7 * r}z`;
    case 4:
      return `M${x - r} ${y}h${2 * r}M${x} ${y - r}v${2 * r}`;
    default: {
      const d = 0.8 * r;
      return `M${x - d} ${y - d}l${2 * d} ${2 * d}M${x + d} ${y - d}l${-2 * d} ${2 * d}`;
    }
  }
}

export const markRadius = (count) => (count <= 60 ? 3.6 : count <= 300 ? 2.8 : 2);
