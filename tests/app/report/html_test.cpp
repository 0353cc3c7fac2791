#include "app/report/html.h"

#include <gtest/gtest.h>

#include "tests/support/well_formed.h"

namespace tactus::report {
namespace {

TEST(HtmlPage, IsWellFormedAndSelfContained) {
  HtmlPage page("A & B", "sub < title");
  page.section("First");
  page.paragraph("1 < 2");
  page.list({"one", strong("two")});
  page.notice(badge(Badge::kSimulated));
  page.keyNumbers({{"4", "experts"}});
  page.table({.caption = "Table",
              .head = {{{.text = "a"}, {.text = "b", .columns = 2}}},
              .body = {{headingCell("x"), numberCell("1"), numberCell("2", true)}},
              .note = "note"});
  page.figure({.caption = "Figure", .panels = {{.heading = "(a)", .svg = "<svg></svg>"}}, .columns = 2});
  const std::string html = page.html();
  EXPECT_EQ(support::markupFault(html), "");
  EXPECT_EQ(html.find("<script"), std::string::npos);
  EXPECT_EQ(html.find("://"), std::string::npos);
  EXPECT_NE(html.find("default-src 'none'"), std::string::npos);
  EXPECT_EQ(html.find("url("), std::string::npos);
  EXPECT_NE(html.find("<title>A &amp; B</title>"), std::string::npos);
  EXPECT_NE(html.find("@media print"), std::string::npos);
}

TEST(HtmlPage, NumbersItsCaptionsOnRequest) {
  const Table table{.caption = "A", .head = {{{.text = "a"}}}, .body = {}};
  const Figure figure{.caption = "B", .panels = {{.svg = "<svg></svg>"}}};
  HtmlPage page("Page", "");
  page.table(table);
  page.numberCaptions();
  page.table(table);
  page.figure(figure);
  page.table(table);
  const std::string html = page.html();
  EXPECT_NE(html.find("<caption>A</caption>"), std::string::npos);
  EXPECT_NE(html.find("<caption><span class=\"caption-number\">Table 1.</span> A</caption>"), std::string::npos);
  EXPECT_NE(html.find("<caption><span class=\"caption-number\">Table 2.</span> A</caption>"), std::string::npos);
  EXPECT_NE(html.find("<figcaption><span class=\"caption-number\">Figure 1.</span> B"), std::string::npos);
}

// A short table or figure stays on one page; a table longer than a page may be torn.
TEST(HtmlPage, OnPaperOnlyLongTablesAreTorn) {
  Table table{.caption = "A", .head = {{{.text = "a"}}}, .body = {}};
  HtmlPage page("Page", "");
  page.table(table);
  for (int i = 0; i < 40; ++i) table.body.push_back({{.text = "x"}});
  page.table(table);
  const std::string html = page.html();
  EXPECT_NE(html.find("<div class=\"table\"><table>"), std::string::npos);
  EXPECT_NE(html.find("<div class=\"table tall\"><table>"), std::string::npos);
  EXPECT_NE(html.find("counter(page)"), std::string::npos);
}

TEST(HtmlPage, SectionsAreInTheContentsUnderAnchorsOfTheirOwn) {
  HtmlPage page("Page", "");
  page.section("Speed, clusters & terms");
  page.section("Speed, clusters & terms");
  const std::string html = page.html();
  EXPECT_NE(html.find("<a href=\"#speed-clusters-terms\">Speed, clusters &amp; terms</a>"), std::string::npos);
  EXPECT_NE(html.find("<h2 id=\"speed-clusters-terms\">"), std::string::npos);
  EXPECT_NE(html.find("<a href=\"#speed-clusters-terms-2\">"), std::string::npos);
  EXPECT_NE(html.find("<h2 id=\"speed-clusters-terms-2\">"), std::string::npos);
}

}  // namespace
}  // namespace tactus::report
