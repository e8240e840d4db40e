// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "armcal/report/html/page_html.h"
#include "armcal/testing/temporary_folder.h"
#include "armcal/testing/tool.h"

// `armcal report`, and --report, --pdf, --lang and --details of every command.
namespace armcal::cli {
namespace {

using testing::example;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;
using testing::TemporaryFolder;
using testing::tool;
using testing::ToolResult;

const std::vector<std::string> kFit = {"fit", "sphere", example("points/sphere.csv")};

std::vector<std::string> fit_with(const std::vector<std::string>& more) {
  std::vector<std::string> words = kFit;
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

bool exists(const std::string& path) { return std::filesystem::exists(path); }

// A program that stands in for the browser, as ARMCAL_BROWSER names it.
class Browser {
 public:
  Browser(const TemporaryFolder& folder, const std::string& script)
      : path_(folder.write("browser", "#!/bin/sh\n" + script)) {
    chmod(path_.c_str(), 0700);
    setenv("ARMCAL_BROWSER", path_.c_str(), 1);
  }
  ~Browser() { unsetenv("ARMCAL_BROWSER"); }
  Browser(const Browser&) = delete;
  Browser& operator=(const Browser&) = delete;

 private:
  std::string path_;
};

// Writes what it printed, as a browser would, and keeps the page that it was given.
std::string printing(const TemporaryFolder& folder) {
  return "for word; do\n"
         "  case $word in --print-to-pdf=*) out=${word#*=};; file://*) page=${word#file://};; "
         "esac\n"
         "done\n"
         "cp \"$page\" '" +
         folder.path("seen.html") + "'\nprintf '%%PDF-1.7 of a test' > \"$out\"\n";
}

TEST(Reports, AreWrittenBesideWhatACommandPrints) {
  const TemporaryFolder folder;
  const std::string html = folder.path("r.html");
  const ToolResult plain = tool(kFit);
  const ToolResult reported = tool(fit_with({"--report", html}));
  EXPECT_EQ(reported.code, 0);
  EXPECT_EQ(reported.out, plain.out);
  EXPECT_THAT(reported.err, HasSubstr("report: " + html));
  EXPECT_THAT(testing::read_bytes(html), HasSubstr("Best-fit sphere"));
}

TEST(Reports, GiveTheirResultBackByteForByte) {
  const TemporaryFolder folder;
  const std::string html = folder.path("r.html");
  const ToolResult made = tool(fit_with({"--json", "--report", html}));
  EXPECT_EQ(tool({"report", html, "--extract"}).out, made.out);
  // Into a file, too, and from a report of that file.
  const std::string json = folder.path("back.json");
  EXPECT_EQ(tool({"report", html, "--extract", "-o", json}).code, 0);
  EXPECT_EQ(testing::read_bytes(json), made.out);
  const std::string again = folder.path("again.html");
  EXPECT_EQ(tool({"report", json, "-o", again}).out, again + "\n");
  EXPECT_EQ(testing::read_bytes(again), testing::read_bytes(html));
}

TEST(Reports, SpeakTheLanguageThatIsAskedFor) {
  const TemporaryFolder folder;
  const std::string html = folder.path("r.html");
  EXPECT_EQ(tool(fit_with({"--report", html, "--lang", "zh"})).code, 0);
  EXPECT_THAT(testing::read_bytes(html), HasSubstr("<html lang=\"zh\">"));
  EXPECT_THAT(testing::read_bytes(html), HasSubstr("最佳拟合球"));
  const ToolResult unknown = tool(fit_with({"--report", folder.path("x.html"), "--lang", "fr"}));
  EXPECT_EQ(unknown.code, 2);
  EXPECT_EQ(unknown.err,
            "error: armcal fit: --lang: \"fr\" is none of en, zh\n"
            "  help: armcal fit --help shows what it takes\n");
  EXPECT_FALSE(exists(folder.path("x.html")));
}

// A report in another language lost customer, item and dates.
TEST(Reports, KeepTheirDetailsWhereTheyAreMadeAgain) {
  const TemporaryFolder folder;
  const std::string details = folder.write("a.details.toml",
                                           "schema = \"armcal.details/1\"\nnumber = \"K-7\"\n"
                                           "[customer]\nname = \"Fräser & <b>Söhne</b>\"\n");
  const std::string html = folder.path("r.html");
  EXPECT_EQ(tool(fit_with({"--report", html, "--details", details})).code, 0);
  const std::string zh = folder.path("zh.html");
  EXPECT_EQ(tool({"report", html, "-o", zh, "--lang", "zh"}).code, 0);
  const std::string page = testing::read_bytes(zh);
  EXPECT_THAT(page, HasSubstr("K-7"));
  EXPECT_THAT(page, HasSubstr("Fräser &amp; &lt;b&gt;Söhne&lt;/b&gt;"));
  EXPECT_EQ(details_in_html(page), testing::read_bytes(details));
  // Others take their place.
  const std::string other =
      folder.write("b.details.toml", "schema = \"armcal.details/1\"\nnumber = \"K-8\"\n");
  EXPECT_EQ(tool({"report", zh, "-o", folder.path("b.html"), "--details", other}).code, 0);
  EXPECT_THAT(testing::read_bytes(folder.path("b.html")), Not(HasSubstr("K-7")));
}

TEST(Reports, RefuseDetailsThatCannotBeReadBeforeTheWorkBegins) {
  const TemporaryFolder folder;
  const std::string details =
      folder.write("a.details.toml", "schema = \"armcal.details/1\"\n[customer]\nnmae = \"x\"\n");
  const ToolResult result =
      tool(fit_with({"--report", folder.path("r.html"), "--details", details}));
  EXPECT_EQ(result.code, 2);
  EXPECT_THAT(result.err, HasSubstr("a.details.toml:3:1: error: unknown key \"nmae\""));
  EXPECT_EQ(result.out, "");
  EXPECT_FALSE(exists(folder.path("r.html")));
}

TEST(Reports, AreMissedWhereDetailsOrALanguageStandAlone) {
  const ToolResult result =
      tool(fit_with({"--details", example("report/laboratory.details.toml")}));
  EXPECT_EQ(result.code, 2);
  EXPECT_THAT(result.err,
              HasSubstr("--details is for a report: say --report FILE or --pdf FILE too"));
  const ToolResult spoken = tool(fit_with({"--lang", "zh"}));
  EXPECT_EQ(spoken.code, 2);
  EXPECT_EQ(spoken.out, "");
  EXPECT_THAT(spoken.err, HasSubstr("--lang is for a report: say --report FILE or --pdf FILE too"));
}

TEST(Reports, WarnOfDetailsThatCannotBeWhileTheyAreMade) {
  const TemporaryFolder folder;
  const std::string details =
      folder.write("a.details.toml",
                   "schema = \"armcal.details/1\"\n[dates]\nreceived = 2026-03-02\n"
                   "performed = 2026-03-01\n");
  const std::string html = folder.path("r.html");
  const std::string warning = ":4:1: warning: performed 2026-03-01 is before received 2026-03-02";
  const ToolResult made = tool(fit_with({"--report", html, "--details", details}));
  EXPECT_EQ(made.code, 0);
  EXPECT_THAT(made.err, StartsWith(details + warning));
  EXPECT_EQ(made.out, tool(kFit).out);
  EXPECT_THAT(tool({"report", html, "-o", folder.path("b.html")}).err,
              HasSubstr("(its details)" + warning));
  EXPECT_THAT(tool({"report", html, "-o", folder.path("c.html"), "--details", details}).err,
              StartsWith(details + warning));
  EXPECT_THAT(tool({"demo", "--report", folder.path("d.html"), "--details", details}).err,
              StartsWith(details + warning));
  EXPECT_EQ(tool({"report", html, "--extract"}).err, "");
  EXPECT_EQ(tool(fit_with({"--report", html, "--details", details, "--quiet", "--force"})).err, "");
}

// The same result had another number in every file it was written to.
TEST(Reports, OfTheSameResultHaveTheSameNumber) {
  const TemporaryFolder folder;
  const auto number_in = [&](const std::string& name, const std::vector<std::string>& more) {
    std::vector<std::string> words = fit_with(more);
    words.insert(words.end(), {"--report", folder.path(name)});
    EXPECT_EQ(tool(words).code, 0);
    const std::string page = testing::read_bytes(folder.path(name));
    return page.substr(page.find("armcal-", page.find("<p class=\"number\">")), 19);
  };
  const std::string number = number_in("a.html", {});
  EXPECT_THAT(number, ::testing::MatchesRegex("armcal-[0-9a-f]{12}"));
  EXPECT_EQ(number_in("b.html", {"--quiet"}), number);
  EXPECT_EQ(number_in("c.html", {"--lang", "zh"}), number);
}

TEST(Reports, KeepTheLanguageOfTheReportTheyAreMadeOf) {
  const TemporaryFolder folder;
  const std::string zh = folder.path("zh.html");
  const std::string again = folder.path("again.html");
  EXPECT_EQ(tool(fit_with({"--report", zh, "--lang", "zh"})).code, 0);
  const Json said = tool({"report", zh, "-o", again, "--json"}).json();
  EXPECT_EQ(said["language"], "zh");
  EXPECT_EQ(testing::read_bytes(again), testing::read_bytes(zh));
  EXPECT_EQ(tool({"report", zh, "-o", again, "--lang", "en", "--force"}).code, 0);
  EXPECT_THAT(testing::read_bytes(again), HasSubstr("<html lang=\"en\">"));
}

// A word of a file in the place of another of the same length.
std::string with_changed(const std::string& path, std::string_view word, std::string_view by) {
  std::string bytes = testing::read_bytes(path);
  EXPECT_NE(bytes.find(word), std::string::npos) << word;
  for (std::size_t at = bytes.find(word); at != std::string::npos; at = bytes.find(word, at)) {
    bytes.replace(at, word.size(), by);
  }
  return bytes;
}

TEST(Reports, WhoseResultWasChangedAreReadWithAWarning) {
  const TemporaryFolder folder;
  const std::string html = folder.path("r.html");
  const ToolResult made = tool(fit_with({"--json", "--report", html}));
  const std::string changed =
      folder.write("changed.html", with_changed(html, "\"command\": \"fit", "\"command\": \"fiT"));
  const std::string warning =
      changed + ": warning: its result was changed after the report was made\n  help: ";
  const ToolResult extracted = tool({"report", changed, "--extract"});
  EXPECT_EQ(extracted.code, 0);
  EXPECT_THAT(extracted.err, StartsWith(warning));
  EXPECT_THAT(extracted.out, HasSubstr("\"command\": \"fiT"));
  EXPECT_EQ(tool({"report", changed, "--extract", "--quiet"}).err, "");
  const ToolResult again = tool({"report", changed, "-o", folder.path("again.html"), "--json"});
  EXPECT_EQ(again.code, 0);
  EXPECT_THAT(again.err, StartsWith(warning));
  EXPECT_EQ(again.json()["warnings"].size(), 1U);
  // As it was made, and as it was made before reports had the sum.
  EXPECT_EQ(tool({"report", html, "--extract"}).err, "");
  const std::string older =
      folder.write("older.html", with_changed(changed, "data-sha256", "data-other"));
  EXPECT_EQ(tool({"report", older, "--extract"}).err, "");
}

// Details that earlier versions took are no reason to withhold the result.
TEST(Reports, WithDetailsThatAreNotReadTodayStillGiveTheirResult) {
  const TemporaryFolder folder;
  const std::string details = folder.write("a.details.toml",
                                           "schema = \"armcal.details/1\"\n[customer]\n"
                                           "address = \"Road 2\"\n");
  const std::string html = folder.path("r.html");
  const ToolResult made = tool(fit_with({"--json", "--report", html, "--details", details}));
  const std::string older = folder.write("older.html", with_changed(html, "naddress", "nadresse"));
  EXPECT_EQ(tool({"report", older, "--extract"}).out, made.out);
  const ToolResult refused = tool({"report", older, "-o", folder.path("b.html")});
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("(its details):3:1: error: unknown key \"adresse\""));
  EXPECT_THAT(refused.err, HasSubstr("help: give others: --details FILE"));
  EXPECT_EQ(tool({"report", older, "-o", folder.path("b.html"), "--details", details}).code, 0);
}

TEST(Reports, DoNotGoWhereResultsGo) {
  for (const char* flag : {"--report", "--pdf"}) {
    const ToolResult result = tool(fit_with({flag, "-"}));
    EXPECT_EQ(result.code, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_THAT(result.err, StartsWith(std::string("error: ") + flag +
                                       " -: standard output is for the result\n  help: name a "
                                       "file: " +
                                       flag + " FILE."));
  }
  EXPECT_EQ(tool({"demo", "--report", "-"}).code, 2);
}

TEST(Reports, OverwriteNothing) {
  const TemporaryFolder folder;
  const std::string html = folder.write("r.html", "mine");
  const ToolResult refused = tool(fit_with({"--report", html}));
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("--force"));
  EXPECT_EQ(refused.out, "");
  EXPECT_EQ(testing::read_bytes(html), "mine");
  EXPECT_EQ(tool(fit_with({"--report", html, "--force"})).code, 0);
  EXPECT_THAT(testing::read_bytes(html), StartsWith("<!doctype html>"));

  const std::string points =
      folder.write("points.csv", testing::read_bytes(example("points/sphere.csv")));
  const ToolResult input = tool({"fit", "sphere", points, "--report", points, "--force"});
  EXPECT_EQ(input.code, 2);
  EXPECT_THAT(input.err, HasSubstr("is an input of this very command"));
  EXPECT_EQ(testing::read_bytes(points), testing::read_bytes(example("points/sphere.csv")));
  const ToolResult itself = tool({"report", html, "-o", html, "--force"});
  EXPECT_EQ(itself.code, 2);
}

TEST(Reports, OverwriteNeitherTheirDetailsNorEachOther) {
  const TemporaryFolder folder;
  const std::string details = folder.write(
      "a.details.toml", testing::read_bytes(example("report/laboratory.details.toml")));
  const ToolResult over = tool(fit_with({"--report", details, "--details", details, "--force"}));
  EXPECT_EQ(over.code, 2);
  EXPECT_EQ(testing::read_bytes(details),
            testing::read_bytes(example("report/laboratory.details.toml")));
  const std::string same = folder.path("same.x");
  const ToolResult both = tool(fit_with({"--report", same, "--pdf", same}));
  EXPECT_EQ(both.code, 2);
  EXPECT_THAT(both.err, HasSubstr("cannot be the same file"));
  EXPECT_FALSE(exists(same));
}

TEST(Reports, AreNotMadeOfFailures) {
  const TemporaryFolder folder;
  const std::string html = folder.path("r.html");
  EXPECT_EQ(tool({"fit", "sphere", folder.path("none.csv"), "--report", html}).code, 2);
  EXPECT_FALSE(exists(html));
  const ToolResult failed = tool({"fit", "sphere", folder.path("none.csv"), "--json"});
  const ToolResult refused = tool({"report", folder.write("failed.json", failed.out), "-o", html});
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("the command failed, so there is no result to report"));
  EXPECT_FALSE(exists(html));
}

TEST(Reports, SayWhatAFileIsNot) {
  const TemporaryFolder folder;
  const std::string html = folder.path("r.html");
  const auto complaint = [&](const std::string& bytes) {
    const ToolResult result = tool({"report", folder.write("file", bytes), "-o", html, "--force"});
    EXPECT_EQ(result.code, 2) << bytes;
    EXPECT_FALSE(exists(html));
    return result.err;
  };
  EXPECT_THAT(complaint("{\"schema\": "), HasSubstr("file: error: is not JSON (at byte 12)"));
  EXPECT_THAT(complaint("x_mm,y_mm\n1,2\n"), HasSubstr("is not JSON"));
  EXPECT_THAT(complaint(""), HasSubstr("is empty"));
  EXPECT_THAT(complaint("<!doctype html><p>news"),
              HasSubstr("is a web page, but no report of armcal"));
  EXPECT_THAT(complaint("{\"schema\": \"armcal.result/1\", \"v\": 1e999}"),
              HasSubstr("holds a number that is too large"));
  EXPECT_THAT(complaint(std::string(100'000, '[') + std::string(100'000, ']')),
              HasSubstr("is nested deeper than any result"));
  EXPECT_THAT(complaint("[1, 2]"), HasSubstr("is no result of armcal"));
  EXPECT_THAT(complaint("{\"schema\": \"armcal.result/2\", \"command\": \"fit\"}"),
              HasSubstr("key schema: is \"armcal.result/2\"; this armcal reads armcal.result/1"));
  EXPECT_THAT(complaint("{\"schema\": \"armcal.result/1\", \"command\": \"diff\"}"),
              HasSubstr("key changes: is missing"));
}

TEST(ReportCommand, WantsToKnowWhatToWrite) {
  const TemporaryFolder folder;
  const std::string json = folder.write("fit.json", tool(fit_with({"--json"})).out);
  const ToolResult nothing = tool({"report", json});
  EXPECT_EQ(nothing.code, 2);
  EXPECT_THAT(nothing.err, HasSubstr("say -o FILE.html, --pdf FILE.pdf or --extract"));
  EXPECT_THAT(tool({"report", json, "--report", folder.path("r.html")}).err,
              HasSubstr("report writes to the file that -o names"));
  EXPECT_THAT(tool({"report", json, "--extract", "--pdf", folder.path("r.pdf")}).err,
              HasSubstr("--extract gives the numbers back and prints no PDF"));
  const ToolResult missing =
      tool({"report", folder.path("none.json"), "-o", folder.path("r.html")});
  EXPECT_EQ(missing.code, 2);
  EXPECT_THAT(missing.err, HasSubstr("none.json"));
}

TEST(ReportCommand, WritesThePageAloneToStandardOutput) {
  const TemporaryFolder folder;
  const std::string json = folder.write("fit.json", tool(fit_with({"--json"})).out);
  const std::string html = folder.path("r.html");
  EXPECT_EQ(tool({"report", json, "-o", html}).code, 0);
  const ToolResult printed = tool({"report", json, "-o", "-"});
  EXPECT_EQ(printed.code, 0);
  EXPECT_EQ(printed.out, testing::read_bytes(html));
  EXPECT_EQ(printed.err, "");
  const ToolResult both = tool({"report", json, "-o", "-", "--json"});
  EXPECT_EQ(both.code, 2);
  EXPECT_THAT(both.err, HasSubstr("cannot both go to standard output\n  help: name a file"));
  EXPECT_EQ(tool({"report", json, "-o", "-", "--pdf", "-"}).code, 2);
}

TEST(ReportCommand, ExtractsWithoutFlagsOfReports) {
  const TemporaryFolder folder;
  const std::string json = folder.write("fit.json", tool(fit_with({"--json"})).out);
  for (const char* flag : {"--lang", "--details"}) {
    const ToolResult result = tool({"report", json, "--extract", flag, "zh"});
    EXPECT_EQ(result.code, 2);
    EXPECT_THAT(result.err, HasSubstr("as they are: no --lang, no --details"));
  }
}

TEST(ReportCommand, SaysInJsonWhatItWrote) {
  const TemporaryFolder folder;
  const std::string json = folder.write("fit.json", tool(fit_with({"--json"})).out);
  const std::string html = folder.path("r.html");
  const Json said = tool({"report", json, "-o", html, "--lang", "zh", "--json"}).json();
  EXPECT_EQ(said["reports"], Json::array({html}));
  EXPECT_EQ(said["language"], "zh");
}

TEST(Pdf, IsPrintedFromThePage) {
  const TemporaryFolder folder;
  const Browser browser(folder, printing(folder));
  const std::string pdf = folder.path("r.pdf");
  const ToolResult result = tool(fit_with({"--pdf", pdf, "--lang", "zh"}));
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(testing::read_bytes(pdf), "%PDF-1.7 of a test");
  EXPECT_THAT(testing::read_bytes(folder.path("seen.html")), HasSubstr("最佳拟合球"));
  // Beside a page: both.
  EXPECT_EQ(tool(fit_with({"--pdf", pdf, "--report", folder.path("r.html"), "--force"})).code, 0);
  EXPECT_TRUE(exists(folder.path("r.html")));
}

TEST(Pdf, WithoutABrowserIsRefusedBeforeTheWorkBegins) {
  const TemporaryFolder folder;
  setenv("ARMCAL_BROWSER", folder.path("none").c_str(), 1);
  const ToolResult result =
      tool(fit_with({"--pdf", folder.path("r.pdf"), "--report", folder.path("r.html")}));
  unsetenv("ARMCAL_BROWSER");
  EXPECT_EQ(result.code, 5);
  EXPECT_EQ(result.out, "");
  EXPECT_THAT(result.err,
              HasSubstr("ARMCAL_BROWSER names " + folder.path("none") + ", which is no program"));
  EXPECT_FALSE(exists(folder.path("r.html")));

  const std::string path = std::getenv("PATH");
  setenv("PATH", folder.path("").c_str(), 1);
  const ToolResult nowhere = tool(fit_with({"--pdf", folder.path("r.pdf")}));
  setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(nowhere.code, 5);
  EXPECT_THAT(nowhere.err, HasSubstr("no Chromium to print with: install it, or open the HTML"));
}

TEST(Pdf, TakesTheNameOfABrowserAndAFolderOfAnyName) {
  const TemporaryFolder folder;
  const Browser browser(folder, printing(folder));
  const std::string path = std::getenv("PATH");
  setenv("PATH", (folder.path("") + ":" + path).c_str(), 1);
  setenv("ARMCAL_BROWSER", "browser", 1);
  const std::string strange = folder.path("a #b%c?d");
  std::filesystem::create_directory(strange);
  setenv("TMPDIR", strange.c_str(), 1);
  const ToolResult result = tool(fit_with({"--pdf", folder.path("r.pdf")}));
  unsetenv("TMPDIR");
  setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_TRUE(exists(folder.path("r.pdf")));
  EXPECT_TRUE(std::filesystem::is_empty(strange));  // nothing stays behind
}

// Helpers of the browser outlived it, and kept its folder.
TEST(Pdf, LeavesNoProgramBehind) {
  const TemporaryFolder folder;
  const Browser browser(folder,
                        "sleep 300 &\necho $! > '" + folder.path("pid") + "'\n" + printing(folder));
  EXPECT_EQ(tool(fit_with({"--pdf", folder.path("r.pdf")})).code, 0);
  const int helper = std::stoi(testing::read_bytes(folder.path("pid")));
  for (int i = 0; i < 100 && kill(helper, 0) == 0; ++i) {
    // It may be waiting to be collected by init.
    const std::string state = testing::read_bytes("/proc/" + std::to_string(helper) + "/stat");
    if (state.find(") Z ") != std::string::npos) return;
    usleep(10'000);
  }
  EXPECT_NE(kill(helper, 0), 0);
}

TEST(Pdf, ThatFailsLosesNoResult) {
  const TemporaryFolder folder;
  const Browser browser(folder, "exit 3\n");
  const ToolResult result =
      tool(fit_with({"--json", "--pdf", folder.path("r.pdf"), "--report", folder.path("r.html")}));
  EXPECT_EQ(result.code, 5);
  EXPECT_EQ(result.json()["command"], "fit");  // one object: the result
  EXPECT_TRUE(exists(folder.path("r.html")));
}

TEST(Pdf, SaysWhatTheBrowserSaidWhereItFails) {
  const TemporaryFolder folder;
  const std::string pdf = folder.path("r.pdf");
  {
    const Browser browser(folder, "echo 'first' >&2\necho 'no display today' >&2\nexit 3\n");
    const ToolResult result = tool(fit_with({"--pdf", pdf}));
    EXPECT_EQ(result.code, 5);
    EXPECT_THAT(result.err, HasSubstr("did not print the report: no display today\n  help: write "
                                      "the report as HTML and print it from any browser"));
  }
  {
    const Browser browser(folder, "exit 3\n");
    EXPECT_THAT(
        tool(fit_with({"--pdf", pdf})).err,
        HasSubstr("did not print the report, and did not say why\n  help: write the report"));
  }
  {
    // It ends well and has printed something else.
    const Browser browser(folder,
                          "for word; do case $word in --print-to-pdf=*) echo no > ${word#*=};; "
                          "esac; done\n");
    EXPECT_EQ(tool(fit_with({"--pdf", pdf})).code, 5);
  }
  EXPECT_FALSE(exists(pdf));
}

TEST(Pdf, IsGivenUpWhenTheUserInterrupts) {
  const TemporaryFolder folder;
  const Browser browser(folder, "sleep 600\n");
  std::stop_source stop;
  stop.request_stop();
  const std::string json = folder.write("fit.json", tool(fit_with({"--json"})).out);
  const ToolResult result = tool({"report", json, "--pdf", folder.path("r.pdf")}, stop.get_token());
  EXPECT_EQ(result.code, 130);
  EXPECT_FALSE(exists(folder.path("r.pdf")));
}

}  // namespace
}  // namespace armcal::cli
