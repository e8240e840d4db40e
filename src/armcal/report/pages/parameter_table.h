// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/report/html/document_view.h"
#include "armcal/report/html/language.h"
#include "armcal/report/html/page.h"

namespace armcal {

/// The parameters of an arm (key `parameters` of the document): nominal, value, change, standard
/// uncertainty, status, share of the data. Values are rounded to two significant digits of their
/// uncertainty; angles in deg, harmonics in urad. Held ones that are 0 are left out, which a note
/// says.
[[nodiscard]] Table parameter_table(const DocumentView& document, const Language& say);
/// The same of readings that were looked at before a calibration: there is no value, no change.
[[nodiscard]] Table expected_parameter_table(const DocumentView& document, const Language& say);

}  // namespace armcal
