// How the model was made: every setting, and the literature.
#include "app/report/report_sections.h"
#include "core/base/text.h"

namespace tactus::report {

namespace {

std::string_view words(elicitation::Averaging averaging) {
  switch (averaging) {
    case elicitation::Averaging::kMean:
      return "mean over the participants";
    case elicitation::Averaging::kWeightedMean:
      return "mean weighted as the experts";
    case elicitation::Averaging::kMedian:
      return "median over the participants";
  }
  return "";
}

std::string weightsOf(const fuzzy::ForceModel& model) {
  if (model.experts.size() > kMostDrawn) return "see the table of participants";
  std::vector<std::string> parts;
  for (const auto& expert : model.experts) parts.push_back(expert.id + " " + base::formatNumber(expert.weight));
  return base::joined(parts, ", ");
}

}  // namespace

void addMethod(HtmlPage& page, const ReportContext& context) {
  const auto& settings = context.in.build_settings;
  const auto& built = context.in.built;
  const auto& model = built.model;
  page.section("Method");
  Table table{.caption = strong("How the model was made.") + " The same data and settings give the same model.",
              .head = {{{.text = "Step"}, {.text = "Setting"}, {.text = "Value"}}},
              .body = {}};
  const auto row = [&](const char* step, const char* setting, const std::string& value) {
    table.body.push_back({headingCell(step), {.text = setting}, {.text = value}});
  };
  if (built.speeds.empty()) {
    row("Speed terms", "Source", "defaults of the program");
  } else {
    const auto& speed = settings.speed;
    row("Speed terms", "Middles",
        speed.centres == elicitation::SpeedCentres::kClusters ? "Fuzzy C-Means of each participant’s samples"
                                                              : "means of the levels that were asked for");
    row("", "Clusters c", std::to_string(built.speeds.front().centres.size()));
    row("", "Fuzziness m", base::formatNumber(built.speeds.front().m));
    row("", "Core ends at membership α", base::formatNumber(speed.alpha));
    row("", "Samples below this share of their stroke’s peak dropped", base::formatNumber(speed.trim));
    row("", "Averaging", std::string(words(settings.averaging)));
    row("", "Terms in the rules", settings.terms == elicitation::SpeedTermsOf::kOwn ? "each expert’s own" : "averaged");
  }
  if (context.speed_intervals) {
    row("", "Draws of strokes for intervals", std::to_string(context.speed_intervals->replicates));
  }
  if (built.force_terms) {
    row("Force terms", "From", std::string(name(settings.force_terms)));
    row("", "Series of judgements", settings.series);
    row("", "End of the universe", base::formatNumber(model.output.max) + " N");
  } else {
    row("Force terms", "Source", "defaults of the program");
  }
  if (settings.depths == elicitation::DepthsFrom::kMeasured && settings.measured_depths) {
    const auto& measured = *settings.measured_depths;
    row("Depth terms", "Boundaries", measured.image.empty() ? "typed" : "measured on " + measured.image);
    row("", "Scale of the image", base::formatNumber(measured.mm_per_px) + " mm per pixel");
    row("", "Anatomical scale", base::formatNumber(measured.scale));
  } else {
    row("Depth terms", "Boundaries", "template of the program");
  }
  if (!model.experts.empty()) {
    row("Experts", "Weights", std::string(name(settings.weights.policy)) + ": " + weightsOf(model));
    row("", "Averaged force", "weighted mean of the experts whose rules fire (Eq. 2 of Choi et al.)");
  }
  row("Inference", "Conjunction", "minimum");
  row("", "Implication", model.implication == fuzzy::Implication::kClip ? "clip (minimum)" : "scale (product)");
  row("", "Aggregation", "maximum");
  row("", "Defuzzification", "exact centroid over the universe of the force");
  page.table(table);
}

void addReferences(HtmlPage& page, const ReportContext& context) {
  page.section("References");
  std::vector<Markup> list = {
      "Choi, He, Chiang, Deng, Qin. A heuristic force model for haptic simulation of nasogastric tube insertion using "
      "fuzzy logic. IEEE Transactions on Haptics. The procedure as a whole.",
      "Bezdek 1981. Pattern recognition with fuzzy objective function algorithms. Plenum. The clusters.",
      "Mamdani, Assilian 1975. An experiment in linguistic synthesis with a fuzzy logic controller. International "
      "Journal of Man-Machine Studies 7:1–13. The inference.",
      "King 2010; Feyzabadi et al. 2013 (PMID 24808327). The just-noticeable difference of "
      "forces: √(0.04² + (0.12 F)²) N."};
  if (!context.in.built.speeds.empty()) {
    list.emplace_back(
        "Hubert, Arabie 1985. Comparing partitions. Journal of Classification 2:193–218. Levels against "
        "clusters.");
    list.emplace_back(
        "Jonckheere 1954. A distribution-free k-sample test against ordered alternatives. Biometrika "
        "41:133–145. The order of the strokes.");
    list.emplace_back(
        "Hesterberg 2015. What teachers should know about the bootstrap. The American Statistician "
        "69:371–386. Intervals of few strokes.");
  }
  list.emplace_back("Krippendorff 2004. Content analysis, second edition. Sage. Alpha.");
  list.emplace_back(
      "Fleiss 1971. Measuring nominal scale agreement among many raters. Psychological Bulletin "
      "76:378–382. Kappa.");
  list.emplace_back(
      "Kendall, Babington Smith 1939. The problem of m rankings. Annals of Mathematical Statistics "
      "10:275–287. W.");
  list.emplace_back(
      "Tastle, Wierman 2007. Consensus and dissention: a measure of ordinal dispersion. International "
      "Journal of Approximate Reasoning 45:531–545. Consensus of an item.");
  page.list(list);
}

}  // namespace tactus::report
