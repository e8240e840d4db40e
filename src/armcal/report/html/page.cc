// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/html/page.h"

namespace armcal {

const char* tone_class(Tone tone) {
  switch (tone) {
    case Tone::good:
      return "good";
    case Tone::bad:
      return "bad";
    case Tone::warning:
      return "warning";
    case Tone::neutral:
      break;
  }
  return "neutral";
}

const char* tone_sign(Tone tone) {
  switch (tone) {
    case Tone::good:
      return "\u2713";
    case Tone::bad:
      return "\u2717";
    case Tone::warning:
      return "\u26a0\ufe0e";
    case Tone::neutral:
      break;
  }
  return "";
}

const char* column_class(ColumnKind kind) {
  switch (kind) {
    case ColumnKind::number:
      return "num";
    case ColumnKind::word:
      return "word";
    case ColumnKind::prose:
      return "prose";
    case ColumnKind::text:
      break;
  }
  return "text";
}

}  // namespace armcal
