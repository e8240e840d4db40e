// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "armcal/io/report_details_file.h"
#include "armcal/report/html/document_view.h"
#include "armcal/report/html/language.h"
#include "armcal/report/html/page.h"

namespace armcal {

/// Puts what the details say onto a page: who, what and when beside its title; conditions,
/// references, method, statements, results of others and who released it as a section behind the
/// result. What is empty is left out. ISO/IEC 17025:2017, 7.8.2.1, 7.8.4.1, 7.8.6 and 7.8.8.
void add_details(const ReportDetails& details, const Language& say, Page& page);

/// Where the numbers come from: files with their SHA-256, version, seed, command line, warnings.
[[nodiscard]] Section origin_section(const DocumentView& document, const Language& say);

}  // namespace armcal
