// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <cstdlib>
#include <string>

#include "armcal/io/text_encoding.h"
#include "armcal/io/urdf_file.h"
#include "armcal/io/urdf_writer.h"

// Any bytes at all are either read or complained of, never both and never neither; what was read is
// a sound arm, and can be written.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  armcal::DecodedText decoded =
      armcal::decode_text(std::string(reinterpret_cast<const char*>(data), size));
  armcal::Diagnostics diagnostics;
  const auto arm = armcal::read_urdf({"fuzz", std::move(decoded.text), decoded.encoding, ""},
                                     std::nullopt, diagnostics);
  if (arm.has_value() == diagnostics.has_errors()) std::abort();
  if (!arm) return 0;
  if (!armcal::problems_of(*arm).empty()) std::abort();
  armcal::Diagnostics second;
  const std::string text = armcal::urdf_text(*arm).text;
  if (!armcal::read_urdf({"again", text, "UTF-8", ""}, std::nullopt, second)) {
    // Only sums of many fixed offsets may pass the limit on a single one.
    if (second.to_text().find("no arm's") == std::string::npos) std::abort();
  }
  return 0;
}
