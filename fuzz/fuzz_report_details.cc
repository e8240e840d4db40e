// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <cstdlib>
#include <string>

#include "armcal/io/report_details_file.h"
#include "armcal/io/text_encoding.h"

// Any bytes at all are either read or complained of, never both and never neither.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  armcal::DecodedText decoded =
      armcal::decode_text(std::string(reinterpret_cast<const char*>(data), size));
  armcal::Diagnostics diagnostics;
  const bool read = armcal::read_report_details(
                        {"fuzz", std::move(decoded.text), decoded.encoding, ""}, diagnostics)
                        .has_value();
  if (read == diagnostics.has_errors()) std::abort();
  return 0;
}
