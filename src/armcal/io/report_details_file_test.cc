// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/io/report_details_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace armcal {
namespace {

using ::testing::HasSubstr;

struct Details {
  Diagnostics diagnostics;
  std::optional<ReportDetails> read;
  explicit Details(const std::string& text)
      : read(read_report_details(
            {"a.details.toml", "schema = \"armcal.details/1\"\n" + text, "UTF-8", ""},
            diagnostics)) {}
};

std::string complaints_of(const std::string& details) {
  return Details(details).diagnostics.to_text();
}

TEST(ReportDetailsFile, HasEveryTextAsItWasTyped) {
  const Details details(
      "number = 20260117\nreplaces = \"20260116 (serial number corrected)\"\n"
      "[laboratory]\nname = \"Lab\"\naccreditation = \"D-K-1\"\n"
      "[customer]\nname = \"Works\"\naddress = \"\"\"\nRoad 2\n  Sampletown\n\"\"\"\n"
      "[method]\nedition = \"1.10\"\n"
      "[[external]]\nname = \"Bar Lab\"\nresults = \"length of the bar\"\n"
      "[[external]]\nresults = 3\n"
      "[released_by]\nname = \"A. Person\"\nrole = \"head\"\n");
  EXPECT_EQ(details.diagnostics.to_text(), "");
  ASSERT_TRUE(details.read);
  EXPECT_EQ(details.read->number, "20260117");
  EXPECT_EQ(details.read->replaces, "20260116 (serial number corrected)");
  EXPECT_EQ(details.read->laboratory.accreditation, "D-K-1");
  EXPECT_EQ(details.read->customer.address, "Road 2\n  Sampletown");  // and no empty line after it
  EXPECT_EQ(details.read->method.edition, "1.10");
  ASSERT_EQ(details.read->externals.size(), 2U);
  EXPECT_EQ(details.read->externals[0].name, "Bar Lab");
  EXPECT_EQ(details.read->externals[0].results, "length of the bar");
  EXPECT_EQ(details.read->externals[1].results, "3");
  EXPECT_EQ(details.read->released_by.role, "head");
}

TEST(ReportDetailsFile, RefusesDecimalsThatWouldChange) {
  EXPECT_EQ(complaints_of("[method]\nedition = 1.10\n"),
            "a.details.toml:3:1: error: edition is a decimal number without quotes\n"
            "  help: write it in quotes, so that it stays as it is typed\n");
}

// It was read and never printed.
TEST(ReportDetailsFile, KnowsNoAccreditationOfCustomers) {
  EXPECT_THAT(complaints_of("[customer]\nname = \"x\"\naccreditation = \"D-K-1\"\n"),
              HasSubstr("a.details.toml:4:1: error: unknown key \"accreditation\""));
  EXPECT_THAT(complaints_of("[customer]\nadress = \"x\"\n"),
              HasSubstr("did you mean \"address\"?"));
  EXPECT_THAT(complaints_of("[[external]]\nresult = \"x\"\n"),
              HasSubstr("did you mean \"results\"?"));
}

TEST(ReportDetailsFile, SkipsEntriesInWhichEverythingIsBlank) {
  const Details details(
      "[[reference]]\nname = \"\"\ndue = \" \"\n[[reference]]\n[[reference]]\nserial = \"B-9\"\n"
      "[[external]]\nname = \"\"\n");
  ASSERT_TRUE(details.read);
  ASSERT_EQ(details.read->references.size(), 1U);
  EXPECT_EQ(details.read->references[0].serial, "B-9");
  EXPECT_TRUE(details.read->externals.empty());
}

TEST(ReportDetailsFile, WarnsOfDatesThatCannotFollowEachOther) {
  const std::string in_order = "[dates]\nreceived = 2026-03-02\nperformed = 2026-03-02\n";
  EXPECT_EQ(complaints_of(in_order + "issued = 2026-03-05\n"), "");
  EXPECT_EQ(complaints_of(in_order + "issued = \"2026-02-05\"\n"),
            "a.details.toml:5:1: warning: issued 2026-02-05 is before performed 2026-03-02\n"
            "  help: is one of them mistyped?\n");
  EXPECT_THAT(complaints_of("[dates]\nperformed = 2026-03-01\nreceived = 2026-03-02\n"),
              HasSubstr("a.details.toml:3:1: warning: performed 2026-03-01 is before received"));
  EXPECT_TRUE(Details(in_order + "issued = 2026-02-05\n").read);
  // What stands between says nothing; the others still do.
  EXPECT_THAT(complaints_of("[dates]\nreceived = 2026-03-02\n"
                            "performed = \"2026-01-10/2026-01-12\"\nissued = 2026-03-01\n"),
              HasSubstr("5:1: warning: issued 2026-03-01 is before received 2026-03-02"));
}

TEST(ReportDetailsFile, LeavesRangesAndWordsToTheReader) {
  for (const char* performed : {"2026-01-10/2026-01-12", "spring of 2026", "2026-02-30", "1/2/2026",
                                "2026-01-10T09:00", ""}) {
    EXPECT_EQ(complaints_of("[dates]\nreceived = 2026-03-02\nperformed = \"" +
                            std::string(performed) + "\"\n[[reference]]\ndue = 2020-01-01\n"),
              "")
        << performed;
  }
}

TEST(ReportDetailsFile, WarnsOfReferencesWhoseCalibrationCountedNoMore) {
  const std::string reference =
      "[[reference]]\nname = \"bar\"\ndue = 2026-03-01\n[[reference]]\nname = \"tracker\"\n"
      "due = \"open\"\n";
  EXPECT_EQ(complaints_of(reference + "[dates]\nperformed = 2026-03-01\n"), "");
  EXPECT_EQ(
      complaints_of(reference + "[dates]\nperformed = 2026-03-02\n"),
      "a.details.toml:4:1: warning: due 2026-03-01 of \"bar\" is before performed 2026-03-02: "
      "its calibration counted no more\n"
      "  help: name the certificate that counted on that day\n");
}

}  // namespace
}  // namespace armcal
