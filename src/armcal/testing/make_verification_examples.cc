// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>
#include <fstream>
#include <iostream>

#include "armcal/testing/reference_data.h"
#include "armcal/testing/verification_examples.h"
#include "armcal/workflow/input_files.h"

// Writes the tables of examples/verification anew.
int main() {
  const auto folder = armcal::testing::repository() / "examples";
  armcal::InputFiles files;
  const auto truth = files.arm((folder / "arms/romer-infinite-2.0.arm.toml").string());
  files.require_good();
  for (const auto& [name, text] : armcal::testing::verification_example_tables(*truth)) {
    std::ofstream(folder / "verification" / name) << text;
    std::cout << name << '\n';
  }
  return EXIT_SUCCESS;
}
