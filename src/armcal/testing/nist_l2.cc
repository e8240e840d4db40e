// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/testing/nist_l2.h"

#include <fstream>

#include "armcal/testing/reference_data.h"

namespace armcal::testing {

std::vector<NistPair> nist_pairs(const std::string& geometry) {
  const auto folder = reference_data() / "oracles/nist_l2_geometric/raw" / geometry;
  std::vector<NistPair> pairs;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".ds") continue;
    NistPair pair;
    pair.name = entry.path().stem().string();
    std::ifstream data(entry.path());
    int count = 0;
    data >> count;
    for (double x = 0, y = 0, z = 0; data >> x >> y >> z;) pair.points.emplace_back(x, y, z);
    EXPECT_EQ(pair.points.size(), static_cast<std::size_t>(count)) << pair.name;
    std::ifstream fit(std::filesystem::path(entry.path()).replace_extension(".fit"));
    for (double number = 0; fit >> number;) pair.fit.push_back(number);
    pairs.push_back(pair);
  }
  return pairs;
}

}  // namespace armcal::testing
