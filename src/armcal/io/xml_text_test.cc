// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/xml_text.h"

#include <gtest/gtest.h>

namespace armcal {
namespace {

TEST(XmlText, LeavesNothingThatEndsATagOrAnAttribute) {
  EXPECT_EQ(xml_escaped("<script>\"a\" & b</script>"),
            "&lt;script&gt;&quot;a&quot; &amp; b&lt;/script&gt;");
}

TEST(XmlText, HasNoControlCharacters) {
  EXPECT_EQ(xml_escaped(std::string_view("a\0b\x1b[0m\n", 8)), "a b [0m ");
}

TEST(XmlText, KeepsOtherScripts) { EXPECT_EQ(xml_escaped("测量臂 é"), "测量臂 é"); }

}  // namespace
}  // namespace armcal
