#include "app/report/html.h"

#include <algorithm>
#include <cctype>

#include "app/report/html_style.h"
#include "core/base/check.h"

namespace tactus::report {

namespace {

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

void HtmlPage::section(std::string_view title) {
  const std::string anchor = anchorFor(title);
  contents_ += "<li><a href=\"#" + anchor + "\">" + base::xmlEscaped(title) + "</a></li>\n";
  body_ += "<h2 id=\"" + anchor + "\">" + base::xmlEscaped(title) + "</h2>\n";
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
  out += "<title>" + base::xmlEscaped(title_) + "</title>\n<style>\n";
  out += kStyleSheet;
  out += "</style>\n</head>\n<body>\n<header>\n<h1>" + base::xmlEscaped(title_) + "</h1>\n<p class=\"subtitle\">" +
         subtitle_.html() + "</p>\n</header>\n";
  out += "<div class=\"page\">\n<nav aria-label=\"Contents\">\n<div class=\"nav-title\">Contents</div>\n<ol>\n" +
         contents_ + "</ol>\n</nav>\n<main>\n" + body_ + "</main>\n</div>\n</body>\n</html>\n";
  return out;
}

}  // namespace tactus::report
