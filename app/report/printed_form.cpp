#include "app/report/printed_form.h"

#include "app/report/html.h"

namespace tactus::report {
namespace {

constexpr std::string_view kStyle = R"(
@page { size: A4; margin: 14mm; @bottom-right { content: counter(page) " / " counter(pages); } }
body { font: 11pt/1.35 Arial, "Noto Sans", "Noto Sans CJK TC", sans-serif; color: #1f2328; max-width: 190mm; margin: 10mm auto; }
h1 { font-size: 17pt; margin: 0 0 3mm; }
.code { margin: 6mm 0; }
.line { display: inline-block; width: 60mm; border-bottom: 1px solid #1f2328; }
table { width: 100%; border-collapse: collapse; margin: 0 0 6mm; break-inside: avoid; }
thead { display: table-header-group; }
th, td { padding: 1.6mm 1mm; border-bottom: 1px solid #d0d7de; vertical-align: top; text-align: left; }
th { font-size: 9pt; font-weight: 600; vertical-align: bottom; }
.number { width: 7mm; text-align: right; color: #57606a; }
.choice { width: 15mm; text-align: center; }
td.choice { font-size: 14pt; line-height: 1; }
tr { break-inside: avoid; }
.picture { break-inside: avoid; text-align: center; }
.picture svg { width: 80mm; height: 116mm; }
.ask { margin: 3mm 0; break-inside: avoid; }
.mark { white-space: nowrap; margin-right: 6mm; }
.opening { break-after: page; }
@media print { body { margin: 0; max-width: none; } }
)";

std::string cell(std::string_view tag, std::string_view kind, std::string_view text) {
  const std::string name(tag);
  return "<" + name + (kind.empty() ? "" : " class=\"" + std::string(kind) + "\"") + ">" + Markup(text).html() + "</" +
         name + ">";
}

std::string codeLine(const questionnaires::Survey& survey) {
  return Markup(survey.code_label).html() + ": <span class=\"line\">&#160;</span>";
}

std::string mark(std::string_view label) { return cell("span", "mark", "○ " + std::string(label)); }

/// Consent, profile, words and picture, on pages of their own.
std::string openingOf(const questionnaires::SurveyOpening& opening, std::string_view picture) {
  std::string html = "<section class=\"opening\">\n";
  if (!opening.consent.empty()) {
    html += cell("h2", "", opening.consent_title) + "<ul>\n";
    for (const std::string& line : opening.consent) html += cell("li", "", line) + "\n";
    html += "</ul>\n<p>" + mark(opening.agree) + "</p>\n";
  }
  html += cell("h2", "", opening.profile_title);
  for (const auto& question : opening.profile) {
    html += "<div class=\"ask\">" + cell("div", "", question.text);
    for (const auto& offer : question.offers) html += mark(offer.label);
    html += "</div>\n";
  }
  html += cell("h2", "", opening.picture) + "<ul>\n";
  for (const std::string& line : opening.glossary) html += cell("li", "", line) + "\n";
  html += "</ul>\n";
  if (!picture.empty()) html += "<div class=\"picture\">" + std::string(picture) + "</div>\n";
  return html + "</section>\n";
}

/// One table with a head, which a printer repeats on each page.
std::string tableOf(const questionnaires::Survey& survey, const questionnaires::SurveyMatrix& matrix) {
  std::string html = "<table>\n<thead><tr>";
  html += survey.opening ? "<th colspan=\"2\">" + codeLine(survey) + "</th>" : "<th></th><th></th>";
  for (const auto& choice : survey.choices) html += cell("th", "choice", choice.label);
  html += "</tr></thead>\n<tbody>\n";
  for (const auto& field : matrix.fields) {
    html += "<tr>" + cell("td", "number", std::to_string(field.item)) + cell("td", "", field.text);
    for (std::size_t k = 0; k < survey.choices.size(); ++k) html += cell("td", "choice", "☐");
    html += "</tr>\n";
  }
  return html + "</tbody>\n</table>\n";
}

}  // namespace

std::string printedForm(const questionnaires::Survey& survey, std::string_view picture) {
  const std::string title = Markup(survey.title).html();
  std::string html = "<!DOCTYPE html>\n<html lang=\"" + Markup(survey.language).html() +
                     "\" xmlns=\"http://www.w3.org/1999/xhtml\">\n<head>\n<meta charset=\"utf-8\"/>\n<title>" + title +
                     "</title>\n<style>" + std::string(kStyle) + "</style>\n</head>\n<body>\n<h1>" + title + "</h1>\n";
  if (!survey.instructions.empty()) html += "<p>" + Markup(survey.instructions).html() + "</p>\n";
  html += "<p class=\"code\">" + codeLine(survey) + "</p>\n";
  if (survey.opening) html += openingOf(*survey.opening, picture);
  for (const auto& matrix : survey.matrices) html += tableOf(survey, matrix);
  return html + "</body>\n</html>\n";
}

}  // namespace tactus::report
