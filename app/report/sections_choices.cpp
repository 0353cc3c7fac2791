// The method study: does a choice of the method matter for this study?
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
        "prints this table, and the tab Method of stage Agree shows it.");
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

}  // namespace tactus::report
