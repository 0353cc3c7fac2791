// The frequency curve beside the paper's vote.
#include <string>

#include "app/report/palette.h"
#include "app/report/report_sections.h"
#include "core/base/text.h"
#include "core/fuzzy/membership.h"
#include "elicitation/force/force_frequency.h"

namespace tactus::report {

namespace {

/// A trapezoid or triangle without its vertical edges, which only end the universe.
Series shapeOf(const fuzzy::Term& term) {
  const auto m = fuzzy::MembershipFunction::of(term);
  Series points;
  if (m.a < m.b) points.push_back({m.a, 0.0});
  points.push_back({m.b, 1.0});
  points.push_back({m.c, 1.0});
  if (m.c < m.d) points.push_back({m.d, 0.0});
  return points;
}

constexpr double kDotStepN = 0.016;

/// The shares as dots and `terms` as lines, a color for each term of the model's output.
std::string curvePlot(const ReportContext& context, const elicitation::FrequencyTerms& frequency,
                      const std::vector<fuzzy::Term>& terms, const std::string& title) {
  const fuzzy::Variable force = context.in.built.about().output;  // the shares are of all its terms
  const double end_n = context.in.built.model.output.max;
  SvgPlot plot({.title = title,
                .description = "Dots: share of the answers for each term. Lines: the term's membership function.",
                .width = 460,
                .height = 280,
                .x = {.label = "Insertion force (N)", .min = 0, .max = end_n + 0.05},
                .y = {.label = "Share, membership", .min = 0, .max = 1.05, .ticks = {0, 0.25, 0.5, 0.75, 1}},
                .simulated = context.simulated()});
  for (std::size_t k = 0; k < force.terms.size(); ++k) {
    const std::string color = figures::hex(figures::termColor(force, force.terms, k));
    if (const auto* term = fuzzy::findTerm(terms, force.terms[k].id)) {
      plot.line(shapeOf(*term), {.color = color, .width = 2}, force.terms[k].label);
    }
    // Equal shares of one force would hide each other.
    const double aside_n = kDotStepN * (static_cast<double>(k) - 0.5 * static_cast<double>(force.terms.size() - 1));
    Series dots;
    for (const auto& step : frequency.steps) {
      if (step.votes > 0 && step.shares[k] > 0) dots.push_back({step.force_n + aside_n, step.shares[k]});
    }
    plot.scatter(dots, color, 3);
  }
  return plot.svg();
}

std::string_view modelTermsFrom(const ReportContext& context) {
  switch (context.in.build_settings.force_terms) {
    case elicitation::ForceTermsFrom::kFrequency: return "frequency curve";
    case elicitation::ForceTermsFrom::kThresholds: return "participants’ thresholds";
    case elicitation::ForceTermsFrom::kProbit: return "ordered probit";
    case elicitation::ForceTermsFrom::kVote: break;
  }
  return "vote";
}

}  // namespace

void addFrequency(HtmlPage& page, const ReportContext& context) {
  if (!context.in.built.force_terms) return;
  const auto frequency = elicitation::frequencyTerms(context.in.built.about().output, context.in.built.votes);
  if (!frequency) return;
  page.subsection("Every answer counts: the frequency curve");
  page.paragraph(
      "The vote keeps the winner of each force and forgets the rest. The frequency curve keeps all answers: of all "
      "trapezoids that sum to 1, those closest to the shares of the answers (least squares). It is shown for "
      "comparison; the model uses the " +
      std::string(modelTermsFrom(context)) + ".");
  page.figure({.caption = strong("Shares of the answers and the terms from them.") + " " +
                          marks(context, {Badge::kComputed, Badge::kSimulated}) +
                          " The answers as shares (dots, those of one force side by side) and membership functions "
                          "(lines). Root mean square of membership "
                          "minus share for the frequency curve: " +
                          base::formatFixed(frequency->rms_error, 3) + ".",
               .panels = {{.heading = "(a) Frequency curve, least squares",
                           .svg = curvePlot(context, *frequency, frequency->output.terms, "Frequency curve")},
                          {.heading = context.in.build_settings.force_terms == elicitation::ForceTermsFrom::kVote
                                          ? Markup("(b) The paper’s vote")
                                          : Markup("(b) The model: ") + Markup(modelTermsFrom(context)),
                           .svg = curvePlot(context, *frequency, context.in.built.model.output.terms, "Vote")}},
               .columns = 2});
}

}  // namespace tactus::report
