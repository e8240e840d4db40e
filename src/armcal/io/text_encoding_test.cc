// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/text_encoding.h"

#include <gtest/gtest.h>

namespace armcal {
namespace {

using namespace std::literals;

TEST(TextEncoding, RecognisesWhatMeasuringSoftwareWrites) {
  EXPECT_EQ(decode_text("x_mm;y_mm").encoding, "UTF-8");
  EXPECT_EQ(decode_text("\xEF\xBB\xBFx_mm").text, "x_mm");
  EXPECT_EQ(decode_text("\xFF\xFEx\0_\0"s).text, "x_");
  EXPECT_EQ(decode_text("\xFE\xFF\0x\0_"s).text, "x_");
  EXPECT_EQ(decode_text("x\0_\0m\0m\0\n\0"s).text, "x_mm\n");  // no mark
  const DecodedText german = decode_text(
      "L\xE4nge [\xB5m] 20 \xB0"
      "C");
  EXPECT_EQ(german.encoding, "Latin-1");
  EXPECT_EQ(german.text, "Länge [µm] 20 °C");
  const DecodedText chinese = decode_text("\xB9\xD8\xBD\xDA,x_mm");
  EXPECT_EQ(chinese.encoding, "GB18030");
  EXPECT_EQ(chinese.text, "关节,x_mm");
  EXPECT_EQ(decode_text("关节,x_mm").encoding, "UTF-8");
}

TEST(TextEncoding, RefusesMalformedUtf8AsUtf8) {
  EXPECT_NE(decode_text("\xC0\xAF").encoding, "UTF-8");          // over-long
  EXPECT_NE(decode_text("\xED\xA0\x80").encoding, "UTF-8");      // surrogate
  EXPECT_NE(decode_text("ok \xE2\x82").encoding, "UTF-8");       // cut off
  EXPECT_NE(decode_text("\xF5\x80\x80\x80").encoding, "UTF-8");  // beyond Unicode
}

TEST(TextEncoding, TellsBinary) {
  EXPECT_FALSE(first_binary_byte("a\tb\r\nµ").has_value());
  EXPECT_EQ(first_binary_byte("ab\0c"sv), 2u);
  EXPECT_EQ(first_binary_byte("\x7F"
                              "ELF\x02"),
            4u);
}

TEST(TextEncoding, TakesTheEmptyFile) { EXPECT_EQ(decode_text("").text, ""); }

}  // namespace
}  // namespace armcal
