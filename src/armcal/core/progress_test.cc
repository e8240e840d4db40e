// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/core/progress.h"

#include <gtest/gtest.h>

namespace armcal {
namespace {

TEST(Monitor, TellsTheListener) {
  double seen = -1.0;
  const Monitor monitor{[&](const Progress& progress) { seen = progress.fraction; }, {}};
  monitor.report("reading", 0.25);
  EXPECT_EQ(seen, 0.25);
}

TEST(Monitor, NeedsNoListener) { Monitor{}.report("reading", 0.5); }

TEST(Monitor, StopsTheJob) {
  std::stop_source source;
  const Monitor monitor{{}, source.get_token()};
  monitor.report("reading", 0.1);
  source.request_stop();
  EXPECT_THROW(monitor.report("reading", 0.2), Interrupted);
}

}  // namespace
}  // namespace armcal
