// The four kinds of evidence about the model: what is done, with its numbers, and what is not done yet.
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "app/report/report_sections.h"
#include "core/base/text.h"
#include "elicitation/agreement/agreement.h"
#include "elicitation/model/evidence.h"
#include "elicitation/uncertainty/force_bands.h"
#include "questionnaires/form_file.h"

namespace tactus::report {
namespace {

using base::formatFixed;
using elicitation::BandKind;
using elicitation::ForceBand;
using elicitation::SealedCurve;

constexpr std::size_t kMostReplicates = 500;
constexpr std::size_t kReplicatesOfMany = 200;
constexpr std::size_t kMany = 40;         // participants
constexpr std::size_t kMostChanges = 40;  // rows of the table
constexpr std::size_t kMostRows = 3;      // duels named in a cell

/// One kind of evidence, or a part of it.
struct Finding {
  bool done = false;
  std::string numbers;  ///< sentences
  std::string needs;    ///< empty where it is done
};

/// Whether a finding from the data of the participants counts.
Finding ofParticipants(bool simulated, std::string numbers) {
  if (!simulated) return {true, std::move(numbers), {}};
  return {false, std::move(numbers), "Real participants: the data of simulated ones are no evidence."};
}

std::string countText(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

Finding coverage(const ReportContext& context) {
  const auto& answers = context.in.study.answers;
  std::size_t answered = 0;
  std::size_t cannot_tell = 0;
  for (const auto& one : answers) {
    answered += one.status == study::Answer::Status::kAnswered ? 1 : 0;
    cannot_tell += one.status == study::Answer::Status::kCantTell ? 1 : 0;
  }
  if (answered == 0) return {false, {}, "Answers of experts to the form."};
  return ofParticipants(context.simulated(), "Coverage: of " + countText(answers.size(), "item", "items") +
                                                 " asked in all, the experts answered " + std::to_string(answered) +
                                                 " and could not tell " + std::to_string(cannot_tell) + '.');
}

Finding agreementFound(const ReportContext& context) {
  std::vector<std::string> ids;
  for (const auto& term : context.in.built.model.output.terms) ids.push_back(term.id);
  const auto answers = elicitation::agreementData(context.in.study.answers, {}, context.in.forms, ids);
  const auto judgements =
      elicitation::agreementData(context.in.study.judgements, context.in.build_settings.series, ids);
  std::vector<std::string> parts;
  const auto add = [&](const char* what, const auto& data) {
    if (!data || data->raters.size() < 2) return;
    const auto measured = elicitation::agreement(*data);
    if (!measured.alpha_ordinal) return;
    parts.push_back(std::string(what) + " ordinal alpha " + formatFixed(*measured.alpha_ordinal, 3) + " (" +
                    std::to_string(data->units.size()) + " × " + std::to_string(data->raters.size()) + ")");
  };
  add("answers", answers);
  add("judgements", judgements);
  if (parts.empty()) return {false, {}, "Answers or judgements of at least two experts."};
  return ofParticipants(context.simulated(), "Agreement: " + base::joined(parts, ", ") + '.');
}

Finding usability(const ReportContext& context) {
  std::size_t persons = 0;
  double sum = 0;
  double rows = 0;
  for (const auto& row : context.in.usability) {
    persons = std::max(persons, row.n);
    if (row.n == 0) continue;
    sum += row.mean;
    ++rows;
  }
  if (rows == 0) return {false, {}, "The usability form, answered by clinicians who tried the simulator."};
  return ofParticipants(context.in.usability_simulated, "Usability: mean of the statements " +
                                                            formatFixed(sum / rows, 2) + " of " +
                                                            std::to_string(questionnaires::usabilityForm().points) +
                                                            ", n = " + std::to_string(persons) + '.');
}

Finding moreReal(const ReportContext& context) {
  std::vector<std::string> said;
  std::size_t felt = 0;
  std::size_t simulated = 0;
  for (const auto& [participant, start, verdict] : context.in.duels) {
    if (start.question != study::DuelQuestion::kMoreReal || !start.gives_force ||
        verdict.outcome == experiments::DuelVerdict::Outcome::kUnfinished) {
      continue;
    }
    if (start.setting.simulated) {
      ++simulated;
      continue;
    }
    ++felt;
    if (said.size() < kMostRows) said.push_back(participant + ": " + sentenceOf(start, verdict));
  }
  if (felt == 0) {
    return {false, simulated > 0 ? countText(simulated, "simulated comparison", "simulated comparisons") + '.' : "",
            "A finished blind comparison with the question “which was more like a real insertion?” on a device that "
            "gives force."};
  }
  return {true, countText(felt, "blind comparison", "blind comparisons") + ". " + base::joined(said, " "), {}};
}

std::string differenceText(const char* what, const elicitation::GroupDifference& one, int decimals, const char* unit) {
  return std::string(what) + ' ' + formatFixed(one.expert_mean, decimals) + " against " +
         formatFixed(one.student_mean, decimals) + unit + " (an expert’s is above a student’s with " +
         formatFixed(100 * one.above, 0) + " %" +
         (one.chance ? ", p = " + formatFixed(*one.chance, 3) : std::string(", p not calculated")) + ")";
}

Finding construct(const ReportContext& context) {
  const std::string needs =
      "Strokes of at least two experts and two students: the category of the profile says expert, or student, novice "
      "or beginner.";
  if (context.curves == nullptr) return {false, {}, "A model with experts. " + needs};
  const auto found = elicitation::constructEvidence(context.in.study, context.in.built.model);
  if (!found) return {false, {}, needs};
  if (found->experts < 2 || found->students < 2) {
    return {false,
            "Now: " + countText(found->experts, "expert", "experts") + ", " +
                countText(found->students, "student", "students") + '.',
            needs};
  }
  std::string numbers =
      countText(found->experts, "expert", "experts") + " against " + countText(found->students, "student", "students") +
      "; the force of the model along their strokes: " + differenceText("peak", found->peak, 3, " N") + ", " +
      differenceText("work", found->work, 1, " N mm") + ", " +
      differenceText("reversals of a stroke", found->reversals, 2, "") +
      ". The model was built from strokes of these persons.";
  if (found->simulated) return {false, std::move(numbers), "Real participants: simulated ones are no evidence."};
  return {true, std::move(numbers), {}};
}

Finding sealedFound(const ReportContext& context, const SealedCurve& curve) {
  std::string state = std::string(curve.late ? "Sealed late, after the elicitation began, at " : "Sealed at ") +
                      curve.sealed_utc + ". ";
  if (curve.openings.empty()) return {false, state + "Not opened.", "A sign-off, and then `tactus study open`."};
  const auto& model = curve.signed_model ? *curve.signed_model : context.in.built.model;
  const auto error = elicitation::referenceError(context.in.built.about(), model, curve);
  if (!error || error->points == 0) return {false, state, "A model that gives a force along the reference."};
  state += std::string(curve.signed_model ? "The signed-off model" : "The model of these data (none was signed off)") +
           " is " + formatFixed(error->rms_n, 3) + " N (" + formatFixed(error->rms_jnd, 2) +
           " JND) from it, root mean square, n = " + std::to_string(error->points) + " points.";
  if (!curve.signed_model) {
    return {false, std::move(state),
            "A sign-off before the opening: this reference was opened while no model was signed off."};
  }
  return ofParticipants(context.simulated(), std::move(state));
}

std::vector<Cell> rowOf(const Markup& kind, const Finding& found) {
  return {headingCell(kind),
          {.text = found.done ? strong("Done") : Markup("Not done yet")},
          {.text = found.numbers.empty() ? Markup("–") : Markup(found.numbers)},
          {.text = found.needs.empty() ? Markup("–") : Markup(found.needs)}};
}

std::vector<Cell> errorRow(const procedure::Procedure& about, const Markup& what, const fuzzy::ForceModel& model,
                           const SealedCurve& curve) {
  const auto error = elicitation::referenceError(about, model, curve);
  if (!error || error->points == 0)
    return {headingCell(what), {.text = muted("no force along the reference"), .columns = 7}};
  return {
      headingCell(what),
      numberCell(std::to_string(error->points), true),
      numberCell(std::to_string(error->without)),
      numberCell(formatFixed(error->mean_n, 3), true),
      numberCell(formatFixed(error->rms_n, 3)),
      numberCell(formatFixed(error->rms_jnd, 2)),
      numberCell(formatFixed(error->largest_n, 3) + " at " + base::formatNumber(error->largest_at_mm) + " mm", true),
      numberCell(formatFixed(error->largest_jnd, 2))};
}

void addErrors(HtmlPage& page, const ReportContext& context, const SealedCurve& curve) {
  Table table{.caption = strong("Force minus the sealed reference.") + " " +
                         marks(context, {Badge::kComputed, Badge::kSimulated}) +
                         " Each point of the reference counts once.",
              .head = {{{.text = "Model"},
                        numberCell("Points", true),
                        numberCell("Without a force"),
                        numberCell("Mean (N)", true),
                        numberCell("RMS (N)"),
                        numberCell("RMS (JND)"),
                        numberCell("Largest (N)", true),
                        numberCell("Largest (JND)")}},
              .body = {},
              .note = "JND: just-noticeable difference around the force of the reference."};
  if (curve.signed_model) {
    table.body.push_back(
        errorRow(context.in.built.about(), "Signed off before the opening", *curve.signed_model, curve));
  }
  table.body.push_back(
      errorRow(context.in.built.about(), "Built from the data of this report", context.in.built.model, curve));
  page.table(table);
}

/// `18 of 20`, of the points from `from_mm` to below `to_mm` (the last region with its end).
std::string insideText(const SealedCurve& curve, const ForceBand& band, double from_mm, double to_mm) {
  std::size_t inside = 0;
  std::size_t points = 0;
  for (std::size_t p = 0; p < curve.points.size(); ++p) {
    const auto& [depth_mm, force_n] = curve.points[p];
    if (depth_mm < from_mm || depth_mm >= to_mm || !band.points[p].force_n) continue;
    ++points;
    inside += force_n >= band.points[p].low_n && force_n <= band.points[p].high_n ? 1 : 0;
  }
  if (points == 0) return "–";
  return std::to_string(inside) + " of " + std::to_string(points);
}

void addCoverage(HtmlPage& page, const ReportContext& context, const SealedCurve& curve) {
  std::vector<std::vector<double>> points;
  for (const auto& one : curve.points) {
    points.push_back(elicitation::referenceInputs(context.in.built.about(), curve.conditions, one.depth_mm));
  }
  const auto most = context.in.study.participants.size() > kMany ? kReplicatesOfMany : kMostReplicates;
  const bool draws = context.in.replicates > 0;
  auto bands = elicitation::ForceBands::of(context.in.study, context.in.built, context.in.build_settings,
                                           {.points = points,
                                            .replicates = std::min(context.in.replicates, most),
                                            .again = draws,
                                            .others = draws,
                                            .split = false});
  if (!bands) return;
  while (bands->add(bands->planned())) {
  }
  Table table{
      .caption = strong("Does the reference lie inside the bands?") + " " +
                 marks(context, {Badge::kComputed, Badge::kSimulated}) +
                 " Points of the reference inside each band of the averaged force, in all and by region. A band "
                 "of 95 % that told the whole uncertainty would hold about 95 % of them.",
      .head = {{{.text = "Band"}, numberCell("All depths", true)}},
      .body = {},
      .note =
          "The points of one curve are not independent of each other. “words” is the range under each "
          "participant’s own words, no interval of 95 %. Points without a force of the model are left out.",
      .wide = true};
  for (const auto& region : context.regions) table.head.front().push_back(numberCell(region.label));
  for (const auto kind : {BandKind::kAgain, BandKind::kOthers, BandKind::kNext, BandKind::kWords}) {
    const auto band = bands->band(kind);
    if (band.points.empty()) continue;
    const double end_mm = depthVariable(context.in.built.model).max + 1;
    std::vector<Cell> row = {
        headingCell(std::string(name(kind))),
        numberCell(strong(insideText(curve, band, context.regions.front().from_mm, end_mm)), true)};
    for (std::size_t k = 0; k < context.regions.size(); ++k) {
      const auto& region = context.regions[k];
      const bool last = k + 1 == context.regions.size();
      row.push_back(numberCell(insideText(curve, band, region.from_mm, last ? end_mm : region.to_mm)));
    }
    table.body.push_back(std::move(row));
  }
  if (!table.body.empty()) page.table(table);
}

/// `Lubrication 1, Insertion speed 50 mm/s`.
std::string conditionsText(const fuzzy::ForceModel& model, const SealedCurve& curve) {
  std::vector<std::string> parts;
  for (const auto& input : model.inputs) {
    const auto given = curve.conditions.find(input.id);
    if (given == curve.conditions.end()) continue;
    parts.push_back(input.label + ' ' + base::formatNumber(given->second) +
                    (input.unit.empty() || input.unit == "1" ? std::string() : ' ' + input.unit));
  }
  return base::joined(parts, ", ");
}

void addTrace(HtmlPage& page, const ReportContext& context, const SealedCurve& curve) {
  std::vector<Markup> lines = {"Sealed at " + curve.sealed_utc + (curve.late ? ", after the elicitation began" : "") +
                               "; SHA-256 of the reference " + curve.sha256};
  const std::string conditions = conditionsText(context.in.built.model, curve);
  if (!conditions.empty()) lines.push_back("Other inputs of the curve: " + conditions);
  if (!curve.note.empty()) lines.push_back("Note of the researcher: " + curve.note);
  std::size_t number = 0;
  for (const auto& opening : curve.openings) {
    lines.push_back("Opening " + std::to_string(++number) + " at " + opening.utc +
                    (opening.early ? ", early: no model was signed off" : ""));
  }
  if (!curve.openings.empty()) {
    lines.push_back(
        countText(curve.records_after, "stroke, judgement, answer or rule", "strokes, judgements, answers and rules") +
        " came after an opening");
    lines.push_back(countText(curve.changes.size(), "version", "versions") + " of the model came after an opening");
  }
  page.list(lines);
  if (curve.changes.empty()) return;
  Table table{.caption = strong("Versions of the model after an opening.") + " Who made them could know the reference.",
              .head = {{{.text = "Time (UTC)"}, {.text = "Author"}, {.text = "What"}}},
              .body = {}};
  for (const auto& change : curve.changes) {
    if (table.body.size() == kMostChanges) {
      table.note = "And " + std::to_string(curve.changes.size() - kMostChanges) + " more.";
      break;
    }
    table.body.push_back({headingCell(change.utc),
                          {.text = change.author.empty() ? "–" : change.author},
                          {.text = change.label.empty() ? "–" : change.label}});
  }
  page.table(table);
}

}  // namespace

void addEvidence(HtmlPage& page, const ReportContext& context) {
  page.section("Evidence");
  Table table{
      .caption = strong("Four kinds of evidence.") + " " + marks(context, {Badge::kComputed, Badge::kSimulated}) +
                 " What this study can say for its model, and what is missing.",
      .head = {{{.text = "Kind"}, {.text = "State"}, {.text = "Numbers"}, {.text = "Needs"}}},
      .body = {rowOf("Content: coverage of the form", coverage(context)),
               rowOf("Content: agreement", agreementFound(context)), rowOf("Face: usability", usability(context)),
               rowOf("Face: more like a real insertion", moreReal(context)),
               rowOf("Construct: experts against students", construct(context))},
      .note = context.simulated() ? "Data of simulated participants show how the numbers look; they are no "
                                    "evidence for any model."
                                  : "",
      .wide = true};
  if (context.in.sealed.empty()) {
    table.body.push_back(rowOf("Concurrent: distance to another source",
                               {false, {}, "A measured curve, sealed before the elicitation: `tactus study seal`."}));
  }
  for (const auto& curve : context.in.sealed) {
    table.body.push_back(rowOf("Concurrent: distance to a sealed reference", sealedFound(context, curve)));
  }
  page.table(table);
  for (const auto& curve : context.in.sealed) {
    page.subsection("The sealed reference");
    addTrace(page, context, curve);
    if (curve.openings.empty() || context.curves == nullptr) continue;
    addErrors(page, context, curve);
    addCoverage(page, context, curve);
  }
}

}  // namespace tactus::report
