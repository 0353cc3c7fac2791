#include "app/report/html.h"

#include <algorithm>
#include <cctype>
#include <string_view>

#include "core/base/check.h"

namespace tactus::report {
namespace {

/// Name of the badge's style in the page's style sheet.
std::string_view cssClass(Badge badge) noexcept {
  switch (badge) {
    case Badge::kPublished: return "published";
    case Badge::kSimulated: return "simulated";
    case Badge::kComputed: return "computed";
    case Badge::kByConstruction: return "construction";
    case Badge::kYes: return "yes";
    case Badge::kNo: return "no";
    case Badge::kNotApplicable: return "none";
  }
  return "none";
}

}  // namespace

std::string_view name(Badge badge) noexcept {
  switch (badge) {
    case Badge::kPublished: return "published";
    case Badge::kSimulated: return "simulated";
    case Badge::kComputed: return "computed";
    case Badge::kByConstruction: return "by construction";
    case Badge::kYes: return "yes";
    case Badge::kNo: return "no";
    case Badge::kNotApplicable: return "not asked";
  }
  return "";
}

Markup badge(Badge badge) {
  std::string html = "<span class=\"badge ";
  html += cssClass(badge);
  html += "\">";
  html += name(badge);
  html += "</span>";
  return Markup::raw(std::move(html));
}

Markup badges(std::initializer_list<Badge> list) {
  Markup out;
  for (const Badge each : list) {
    if (!out.empty()) out += " ";
    out += badge(each);
  }
  return out;
}

Markup strong(const Markup& text) { return Markup::raw("<strong>" + text.html() + "</strong>"); }

Markup muted(const Markup& text) { return Markup::raw("<span class=\"muted\">" + text.html() + "</span>"); }

namespace {

// The style sheet of the report, for screen and paper. Colors as in palette.h.

// It has no XML special characters (<, &), so the page stays well-formed without escaping.
inline constexpr std::string_view kStyleSheet = R"css(
:root { --ink: #1b1f24; --muted: #57606a; --line: #d5dbe1; --soft: #f6f8fa; --accent: #0b5394; }
* { box-sizing: border-box; }
html { scroll-padding-top: 16px; }
body { margin: 0; color: var(--ink); background: #fff; font: 16px/1.55 "Segoe UI", "Helvetica Neue", Arial, "Liberation Sans", sans-serif; }
header { background: #12324f; color: #fff; padding: 30px max(28px, calc((100% - 1212px) / 2)) 26px; }
header h1 { margin: 0; font-size: 30px; line-height: 1.25; font-weight: 600; }
header .subtitle { margin: 8px 0 0; color: #d3e0ec; max-width: 80ch; }
.page { display: grid; grid-template-columns: 214px minmax(0, 1fr); gap: 44px; max-width: 1268px; margin: 0 auto; padding: 28px 28px 64px; }
nav { position: sticky; top: 20px; align-self: start; max-height: calc(100vh - 40px); overflow: auto; font-size: 14px; line-height: 1.35; }
.nav-title { font-weight: 600; margin-bottom: 6px; }
nav ol { list-style: none; margin: 0; padding: 0; border-left: 2px solid var(--line); counter-reset: entry; }
nav li::before { counter-increment: entry; content: counter(entry) ". "; color: var(--muted); }
main { counter-reset: section; }
main h2::before { counter-increment: section; content: counter(section) ". "; }
nav li { padding: 4px 0 4px 14px; }
a { color: var(--accent); }
nav a { text-decoration: none; }
nav a:hover { text-decoration: underline; }
h2 { font-size: 23px; line-height: 1.3; font-weight: 600; margin: 52px 0 12px; padding-top: 14px; border-top: 2px solid var(--line); }
main > h2:first-child { margin-top: 0; padding-top: 0; border-top: 0; }
h3 { font-size: 18px; font-weight: 600; margin: 34px 0 8px; }
p, ul { margin: 0 0 14px; max-width: 84ch; }
ul { padding-left: 22px; }
li { margin-bottom: 5px; }
nav li { margin-bottom: 0; }
.muted { color: var(--muted); }
.notice { border: 1px solid #e3b778; border-left: 5px solid #d9822b; background: #fff8ee; padding: 12px 16px; margin: 0 0 20px; border-radius: 4px; }
.key-numbers { display: grid; grid-template-columns: repeat(4, 1fr); gap: 12px; margin: 4px 0 22px; }
.key-numbers > div { border: 1px solid var(--line); border-radius: 6px; padding: 12px 14px; }
.key-numbers .value { font-size: 22px; font-weight: 600; line-height: 1.25; font-variant-numeric: tabular-nums; }
.key-numbers .what { font-size: 14px; line-height: 1.4; color: var(--muted); margin-top: 3px; }
.badge { display: inline-block; font-size: 12px; line-height: 17px; font-weight: 600; padding: 0 7px; border-radius: 9px; border: 1px solid; white-space: nowrap; vertical-align: 1px; }
.badge.simulated { color: #8a4b00; background: #fff1dc; border-color: #e7b36a; }
.badge.published { color: #0b4a7d; background: #e6f1fb; border-color: #8fbfe6; }
.badge.computed { color: #0f5c46; background: #e4f5ef; border-color: #82c9b1; }
.badge.construction { color: #6b3462; background: #f8eaf4; border-color: #d6a3c8; }
.badge.yes { color: #fff; background: #1a7f5a; border-color: #1a7f5a; }
.badge.no { color: #fff; background: #b0413e; border-color: #b0413e; }
.badge.none { color: var(--muted); background: #fff; border-color: #b6bec7; }
.table { margin: 18px 0 26px; overflow-x: auto; }
table { border-collapse: collapse; min-width: 60%; font-size: 14.5px; line-height: 1.4; }
.table.wide table { width: 100%; }
.caption-number { font-weight: 600; }
caption { text-align: left; font-size: 14.5px; padding-bottom: 8px; line-height: 1.5; }
th, td { padding: 5px 10px; text-align: left; vertical-align: top; border-bottom: 1px solid var(--line); }
thead th { border-bottom: 1px solid var(--line); font-weight: 600; vertical-align: bottom; }
thead tr:last-child th { border-bottom: 1.5px solid #8b949e; }
thead tr + tr th.number { font-weight: 400; color: var(--muted); }
thead th.number { white-space: normal; }
thead th.span { text-align: center; }
thead th.blank { border-bottom: 0; }
tbody th { font-weight: 600; }
tbody td.span { background: var(--soft); }
.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
.group { border-left: 1px solid #b6bec7; }
.note { font-size: 14px; color: var(--muted); margin: 8px 0 0; }
figure { margin: 22px 0 30px; }
.panels { display: grid; gap: 18px 20px; }
.panels.columns-2 { grid-template-columns: repeat(2, minmax(0, 1fr)); }
.panels.columns-3 { grid-template-columns: repeat(3, minmax(0, 1fr)); }
.panel-heading { font-size: 14.5px; line-height: 1.45; font-weight: 600; margin-bottom: 4px; }
.panel-heading .muted { font-weight: 400; margin-left: 4px; }
.panel svg { display: block; width: 100%; height: auto; }
figcaption { font-size: 14.5px; line-height: 1.5; margin-top: 8px; max-width: 96ch; }
@media (min-width: 1700px) {
  body { font-size: 17px; }
  header { padding-left: max(28px, calc((100% - 1444px) / 2)); padding-right: max(28px, calc((100% - 1444px) / 2)); }
  .page { max-width: 1500px; grid-template-columns: 250px minmax(0, 1fr); }
  nav, .note, .key-numbers .what { font-size: 15px; }
  table, caption, figcaption, .panel-heading { font-size: 15.5px; }
}
@media (max-width: 1000px) {
  .page { display: block; }
  nav { position: static; margin-bottom: 28px; max-height: none; }
  .key-numbers { grid-template-columns: repeat(2, 1fr); }
  .panels.columns-2, .panels.columns-3 { grid-template-columns: 1fr; }
}
@media print {
  .screen-only { display: none; }
  @page { size: A4; margin: 16mm 15mm 18mm; @bottom-center { content: counter(page) " of " counter(pages); font: 9pt Arial, sans-serif; color: #57606a; } }
  body { font-size: 10.5pt; -webkit-print-color-adjust: exact; print-color-adjust: exact; }
  header { background: none; color: var(--ink); padding: 0 0 8px; border-bottom: 2px solid var(--line); }
  header .subtitle { color: var(--muted); }
  .page { display: block; padding: 12px 0 0; max-width: none; }
  nav { position: static; max-height: none; margin-bottom: 18px; columns: 2; }
  .key-numbers { grid-template-columns: repeat(4, 1fr); }
  .panels.columns-2 { grid-template-columns: repeat(2, minmax(0, 1fr)); }
  .panels.columns-3 { grid-template-columns: repeat(3, minmax(0, 1fr)); }
  h2, h3 { break-after: avoid; }
  h2 { margin-top: 26px; }
  .panel, .key-numbers, .notice, tr, figure:not(.long), .table:not(.wide):not(.tall) { break-inside: avoid; }
  .panel svg { max-height: 225mm; }
  thead { display: table-header-group; }
  figcaption { break-before: avoid; }
  .key-numbers .value { font-size: 14pt; }
  .key-numbers .what { font-size: 9pt; }
  .table { overflow: visible; }
  table, caption, figcaption { font-size: 9pt; }
  th, td { padding: 3px 6px; }
  a { color: inherit; text-decoration: none; }
}
)css";

void appendRow(std::string& out, const std::vector<Cell>& row, bool head) {
  out += "<tr>";
  for (const Cell& cell : row) {
    const bool th = head || cell.heading;
    out += th ? "<th" : "<td";
    if (th) out += head ? " scope=\"col\"" : " scope=\"row\"";
    if (cell.columns > 1) out += " colspan=\"" + std::to_string(cell.columns) + '"';
    std::string classes;
    if (cell.number) classes += "number ";
    if (cell.group_start) classes += "group ";
    if (cell.columns > 1) classes += "span ";
    if (head && cell.text.empty()) classes += "blank ";
    if (!classes.empty()) {
      classes.pop_back();
      out += " class=\"" + classes + '"';
    }
    out += '>' + cell.text.html() + (th ? "</th>" : "</td>");
  }
  out += "</tr>\n";
}

}  // namespace

Cell numberCell(Markup text, bool group_start) {
  return {.text = std::move(text), .number = true, .group_start = group_start};
}

Cell headingCell(Markup text) { return {.text = std::move(text), .heading = true}; }

HtmlPage::HtmlPage(std::string title, Markup subtitle) : title_(std::move(title)), subtitle_(std::move(subtitle)) {}

std::string HtmlPage::anchorFor(std::string_view title) {
  std::string base;
  for (const char c : title) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 && static_cast<unsigned char>(c) < 0x80) {
      base += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    } else if (!base.empty() && base.back() != '-') {
      base += '-';
    }
  }
  while (!base.empty() && base.back() == '-') base.pop_back();
  if (base.empty()) base = "section";
  std::string anchor = base;
  for (int number = 2; std::find(anchors_.begin(), anchors_.end(), anchor) != anchors_.end(); ++number) {
    anchor = base + '-' + std::to_string(number);
  }
  anchors_.push_back(anchor);
  return anchor;
}

std::string HtmlPage::numberText(std::string_view kind, int& count) {
  if (!numbered_) return {};
  return "<span class=\"caption-number\">" + std::string(kind) + ' ' + std::to_string(++count) + ".</span> ";
}

void HtmlPage::startSection(std::string_view title, std::string_view attributes) {
  const std::string anchor = anchorFor(title);
  contents_ +=
      "<li" + std::string(attributes) + "><a href=\"#" + anchor + "\">" + base::xmlEscaped(title) + "</a></li>\n";
  body_ += "<h2 id=\"" + anchor + '"' + std::string(attributes) + '>' + base::xmlEscaped(title) + "</h2>\n";
}

void HtmlPage::section(std::string_view title) { startSection(title, ""); }

void HtmlPage::screenSection(std::string_view title, const Markup& content) {
  startSection(title, " class=\"screen-only\"");
  body_ += "<div class=\"screen-only\">" + content.html() + "</div>\n";
}

void HtmlPage::subsection(std::string_view title) {
  body_ += "<h3 id=\"" + anchorFor(title) + "\">" + base::xmlEscaped(title) + "</h3>\n";
}

void HtmlPage::paragraph(const Markup& text) { body_ += "<p>" + text.html() + "</p>\n"; }

void HtmlPage::list(const std::vector<Markup>& items) {
  body_ += "<ul>\n";
  for (const Markup& item : items) body_ += "<li>" + item.html() + "</li>\n";
  body_ += "</ul>\n";
}

void HtmlPage::notice(const Markup& text) { body_ += "<div class=\"notice\">" + text.html() + "</div>\n"; }

void HtmlPage::keyNumbers(const std::vector<std::pair<Markup, Markup>>& numbers) {
  body_ += "<div class=\"key-numbers\">\n";
  for (const auto& [value, explanation] : numbers) {
    body_ += "<div><div class=\"value\">" + value.html() + "</div><div class=\"what\">" + explanation.html() +
             "</div></div>\n";
  }
  body_ += "</div>\n";
}

void HtmlPage::table(const Table& table) {
  const auto width = [](const std::vector<Cell>& row) {
    int columns = 0;
    for (const Cell& cell : row) columns += cell.columns;
    return columns;
  };
  // A table that fills a page by itself may be torn; its head is repeated.
  constexpr std::size_t kRowsOfAPage = 30;
  const std::string tall = table.body.size() > kRowsOfAPage ? " tall" : "";
  body_ += (table.wide ? "<div class=\"table wide" : "<div class=\"table") + tall + "\"><table>\n";
  body_ += "<caption>" + numberText("Table", tables_) + table.caption.html() + "</caption>\n<thead>\n";
  for (const auto& row : table.head) {
    TACTUS_CHECK(width(row) == width(table.head.front()));
    appendRow(body_, row, true);
  }
  body_ += "</thead>\n<tbody>\n";
  for (const auto& row : table.body) {
    TACTUS_CHECK(width(row) == width(table.head.front()));
    appendRow(body_, row, false);
  }
  body_ += "</tbody>\n</table>\n";
  if (!table.note.empty()) body_ += "<p class=\"note\">" + table.note.html() + "</p>\n";
  body_ += "</div>\n";
}

void HtmlPage::figure(const Figure& figure) {
  TACTUS_CHECK(figure.columns >= 1 && figure.columns <= 3);
  body_ += figure.panels.size() > 2 ? "<figure class=\"long\">\n" : "<figure>\n";
  body_ += "<div class=\"panels columns-" + std::to_string(figure.columns) + "\">\n";
  for (const Panel& panel : figure.panels) {
    body_ += "<div class=\"panel\">";
    if (!panel.heading.empty()) body_ += "<div class=\"panel-heading\">" + panel.heading.html() + "</div>";
    body_ += panel.svg + "</div>\n";
  }
  body_ +=
      "</div>\n<figcaption>" + numberText("Figure", figures_) + figure.caption.html() + "</figcaption>\n</figure>\n";
}

std::string HtmlPage::html() const {
  std::string out = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n";
  out += "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n";
  out +=
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; "
      "script-src 'unsafe-inline'; img-src data:; base-uri 'none'; form-action 'none'\"/>\n";
  out += "<title>" + base::xmlEscaped(title_) + "</title>\n<style>\n";
  out += kStyleSheet;
  out += style_ + "</style>\n</head>\n<body>\n<header>\n<h1>" + base::xmlEscaped(title_) +
         "</h1>\n<p class=\"subtitle\">" + subtitle_.html() + "</p>\n</header>\n";
  out += "<div class=\"page\">\n<nav aria-label=\"Contents\">\n<div class=\"nav-title\">Contents</div>\n<ol>\n" +
         contents_ + "</ol>\n</nav>\n<main>\n" + body_ + "</main>\n</div>\n</body>\n</html>\n";
  return out;
}

}  // namespace tactus::report
