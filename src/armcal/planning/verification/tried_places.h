// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

namespace armcal {

/// What became of the places that were tried for an artefact, for the message where none will do.
class TriedPlaces {
 public:
  void accept() { ++accepted_; }
  void reject(const std::string& reason) { ++count_[reason]; }
  /// "of 400 places tried, 310 were below the bench, 90 were out of reach": most frequent first.
  [[nodiscard]] std::string text() const;

 private:
  long accepted_ = 0;
  std::map<std::string, long> count_;
};

}  // namespace armcal
