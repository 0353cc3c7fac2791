// How many nurses, how many questions: the error of whole simulated studies, for a study to come or one that runs.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/cli/output_file.h"
#include "app/cli/study_build.h"
#include "app/cli/study_commands.h"
#include "app/cli/terminal.h"
#include "app/planning/band_trial.h"
#include "app/planning/planned_study.h"
#include "core/base/error.h"
#include "core/base/json/json_writer.h"
#include "core/base/tables/csv.h"
#include "core/base/text.h"
#include "core/procedure/procedure.h"

namespace tactus::cli {
namespace {

using base::formatFixed;
using base::formatNumber;
using base::JsonWriter;
using base::Result;
using planning::Design;
using planning::kSimulatedNurses;
using planning::PlannedStudy;

struct Planned {
  PlannedStudy study;
  std::vector<std::string> warnings;
};

planning::PlanSettings settingsFrom(const StudyPlanOptions& options) {
  planning::PlanSettings out;
  out.precision_n = options.precision_n;
  out.region = options.region;
  out.most_nurses = options.most_nurses;
  out.questions = options.questions;
  out.strokes = options.strokes;
  out.studies = options.studies;
  out.seed = options.seed;
  out.force_terms = options.force_terms;
  if (!options.minutes.empty())
    out.minutes = {options.minutes[0], options.minutes[1], options.minutes[2], options.minutes[3]};
  return out;
}

Result<session::ProcedurePtr> procedureNamed(const std::string& pack) {
  if (pack.empty()) return procedure::defaultProcedure();
  return packNamed(pack);
}

Result<Planned> planFrom(const StudyPlanOptions& options) {
  Planned out;
  if (options.study.empty()) {
    TACTUS_TRY(const auto about, procedureNamed(options.pack));
    out.study = planning::planBefore(about, settingsFrom(options));
  } else {
    BuildOptions build;
    build.study = options.study;
    build.force_terms = options.force_terms;
    build.replicates = 0;
    TACTUS_TRY(const auto made, buildStudy(build));
    TACTUS_TRY(out.study, planning::planDuring(made.tables.study, made.built, made.settings, settingsFrom(options)));
    out.warnings = made.warnings();
  }
  const InterruptSignals interrupt;
  if (auto ok = planning::simulate(out.study, [&](double) { return !interrupt.raised(); }); !ok)
    return tl::unexpected(ok.error());
  return out;
}

std::string textOf(const PlannedStudy& planned) {
  const auto& settings = planned.settings;
  std::string out = wrapped(kSimulatedNurses, "", 0);
  out += wrapped("Error of the averaged force " +
                     (settings.region.empty() ? std::string("in all regions") : "in " + settings.region) +
                     " for other nurses; " + std::to_string(settings.studies) +
                     " simulated studies of each design, "
                     "force words by " +
                     std::string(name(settings.force_terms)) + ", seed " + std::to_string(settings.seed) + ".",
                 "", 0);
  out += "\nquestions  strokes  nurses  error N       95 %        95 % of studies below  hours\n";
  for (const auto& one : planned.plan.designs) {
    out += rightAligned(std::to_string(one.design.questions), 9) + rightAligned(std::to_string(one.design.strokes), 9) +
           rightAligned(std::to_string(one.design.nurses), 8) + rightAligned(formatFixed(one.error_n, 3), 9) + "  " +
           formatFixed(one.low_n, 3) + " to " + formatFixed(one.high_n, 3) +
           rightAligned(formatFixed(one.p95_n, 3), 23) + rightAligned(formatFixed(one.hours, 1), 7) + "\n";
  }
  out += "\n" + wrapped(cheapestSentence(planned), "", 0);
  if (planned.now) out += wrapped("The study now: " + designText(planned.questions, *planned.now) + ".", "", 0);
  for (const auto& gain : gainsOf(planned)) out += wrapped(sentence(gain), "", 0);
  for (const auto& note : planned.notes) out += wrapped(note, "", 0);
  return out;
}

std::string jsonOf(const StudyPlanOptions& options, const PlannedStudy& planned) {
  const auto& settings = planned.settings;
  JsonWriter json;
  json.beginObject().key("simulated").value(true).key("note").value(kSimulatedNurses);
  if (!options.study.empty()) json.key("study").value(options.study);
  json.key("seed").value(static_cast<std::size_t>(settings.seed));
  json.key("studies").value(settings.studies);
  json.key("population").value(settings.population);
  json.key("region").value(settings.region).key("precision_n").value(settings.precision_n);
  json.key("force_terms").value(name(settings.force_terms));
  const auto& family = planned.family;
  json.key("family").beginObject();
  json.key("threshold_n").values(family.threshold_n).key("threshold_log").value(family.threshold_log);
  json.key("threshold_own_log").value(family.threshold_own_log).key("level_words").value(family.level_words);
  json.key("level_region_words").value(family.level_region_words);
  json.key("level_own_words").value(family.level_own_words).key("speed_mm_s").values(family.speed_mm_s);
  json.key("speed_log").value(family.speed_log).key("speed_own_log").value(family.speed_own_log);
  json.key("judgement_jnd").value(settings.noise.judgement_jnd).key("lapse").value(settings.noise.lapse);
  json.key("answer_words").value(settings.noise.answer_words);
  json.key("stroke_log").value(settings.noise.stroke_log).endObject();
  const auto& minutes = settings.minutes;
  json.key("minutes").beginObject(JsonWriter::Layout::kInline).key("other").value(minutes.other);
  json.key("stroke").value(minutes.stroke).key("force").value(minutes.force);
  json.key("question").value(minutes.question).endObject();
  const auto writeDesign = [&json](const Design& design) {
    json.key("nurses").value(design.nurses).key("questions").value(design.questions);
    json.key("strokes").value(design.strokes);
  };
  json.key("designs").beginArray();
  for (const auto& one : planned.plan.designs) {
    json.beginObject(JsonWriter::Layout::kInline);
    writeDesign(one.design);
    json.key("hours").value(one.hours).key("error_n").value(one.error_n).key("low_n").value(one.low_n);
    json.key("high_n").value(one.high_n).key("simulated_n").value(one.simulated_n).key("p95_n").value(one.p95_n);
    json.key("bias_n").value(one.bias_n).key("silent").value(one.silent).key("refused").value(one.refused);
    json.endObject();
  }
  json.endArray();
  if (planned.plan.cheapest) {
    json.key("cheapest").beginObject(JsonWriter::Layout::kInline);
    writeDesign(planned.plan.designs[*planned.plan.cheapest].design);
    json.endObject();
  }
  json.key("gains").beginArray();
  for (const auto& gain : gainsOf(planned)) {
    json.beginObject(JsonWriter::Layout::kInline);
    writeDesign(gain.to);
    json.key("buys_n").value(gain.buys_n).key("text").value(sentence(gain)).endObject();
  }
  json.endArray().key("notes").values(planned.notes).endObject();
  return json.text();
}

std::string csvOf(const PlannedStudy& planned) {
  base::CsvWriter csv{"nurses", "questions",   "strokes",     "hours",  "error_n",  "low_n",
                      "high_n", "simulated_n", "p95_n",       "bias_n", "silent",   "refused",
                      "region", "studies",     "force_terms", "seed",   "simulated"};
  const auto& settings = planned.settings;
  for (const auto& one : planned.plan.designs) {
    for (const int number : {one.design.nurses, one.design.questions, one.design.strokes}) csv.cell(number);
    for (const double number : {one.hours, one.error_n, one.low_n, one.high_n, one.simulated_n, one.p95_n, one.bias_n,
                                one.silent, one.refused})
      csv.cell(number);
    csv.cell(settings.region);
    csv.cell(settings.studies);
    csv.cell(name(settings.force_terms));
    csv.cell(static_cast<std::size_t>(settings.seed));
    csv.cell(1);
    csv.endRow();
  }
  return csv.text();
}

}  // namespace

Result<Output> studyTrial(const StudyTrialOptions& options) {
  TACTUS_TRY(const auto about, procedureNamed(options.pack));
  const planning::Questions questions = planning::questionsOf(about);
  planning::TrialSettings settings;
  settings.design = {options.nurses, static_cast<int>(questions.items.size()), options.strokes};
  settings.plan.studies = options.studies;
  settings.plan.seed = options.seed;
  settings.plan.force_terms = options.force_terms;
  const InterruptSignals interrupt;
  TACTUS_TRY(const auto trial, planning::tryBands(questions, planning::sourceOf(planning::defaultFamily(questions)),
                                                  settings, [&](double) { return !interrupt.raised(); }));
  std::vector<planning::RegionTrial> rows = trial.regions;
  rows.push_back(trial.all);
  if (options.json) {
    JsonWriter json;
    json.beginObject().key("simulated").value(true).key("note").value(kSimulatedNurses);
    json.key("procedure").value(about->id).key("nurses").value(options.nurses).key("strokes").value(options.strokes);
    json.key("studies").value(trial.studies).key("refused").value(trial.refused);
    json.key("seed").value(static_cast<std::size_t>(options.seed)).key("force_terms").value(name(options.force_terms));
    json.key("stated").value(settings.coverage).key("regions").beginArray();
    for (const auto& row : rows) {
      json.beginObject(JsonWriter::Layout::kInline).key("region").value(row.region).key("covered").value(row.covered);
      json.key("low").value(row.low).key("high").value(row.high).key("error_n").value(row.error_n);
      json.key("error_jnd").value(row.error_jnd).key("half_width_n").value(row.half_width_n).endObject();
    }
    return Output{json.endArray().endObject().text(), {}};
  }
  std::string out = wrapped(kSimulatedNurses, "", 0);
  out += wrapped(std::to_string(trial.studies) + " simulated studies of " +
                     planning::designText(questions, settings.design) + ", force words by " +
                     std::string(name(options.force_terms)) + ", seed " + std::to_string(options.seed) +
                     ". The truth is the mean force of 1000 such nurses, each with her own words; the band is that for "
                     "other nurses, which states 95 %.",
                 "", 0);
  out += "\nregion            truth in band  95 % of that   error N  in JND  half width N\n";
  for (const auto& row : rows) {
    std::string region = row.region.empty() ? "all" : row.region;
    region.resize(std::max<std::size_t>(region.size(), 16), ' ');
    out += region + rightAligned(formatFixed(100 * row.covered, 1) + " %", 15) + "  " + formatFixed(100 * row.low, 1) +
           " to " + formatFixed(100 * row.high, 1) + rightAligned(formatFixed(row.error_n, 3), 10) +
           rightAligned(formatFixed(row.error_jnd, 1), 8) + rightAligned(formatFixed(row.half_width_n, 3), 14) + "\n";
  }
  if (trial.refused > 0)
    out += wrapped("Of " + formatFixed(100 * trial.refused, 1) + " % of the studies no model could be built.", "", 0);
  return Output{std::move(out), {}};
}

Result<Output> studyPlan(const StudyPlanOptions& options) {
  if (auto ok = requireOutput(options.out, {options.study}); !ok) return tl::unexpected(ok.error());
  TACTUS_TRY(const auto planned, planFrom(options));
  Output said{options.json ? jsonOf(options, planned.study) : textOf(planned.study), planned.warnings};
  if (options.out.empty()) return said;
  return written(options.out, csvOf(planned.study), std::move(said), options.json);
}

}  // namespace tactus::cli
