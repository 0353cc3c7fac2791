#include <algorithm>
#include <set>

#include "app/report/report_sections.h"
#include "core/analysis/force_difference.h"
#include "core/base/text.h"

namespace tactus::report {

namespace {

/// How many of the claims were tried on `subject` and how many hold.
std::pair<int, int> verdictsOf(const std::vector<Claim>& claims, std::string_view subject) {
  int tried = 0;
  int hold = 0;
  for (const Claim& claim : claims) {
    for (const Verdict& verdict : claim.verdicts) {
      if (verdict.subject != subject || !verdict.holds) continue;
      ++tried;
      hold += *verdict.holds ? 1 : 0;
    }
  }
  return {hold, tried};
}

std::string outOf(std::pair<int, int> count) {
  return std::to_string(count.first) + " of " + std::to_string(count.second);
}

}  // namespace

void addOverview(HtmlPage& page, const ReportContext& context) {
  page.section("At a glance");
  page.notice(
      badge(Badge::kSimulated) +
      " This report demonstrates the method. The strokes, the single judgements and the answers of three of the "
      "four nurses are simulated with a fixed seed, because the paper does not print them. No force in it was "
      "measured on a person.");
  std::set<std::string> strokes;
  for (const study::SpeedSample& sample : context.in.study.speeds) {
    strokes.insert(sample.participant + '/' + sample.level + '/' + std::to_string(sample.stroke));
  }
  std::size_t rules = 0;
  for (const fuzzy::Expert& expert : context.in.built.model.experts) rules += expert.rules.size();
  const auto range = analysis::reachableRange(context.in.built.model, context.curves->compiled());
  const std::string& published = context.demo->published_expert;
  page.keyNumbers(
      {{std::to_string(context.in.built.model.experts.size()) + " experts",
        "one of them with published rules, " + std::to_string(rules) + " rules in all"},
       {std::to_string(strokes.size()) + " strokes",
        std::to_string(context.in.study.speeds.size()) + " speed samples, simulated to match Table 1"},
       {range.fired > 0 ? base::formatFixed(range.min_n, 2) + " to " + base::formatFixed(range.max_n, 2) + " N"
                        : std::string("no force"),
        "what the averaged model can give"},
       {outOf(verdictsOf(context.claims, published)),
        "statements of the paper hold for " + published + "’s published rules; " +
            outOf(verdictsOf(context.claims, "mean")) + " for the mean, by construction"}});
  addVerdicts(page, context);
}

void addOrigin(HtmlPage& page, const ReportContext& context) {
  page.section("What is published and what is simulated");
  page.paragraph(
      "Every table and figure carries these marks. A result is only as real as the data it was computed from.");
  const auto row = [](const Markup& what, Badge origin, const Markup& how) {
    return std::vector<Cell>{headingCell(what), {.text = badge(origin)}, {.text = how}};
  };
  page.table(
      {.caption = strong("Origin of the data."),
       .head = {{{.text = "Data"}, {.text = "Origin"}, {.text = "How it came here"}}},
       .body =
           {row("Means and SDs of the speeds", Badge::kPublished, "Table 1 of the paper, typed in."),
            row("Single speed samples", Badge::kSimulated,
                "Strokes made so that their means and SDs are those of Table 1. Everything else about them, their "
                "length, shape and number of samples, is ours."),
            row("Votes on the forces", Badge::kPublished, "Table 2 of the paper, typed in."),
            row("Who voted what", Badge::kSimulated,
                "One of many ways to split the votes of Table 2 over four persons. The result of the vote does not "
                "depend on it."),
            row("Rules of " + context.demo->published_expert, Badge::kPublished,
                "Table A2 of the paper, typed in; the reading of its regions is a choice: see “The published rules in "
                "three "
                "readings”."),
            row("Answers of the other nurses", Badge::kSimulated,
                "Made with a fixed seed to follow what the text says of the experts. Statements that hold for them "
                "hold by construction."),
            row("Terms of lubrication, neck flexion, depth", Badge::kComputed,
                "Defaults of this project: the vertices in Fig. 3 are not printed. Depths follow published anatomy of "
                "adults."),
            row("Terms of the speed", Badge::kSimulated, "Fuzzy C-Means on the simulated strokes."),
            row("Terms of the force", Badge::kPublished, "The paper's vote on Table 2; cores and ramps computed."),
            row("Curves and surfaces", Badge::kComputed,
                "From these models. The numbers behind the paper's figures are not published, so nothing is drawn "
                "beside them.")},
       .wide = true});
}

}  // namespace tactus::report
