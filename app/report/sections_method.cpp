// How the model was made: every setting, and the literature.
#include "app/report/report_sections.h"
#include "core/base/text.h"
#include "elicitation/model/method_study.h"

namespace tactus::report {
namespace {

// Twenty models are built: about as long as everything else takes, at 200 participants 24 of 52 s of a slow build.
constexpr std::size_t kMostCompared = 200;

std::vector<Cell> choiceRow(const ReportContext& context, const elicitation::MethodVariant& one, bool first) {
  std::vector<Cell> row = {first ? headingCell(elicitation::factorTitle(one.factor)) : Cell{}, {.text = one.value}};
  if (!one.unavailable.empty()) {
    row.push_back({.text = muted("not possible: " + one.unavailable), .columns = 6});
    return row;
  }
  row.push_back(numberCell(base::formatFixed(one.rms_n, 3), true));
  row.push_back(numberCell(base::formatFixed(one.rms_noticeable, 2)));
  row.push_back(numberCell(base::formatFixed(100 * one.noticeable_share, 1) + " %"));
  row.push_back(numberCell(base::formatFixed(one.largest_n, 3), true));
  row.push_back(numberCell(base::formatFixed(one.largest_noticeable, 1)));
  row.push_back({.text = one.at.empty() ? "" : settingText(context.in.built.model, one.at), .group_start = true});
  return row;
}

}  // namespace

void addChoices(HtmlPage& page, const ReportContext& context) {
  page.section("Does a choice of the method matter here?");
  if (context.in.study.participants.size() > kMostCompared) {
    page.paragraph(
        "Left out, because more than " + std::to_string(kMostCompared) +
        " participants take minutes here: some twenty models would have to be built. “tactus study compare STUDY” "
        "prints this table, and the tab Method of stage Build shows it.");
    return;
  }
  const auto study =
      elicitation::methodStudy(context.in.study, context.in.forms, context.in.build_settings, context.in.built);
  if (!study) {
    page.paragraph("The models could not be compared: " + study.error().message() + ".");
    return;
  }
  page.paragraph(
      "The averaged model was built again with one choice changed at a time. Its forces are compared with those "
      "of the model as it is, at " +
      std::to_string(study->points) +
      " points spread evenly over the inputs. A choice matters if a hand would feel another value at more than " +
      base::formatFixed(100 * elicitation::kMattersShare, 0) + " % of them.");
  Table sentences{.caption = strong("Choices, the largest effect first.") + " " +
                             marks(context, {Badge::kComputed, Badge::kSimulated}),
                  .head = {{{.text = "Choice"}, {.text = "Here"}, {.text = "Does it matter?"}}},
                  .body = {},
                  .wide = true};
  Table all{.caption = strong("Every value that was tried.") + " " +
                       marks(context, {Badge::kComputed, Badge::kSimulated}) +
                       " Differences of the averaged force to the model as it is, in newtons and just-noticeable "
                       "differences (JND).",
            .head = {{{.text = "Choice"},
                      {.text = "Instead"},
                      numberCell("RMS (N)", true),
                      numberCell("RMS (JND)"),
                      numberCell("Felt at"),
                      numberCell("Largest (N)", true),
                      numberCell("Largest (JND)"),
                      {.text = "Where it is largest", .group_start = true}}},
            .body = {},
            .wide = true};
  for (const std::size_t index : elicitation::factorsByEffect(*study)) {
    const auto& factor = study->factors[index];
    sentences.body.push_back({headingCell(elicitation::factorTitle(factor.factor)),
                              {.text = factor.unchanged},
                              {.text = elicitation::factorSentence(*study, factor)}});
    bool first = true;
    for (const auto& one : study->variants) {
      if (one.factor != factor.factor) continue;
      all.body.push_back(choiceRow(context, one, first));
      first = false;
    }
  }
  page.table(sentences);
  page.table(all);
}

namespace {

std::string_view words(elicitation::Averaging averaging) {
  switch (averaging) {
    case elicitation::Averaging::kMean: return "mean over the participants";
    case elicitation::Averaging::kWeightedMean: return "mean weighted as the experts";
    case elicitation::Averaging::kMedian: return "median over the participants";
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
  if (!built.speeds.empty()) {
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
  } else if (fuzzy::rateOf(model.inputs)) {
    row("Speed terms", "Source", "defaults of the program");
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
    row("Depth terms", "Boundaries", "those of the procedure");
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
      "Choi, He, Chiang, Deng, Qin. A heuristic force model for haptic simulation … using fuzzy logic. IEEE "
      "Transactions on Haptics. The method as a whole.",
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
  for (const std::string& source : context.about().sources) list.emplace_back("Of the procedure: " + source);
  page.list(list);
}

}  // namespace tactus::report
