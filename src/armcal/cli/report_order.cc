// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/cli/report_order.h"

#include "armcal/workflow/pdf_print.h"
#include "armcal/workflow/report_job.h"

namespace armcal::cli {

ReportWriter::ReportWriter(ReportOrder order, Overwrite overwrite, const Monitor& monitor,
                           ReportDetails kept)
    : order_(std::move(order)),
      overwrite_(overwrite),
      monitor_(monitor),
      details_(std::move(kept)) {
  for (const std::string& path : paths()) check_may_write(path, overwrite_);
  if (order_.pdf) browser_ = printing_browser();
  if (order_.details_file) {
    InputFiles files(monitor_);
    details_ = load_report_details(files, *order_.details_file);
  }
}

std::vector<std::string> ReportWriter::paths() const {
  std::vector<std::string> paths;
  if (order_.html) paths.push_back(*order_.html);
  if (order_.pdf) paths.push_back(*order_.pdf);
  return paths;
}

void ReportWriter::write(const std::string& document, const std::string& file) const {
  const std::string html = html_report(document, file, order_.language, details_);
  if (order_.html) write_file(*order_.html, html, overwrite_);
  if (order_.pdf) print_as_pdf(html, browser_, *order_.pdf, overwrite_, monitor_);
}

}  // namespace armcal::cli
