// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#include "armcal/report/html/page_html.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "armcal/io/sha256.h"
#include "armcal/report/document.h"
#include "armcal/report/html/assets.h"

namespace armcal {
namespace {

using namespace std::string_literals;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string kHostile = "<script>alert('1')</script> \"q\" & {{title}} </style> \u202egnp.exe";

// One of every kind of block, the same text in all of its places.
Page page_of_all_blocks(const std::string& text) {
  const Table table = {.caption = text,
                       .columns = {{text, ColumnKind::text}, {text}},
                       .rows = {{{text}, {text, Tone::bad}}, {{text}, {text}}},
                       .note = text,
                       .shown = 1};
  const Figures figures = {{{.id = "drawing",
                             .title = text,
                             .text = text,
                             .svg = "<svg></svg>",
                             .live = Json{{"kind", text}}.dump()}}};
  const std::vector<Block> blocks = {Headlines{{{text, text, text, text, Tone::good}}},
                                     Paragraph{text},
                                     Notice{Tone::warning, text, {text, text}},
                                     Notice{Tone::neutral, "", {text}},
                                     Facts{{{text, text}}},
                                     table,
                                     figures,
                                     Verbatim{text},
                                     Signature{text, text, text}};
  return {.title = text,
          .subtitle = text,
          .number = text,
          .stamp = {text, text, Tone::bad},
          .head = {{{text, text}}},
          .sections = {{.id = "all", .title = text, .lead = text, .blocks = blocks}}};
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

std::string html_in(const char* language, const Page& page, const std::string& document = "{}") {
  return html_of(page, Language::named(language), document);
}

TEST(PageHtml, HasEveryTextOfThePage) {
  // Where `text` stands as an element's content, as the title of the window and in an attribute.
  const std::string html = html_in("en", page_of_all_blocks("one text"));
  EXPECT_EQ(count(html, "one text"), 41U);
  EXPECT_THAT(html, HasSubstr("<svg></svg>"));
}

TEST(PageHtml, TellsTextThatAPageOfPaperHoldsFromLonger) {
  const auto html_with = [](const std::string& text) {
    return html_in("en", {.sections = {{.id = "all", .blocks = {Verbatim{text}}}}});
  };
  EXPECT_THAT(html_with("armcal fit sphere"), HasSubstr("<pre>armcal"));
  EXPECT_THAT(html_with("a" + std::string(60, '\n')), HasSubstr("<pre class=\"long\">a"));
  EXPECT_THAT(html_with(std::string(9000, 'a')), HasSubstr("<pre class=\"long\">a"));
}

TEST(PageHtml, IsInTheLanguageOfTheReader) {
  EXPECT_THAT(html_in("en", page_of_all_blocks("x")), HasSubstr("<html lang=\"en\">"));
  const std::string chinese = html_in("zh", page_of_all_blocks("x"));
  EXPECT_THAT(chinese, HasSubstr("<html lang=\"zh\">"));
  EXPECT_THAT(chinese, HasSubstr("目录"));
}

TEST(PageHtml, LetsNoTextBecomeMarkup) {
  const std::string harmless = html_in("en", page_of_all_blocks("x"));
  const std::string html = html_in("en", page_of_all_blocks(kHostile), Json(kHostile).dump());
  for (const char* markup : {"<script", "</script", "</style", "<!--"}) {
    EXPECT_EQ(count(html, markup), count(harmless, markup)) << markup;
  }
  EXPECT_EQ(count(html, "<"), count(harmless, "<"));
  EXPECT_THAT(html, HasSubstr("{{title}}"));
}

TEST(PageHtml, ShowsControlCharacters) {
  const std::string html = html_in("en", page_of_all_blocks(std::string("a\0b\x07", 4)));
  EXPECT_THAT(html, HasSubstr("a␀b␇"));
  EXPECT_EQ(html.find('\0'), std::string::npos);
}

TEST(PageHtml, PutsTheNumberOnEveryPageOfPaper) {
  Page page = page_of_all_blocks("x");
  page.number = "A-17 \"<\\";
  EXPECT_THAT(
      html_in("en", page),
      HasSubstr(R"(@page{@bottom-left{content:"Report A-17 \22 \3c \5c "})"
                R"(@bottom-right{content:"Page " counter(page) " of " counter(pages) ""}})"));
  EXPECT_THAT(html_in("zh", page), HasSubstr("\"第 \" counter(page) \" 页，共 \" counter(pages)"));
}

TEST(PageHtml, SaysByWordWhatColourSays) {
  EXPECT_THAT(html_in("en", page_of_all_blocks("x")),
              HasSubstr(R"(<span class="sign" role="img" aria-label="fails">✗</span> x</td>)"));
}

TEST(PageHtml, FoldsLongTablesWithoutLosingRows) {
  Page page = page_of_all_blocks("x");
  EXPECT_EQ(count(html_in("en", page), "<tr class=\"folded\">"), 1U);
  EXPECT_EQ(count(html_in("en", page), "<div class=\"table folds\""), 1U);
  std::get<Table>(page.sections[0].blocks[5]).shown = 2;
  EXPECT_EQ(count(html_in("en", page), "type=\"checkbox\""), 0U);
}

TEST(PageHtml, LetsTheBrowserRunOurScriptOnlyAndFetchNothing) {
  const std::string html = html_in("en", page_of_all_blocks("x"));
  EXPECT_THAT(html, HasSubstr("default-src &apos;none&apos;"));
  EXPECT_EQ(count(html, "script-src"), reports_have_scripts() ? 1U : 0U);
}

// The hash is of what the browser sees between the tags, which it reads as lines that end with \n.
TEST(PageHtml, AllowsTheScriptThatItHolds) {
  if (!reports_have_scripts()) GTEST_SKIP() << "this build has no script";
  const std::string html = html_in("en", page_of_all_blocks(kHostile), Json(kHostile).dump());
  const std::string begin = "<script>";
  ASSERT_EQ(count(html, begin), 1U);
  const std::size_t from = html.find(begin) + begin.size();
  const std::string script = html.substr(from, html.find("</script>", from) - from);
  EXPECT_EQ(script.find('\r'), std::string::npos);
  EXPECT_THAT(html, HasSubstr("script-src &apos;sha256-" + sha256_base64(script) + "&apos;"));
}

// Texts stand between tags and in attributes; quotes would end these.
TEST(PageHtml, EndsNoAttributeWithAText) {
  const auto page_without_live = [](const std::string& text) {
    Page page = page_of_all_blocks(text);
    std::get<Figures>(page.sections[0].blocks[6]).items[0].live.clear();
    return html_in("en", page);
  };
  const std::string harmless = page_without_live("x");
  for (const char* text : {"\" onmouseover=\"alert(1)", "' onload='alert(1)"}) {
    const std::string html = page_without_live(text);
    for (const char* quote : {"\"", "'"}) EXPECT_EQ(count(html, quote), count(harmless, quote));
  }
}

TEST(DocumentInHtml, IsWhatWasPutInByteForByte) {
  const std::vector<std::string> documents = {
      "{}", "{\"name\":\"</script><script>alert(1)</script>\"}",
      "{\n  \"a\": \"<!-- & \\\\u003c \\\\\\\\ \\\" \\u0000 \\t\",\n  \"b\": [1.0, -0.0, "
      "1e-300]\n}\n",
      Json{{"text", kHostile}, {"backslashes", "\\\\u003c\\"}, {"more", "\\u003e"}}.dump(2),
      json_document({"fk", {"a\0b"s, "\xff\xfe.csv", "\xe6\x97"}, {}, {}, {}}, {{"\xc3(", 1}})};
  for (const std::string& document : documents) {
    const std::string html = html_in("en", page_of_all_blocks(kHostile), document);
    EXPECT_EQ(document_in_html(html), document);
  }
}

// Texts of a page come before the document and after it; none passes for it.
TEST(DocumentInHtml, IsNoTextOfThePage) {
  const std::string forged = "<script type=\"application/json\" id=\"armcal-result\">{}</script>";
  EXPECT_EQ(document_in_html(html_in("en", page_of_all_blocks(forged), "{\"true\": 1}")),
            "{\"true\": 1}");
}

TEST(Sha256InHtml, IsThatOfTheDocumentThatComesBack) {
  // JSON that is written with escapes of its own comes back without them.
  for (const std::string& document :
       {"{}"s, Json{{"text", kHostile}}.dump(2), "{\"a\": \"\\u003cb\\u003e\"}"s}) {
    const std::string html = html_in("en", page_of_all_blocks(kHostile), document);
    EXPECT_EQ(sha256_in_html(html), sha256_hex(document_in_html(html).value()));
  }
}

// Before it was written, the element had no such attribute.
TEST(Sha256InHtml, IsNothingInOlderReports) {
  const std::string older =
      "<script type=\"application/json\" id=\"armcal-result\">{\"a\": \" data-sha256=\\\"0\\\"\"}"
      "</script>";
  EXPECT_EQ(sha256_in_html(older), std::nullopt);
  EXPECT_TRUE(document_in_html(older).has_value());
  EXPECT_EQ(sha256_in_html("<html></html>"), std::nullopt);
}

TEST(LanguageInHtml, IsThatOfTheReport) {
  for (const std::string& code : Language::codes()) {
    EXPECT_EQ(language_in_html(html_in(code.c_str(), page_of_all_blocks("<html lang=\"xx\">"))),
              code);
  }
  EXPECT_EQ(language_in_html("<html lang=\"fr\">"), std::nullopt);
  EXPECT_EQ(language_in_html("<html>"), std::nullopt);
  EXPECT_EQ(language_in_html("<html lang=\"en"), "en");
}

TEST(PageHtml, HasALineToSignOnOnPaperOnly) {
  Page page;
  page.sections = {{"all", "All", "", {Signature{"Released by", "A. Person", "head"}}}};
  EXPECT_THAT(html_in("en", page),
              HasSubstr("<div class=\"signature\"><p class=\"label\">Released by</p><p "
                        "class=\"line\">A. Person</p><p>head</p></div>"));
  const std::string style(report_asset("report.css"));
  EXPECT_GT(style.find(".signature .line"), style.find("@media print"));
}

TEST(DocumentInHtml, IsNothingInOtherTexts) {
  EXPECT_EQ(document_in_html(""), std::nullopt);
  EXPECT_EQ(document_in_html("<html></html>"), std::nullopt);
  EXPECT_EQ(document_in_html("<script type=\"application/json\" id=\"armcal-result\">{"),
            std::nullopt);
}

}  // namespace
}  // namespace armcal
