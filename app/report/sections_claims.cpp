#include "app/report/report_sections.h"

namespace tactus::report {

namespace {

Markup basisBadges(const Verdict& verdict) {
  switch (verdict.basis) {
    case ClaimBasis::kPublishedRules: return badge(Badge::kPublished);
    case ClaimBasis::kSimulated: return badge(Badge::kSimulated);
    case ClaimBasis::kByConstruction: return badge(Badge::kByConstruction);
  }
  return {};
}

Markup verdictBadge(const Verdict& verdict) {
  if (!verdict.holds) return badge(Badge::kNotApplicable);
  return badge(*verdict.holds ? Badge::kYes : Badge::kNo);
}

/// The subject's name, kept on one line.
Markup subjectName(const std::string& subject) {
  std::string text;
  for (const char c : subject) text += c == ' ' ? std::string("\xC2\xA0") : std::string(1, c);
  return strong(text);
}

}  // namespace

void addVerdicts(HtmlPage& page, const ReportContext& context) {
  const std::string& published = context.demo->published_expert;
  Table table{
      .caption = strong("Does the model say what the paper says?") + " " + badge(Badge::kComputed) + " " + published +
                 "’s rules are published, so that column is a test. The mean holds three simulated nurses "
                 "who were made to follow the paper’s text: a yes there shows only that the chain works. "
                 "Numbers and reasons: " +
                 Markup::raw("<a href=\"#what-the-paper-says-checked\">What the paper says, checked</a>."),
      .head = {{{.text = "Statement of the paper"}, {.text = published + " alone"}, {.text = "Mean, or all experts"}}},
      .body = {},
      .wide = true};
  for (const Claim& claim : context.claims) {
    Markup alone = muted("–");
    Markup together = muted("–");
    for (const Verdict& verdict : claim.verdicts) {
      if (verdict.subject == published) alone = verdictBadge(verdict);
      if (verdict.subject == "mean" || verdict.subject == "all experts") together = verdictBadge(verdict);
    }
    table.body.push_back({{.text = claim.id + ". " + claim.statement}, {.text = alone}, {.text = together}});
  }
  page.table(table);
}

void addClaims(HtmlPage& page, const ReportContext& context) {
  page.section("What the paper says, checked");
  page.paragraph(
      "Each statement of the paper about its Fig. 10 and Fig. 11, computed from the models of this report. " +
      badge(Badge::kPublished) + " marks the expert whose rules are printed: a real test of the statement. " +
      badge(Badge::kSimulated) + " and " + badge(Badge::kByConstruction) +
      " mark results in which nurses take part who were simulated to follow the very same text: a yes there shows that "
      "the chain works, not that the statement is true.");
  Table table{.caption = strong("Claims checklist.") + " " + badge(Badge::kComputed),
              .head = {{{.text = "Data"}, {.text = "For"}, {.text = "Holds"}, {.text = "Numbers"}}},
              .body = {},
              .wide = true};
  for (const Claim& claim : context.claims) {
    table.body.push_back({{.text = strong(claim.id + ". " + claim.statement) + " " + muted(claim.rule), .columns = 4}});
    std::string last_reason;
    for (const Verdict& verdict : claim.verdicts) {
      Markup numbers = verdict.numbers;
      if (!verdict.reason.empty()) {
        numbers += Markup(verdict.numbers.empty() ? "" : " ") + strong("Why:") + " " +
                   (verdict.reason == last_reason ? "the same reason." : verdict.reason);
        last_reason = verdict.reason;
      }
      table.body.push_back({{.text = basisBadges(verdict)},
                            {.text = subjectName(verdict.subject)},
                            {.text = verdictBadge(verdict)},
                            {.text = numbers}});
    }
  }
  page.table(table);
}

}  // namespace tactus::report
