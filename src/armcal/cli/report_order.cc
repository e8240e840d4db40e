// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/cli/report_order.h"

#include <filesystem>
#include <stdexcept>

#include "armcal/workflow/pdf_print.h"
#include "armcal/workflow/report_job.h"

namespace armcal::cli {

ReportWriter::ReportWriter(ReportOrder order, Overwrite overwrite, const Monitor& monitor,
                           ReportDetails kept)
    : order_(std::move(order)),
      overwrite_(overwrite),
      overwrite_page_(overwrite),
      monitor_(monitor),
      details_(std::move(kept)) {
  const auto place = [](const std::string& path) {
    return std::filesystem::absolute(path).lexically_normal();
  };
  if (order_.html && order_.pdf && place(*order_.html) == place(*order_.pdf)) {
    throw std::invalid_argument("the page and the PDF of a report cannot be the same file");
  }
  for (const std::string& path : paths()) check_may_write(path, overwrite_);
  if (order_.pdf) browser_ = printing_browser();
  if (order_.details_file) {
    InputFiles files(monitor_);
    details_ = load_report_details(files, *order_.details_file);
    details_records_ = files.records();
    diagnostics_ = files.diagnostics();
  }
}

std::vector<std::string> ReportWriter::paths() const {
  std::vector<std::string> paths;
  if (order_.html) paths.push_back(*order_.html);
  if (order_.pdf) paths.push_back(*order_.pdf);
  return paths;
}

void ReportWriter::place_page(std::string path) {
  order_.html = std::move(path);
  overwrite_page_ = Overwrite::allow;
}

void ReportWriter::make(const std::string& document, const std::string& file,
                        std::span<const InputRecord> inputs) {
  for (const std::string& path : paths()) {
    require_no_input(path, inputs);
    require_no_input(path, details_records_);
  }
  html_ = html_report(document, file, order_.language.value_or("en"), details_);
}

void ReportWriter::write_page() const {
  if (order_.html) write_file(*order_.html, html_, overwrite_page_);
}

void ReportWriter::print() const {
  if (order_.pdf) print_as_pdf(html_, browser_, *order_.pdf, overwrite_, monitor_);
}

}  // namespace armcal::cli
