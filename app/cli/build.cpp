#include <algorithm>
#include <optional>
#include <string>

#include "app/cli/commands.h"
#include "app/cli/findings_text.h"
#include "app/cli/output_file.h"
#include "app/cli/study_build.h"
#include "app/cli/terminal.h"
#include "core/base/error.h"
#include "core/base/json/json_writer.h"
#include "core/base/text.h"
#include "core/fuzzy/compiled_model.h"
#include "core/model_io/model_file.h"
#include "elicitation/model/expert_weights_compared.h"
#include "elicitation/model/model_builder.h"
#include "elicitation/model/speed_bootstrap.h"
#include "elicitation/rules/rule_lint.h"

namespace tactus::cli {
namespace {

// The speeds of a study in the output of the commands: levels, centers with intervals, and their agreement.

using base::formatFixed;
using base::JsonWriter;
using elicitation::Interval;
using elicitation::ParticipantSpeeds;
using elicitation::RampInterval;
using elicitation::SpeedIntervals;
using elicitation::StudySpeedIntervals;

std::string fixed1(double value) { return formatFixed(value, 1); }

std::string withInterval(double value, const Interval* interval) {
  if (interval == nullptr) return fixed1(value);
  return fixed1(value) + " [" + fixed1(interval->low) + ", " + fixed1(interval->high) + "]";
}

std::string shortProbability(double p) { return formatFixed(p, p < 0.001 ? 6 : 3); }

std::string participantAsText(const ParticipantSpeeds& one, const SpeedIntervals* intervals) {
  const auto& found = one.diagnostics;
  std::string text = "speeds of " + base::oneLine(one.participant) + ": " + std::to_string(one.kept) + " of " +
                     std::to_string(one.samples) + " samples\n";
  for (std::size_t k = 0; k < found.levels.size(); ++k) {
    const auto& level = found.levels[k];
    text += "  " + base::oneLine(level.level);
    text += level.samples == 0 ? " no strokes"
                               : " " + fixed1(level.mean_mm_s) + " ± " + fixed1(level.sd_mm_s) + " mm/s, strokes " +
                                     std::to_string(level.stroke_means_mm_s.size());
    text += "; center " + withInterval(one.centres[k], intervals == nullptr ? nullptr : &intervals->centres[k]);
    if (k < found.separations.size() && found.separations[k]) {
      text += "; d' to the next level " + formatFixed(*found.separations[k], 2);
    }
    text += '\n';
  }
  if (found.trend) {
    text += "  order of the levels: Jonckheere-Terpstra J " + base::formatNumber(found.trend->j) + " of " +
            base::formatNumber(found.trend->most_j) + ", p " + shortProbability(found.trend->p) +
            (found.trend->exact ? " (exact)\n" : " (normal approximation)\n");
  }
  return text + "  nearest center against level: adjusted Rand index " +
         formatFixed(found.confusion.adjusted_rand_index, 2) + ", accuracy " +
         formatFixed(found.confusion.accuracy, 2) + '\n';
}

void writeInterval(const Interval& interval, JsonWriter& json) {
  json.beginArray(JsonWriter::Layout::kInline).value(interval.low).value(interval.high).endArray();
}

void writeRamps(std::string_view key, const std::vector<elicitation::Ramp>& ramps,
                const std::vector<RampInterval>* intervals, JsonWriter& json) {
  json.key(key).beginArray();
  for (std::size_t k = 0; k < ramps.size(); ++k) {
    json.beginObject(JsonWriter::Layout::kInline).key("p").value(ramps[k].p).key("q").value(ramps[k].q);
    json.key("p_interval");
    intervals == nullptr ? static_cast<void>(json.null()) : writeInterval((*intervals)[k].p, json);
    json.key("q_interval");
    intervals == nullptr ? static_cast<void>(json.null()) : writeInterval((*intervals)[k].q, json);
    json.endObject();
  }
  json.endArray();
}

void writeLevels(const ParticipantSpeeds& one, JsonWriter& json) {
  json.key("levels").beginArray();
  for (const auto& level : one.diagnostics.levels) {
    json.beginObject(JsonWriter::Layout::kInline).key("level").value(level.level);
    json.key("strokes").value(level.stroke_means_mm_s.size()).key("samples").value(level.samples);
    json.key("mean_mm_s").value(level.mean_mm_s).key("sd_mm_s").value(level.sd_mm_s).endObject();
  }
  json.endArray().key("separations").beginArray(JsonWriter::Layout::kInline);
  for (const auto& separation : one.diagnostics.separations) json.value(separation);
  json.endArray().key("jonckheere_terpstra");
  if (const auto& trend = one.diagnostics.trend) {
    json.beginObject(JsonWriter::Layout::kInline).key("j").value(trend->j).key("most_j").value(trend->most_j);
    json.key("p").value(trend->p).key("exact").value(trend->exact).endObject();
  } else {
    json.null();
  }
}

void writeParticipant(const ParticipantSpeeds& one, const SpeedIntervals* intervals, JsonWriter& json) {
  const auto& confusion = one.diagnostics.confusion;
  json.beginObject().key("participant").value(one.participant).key("simulated").value(one.simulated);
  json.key("samples").value(one.samples).key("kept").value(one.kept);
  writeLevels(one, json);
  json.key("confusion").beginArray(JsonWriter::Layout::kInline);
  for (const auto& row : confusion.counts) {
    json.beginArray(JsonWriter::Layout::kInline);
    for (const std::size_t count : row) json.value(count);
    json.endArray();
  }
  json.endArray().key("adjusted_rand_index").value(confusion.adjusted_rand_index);
  json.key("accuracy").value(confusion.accuracy).key("centres").values(one.centres).key("centre_intervals");
  if (intervals == nullptr) {
    json.null();
  } else {
    json.beginArray(JsonWriter::Layout::kInline);
    for (const auto& interval : intervals->centres) writeInterval(interval, json);
    json.endArray();
  }
  writeRamps("ramps", one.ramps, intervals == nullptr ? nullptr : &intervals->ramps, json);
  json.endObject();
}

const SpeedIntervals* intervalsOf(const std::optional<StudySpeedIntervals>& intervals, std::size_t who) {
  return intervals ? &intervals->participants[who] : nullptr;
}

/// The intervals of the speeds in `built` from `replicates` bootstrap replicates. Nothing if there are no replicates or
/// no speeds. Nothing, with a sentence in `note`, if a level has too few strokes.
std::optional<StudySpeedIntervals> speedIntervals(const study::Study& study, const elicitation::BuiltModel& built,
                                                  const elicitation::BuildSettings& settings, std::size_t replicates,
                                                  std::string& note) {
  if (replicates == 0 || built.speeds.empty()) return std::nullopt;
  auto bootstrap = elicitation::SpeedBootstrap::of(study, built, settings);
  if (!bootstrap) {
    note = "There are no intervals of the speeds: " + bootstrap.error().message() + ".";
    return std::nullopt;
  }
  bootstrap->add(replicates);
  return bootstrap->intervals();
}

/// A few lines for each participant with speeds, and one line for the averaged ramps; empty without speeds.
std::string speedsAsText(const elicitation::BuiltModel& built, const std::optional<StudySpeedIntervals>& intervals) {
  if (built.speeds.empty()) return {};
  std::string text;
  for (std::size_t who = 0; who < built.speeds.size(); ++who) {
    text += participantAsText(built.speeds[who], intervalsOf(intervals, who));
  }
  text += "averaged ramps:";
  for (std::size_t k = 0; k < built.averaged_ramps.size(); ++k) {
    const RampInterval* interval = intervals ? &intervals->averaged[k] : nullptr;
    text += (k == 0 ? " " : "; ") +
            withInterval(built.averaged_ramps[k].p, interval == nullptr ? nullptr : &interval->p) + " to " +
            withInterval(built.averaged_ramps[k].q, interval == nullptr ? nullptr : &interval->q);
  }
  text += " mm/s\n";
  if (intervals) {
    text += "in brackets: 95 % intervals (Student's t, standard deviation of " + std::to_string(intervals->replicates) +
            " draws of whole strokes)\n";
  }
  return text;
}

/// The same as the member `speeds` of the open object of `json`; absent values are `null`.
void writeSpeeds(const elicitation::BuiltModel& built, const std::optional<StudySpeedIntervals>& intervals,
                 JsonWriter& json) {
  json.key("speeds").beginObject().key("replicates").value(intervals ? intervals->replicates : std::size_t{0});
  json.key("interval_method").value(elicitation::kIntervalMethod).key("coverage").value(elicitation::kCoverage);
  json.key("participants").beginArray();
  for (std::size_t who = 0; who < built.speeds.size(); ++who) {
    writeParticipant(built.speeds[who], intervalsOf(intervals, who), json);
  }
  json.endArray();
  writeRamps("averaged_ramps", built.averaged_ramps, intervals ? &intervals->averaged : nullptr, json);
  json.endObject();
}

using base::Result;

/// What a build gives besides the model file.
struct Results {
  const elicitation::BuiltModel& built;
  const std::vector<study::DataFinding>& data;
  const std::vector<std::string>& notices;
  elicitation::RuleLint lint;
  std::vector<elicitation::WeightedModel> weights;
  std::optional<elicitation::StudySpeedIntervals> speed_intervals;
  elicitation::ForceTermsFrom force_terms;
  std::vector<study::DataFinding::Kind> accepted;
};

/// `force terms from the vote: very_small 0 0 0.2 0.3; ...; the universe ends at 1.1 N`.
std::string forceAsText(const elicitation::BuiltModel& built, elicitation::ForceTermsFrom from) {
  if (!built.force_terms) return {};
  std::vector<std::string> terms;
  for (const auto& term : built.model.output.terms) {
    std::string text = term.id;
    for (const double point : term.points) text += ' ' + base::roundedNumber(point);
    terms.push_back(std::move(text));
  }
  return "force terms from the " + std::string(name(from)) + ": " + base::joined(terms, "; ") +
         " N; the universe ends at " + base::roundedNumber(built.model.output.max) + " N\n";
}

void writeForce(const elicitation::BuiltModel& built, elicitation::ForceTermsFrom from, base::JsonWriter& json) {
  json.key("force").beginObject().key("terms_from").value(built.force_terms ? name(from) : "default");
  json.key("end_n").value(built.model.output.max).key("terms").beginArray();
  for (const auto& term : built.model.output.terms) {
    json.beginObject(base::JsonWriter::Layout::kInline).key("id").value(term.id);
    json.key("points").values(term.points).endObject();
  }
  json.endArray().endObject();
}

std::string summary(const BuildOptions& options, const Results& results) {
  const auto& built = results.built;
  std::string text = dataAsText(results.data, results.accepted);
  text += base::oneLine(options.out + ": " + built.model.name) + "; experts " +
          std::to_string(built.model.experts.size()) + '\n';
  for (const auto& expert : built.model.experts) {
    text += "  " + base::oneLine(expert.id) + ": rules " + std::to_string(expert.rules.size()) + ", weight " +
            base::formatNumber(expert.weight) + '\n';
  }
  text += speedsAsText(built, results.speed_intervals);
  text += forceAsText(built, results.force_terms);
  for (const auto& note : built.notes) text += wrapped(note, "note: ", 6);
  text += "findings " + std::to_string(results.lint.findings.size()) + '\n';
  return text + findingsAsText(results.lint.findings, built.model.output.unit);
}

/// The model under each policy as the member `weights` of the object that `json` is in.
void writeWeights(const std::vector<elicitation::WeightedModel>& models, base::JsonWriter& json) {
  json.key("weights").beginArray();
  for (const auto& one : models) {
    json.beginObject(base::JsonWriter::Layout::kInline).key("policy").value(name(one.policy));
    if (!one.table.empty()) json.key("table").value(one.table);
    json.key("available").value(one.model.has_value());
    if (!one.model) {
      json.key("reason").value(one.unavailable).endObject();
      continue;
    }
    const auto& difference = one.from_equal;
    json.key("weights").beginArray(base::JsonWriter::Layout::kInline);
    for (const auto& expert : one.model->experts) json.value(expert.weight);
    json.endArray().key("largest_n").value(difference.largest_n).key("rms_n").value(difference.rms_n);
    json.key("at").values(difference.at).key("region");
    one.region.empty() ? json.null() : json.value(one.region);
    json.key("points").value(difference.points).key("only_one_fires").value(difference.only_one_fires).endObject();
  }
  json.endArray();
}

std::string asJson(const BuildOptions& options, const Results& results) {
  const auto& built = results.built;
  base::JsonWriter json;
  json.beginObject().key("model").value(options.out).key("name").value(built.model.name);
  writeData(results.data, json);
  json.key("accepted").beginArray(base::JsonWriter::Layout::kInline);
  for (const auto kind : results.accepted) json.value(name(kind));
  json.endArray();
  json.key("experts").beginArray();
  for (const auto& expert : built.model.experts) {
    json.beginObject(base::JsonWriter::Layout::kInline).key("id").value(expert.id);
    json.key("rules").value(expert.rules.size()).key("weight").value(expert.weight).endObject();
  }
  json.endArray().key("notes").values(built.notes).key("notices").values(results.notices);
  writeSpeeds(built, results.speed_intervals, json);
  writeForce(built, results.force_terms, json);
  writeFindings(results.lint.findings, json);
  writeWeights(results.weights, json);
  json.endObject();
  return json.text();
}

}  // namespace

Result<Output> build(const BuildOptions& options) {
  TACTUS_TRY(auto made, buildStudy(options));
  auto& built = made.built;
  const auto& study = made.tables.study;
  const auto compiled = fuzzy::compile(built.model);
  if (!compiled) return inFile(compiled.error(), options.study);
  std::string no_intervals;
  const auto intervals = speedIntervals(study, built, made.settings, options.replicates, no_intervals);
  if (!no_intervals.empty()) built.notes.push_back(no_intervals);
  for (auto& note : acceptedNotes(made.data, made.accepted)) built.notes.push_back(std::move(note));
  Results results{built, made.data, made.notices,        elicitation::ruleLint(built.model, *compiled, built.experts),
                  {},    intervals, options.force_terms, made.accepted};
  if (options.json) {
    auto weighted = elicitation::compareWeights(built, study, made.settings);
    if (!weighted) return inFile(weighted.error(), options.study);
    results.weights = std::move(*weighted);
  }
  TACTUS_TRY(const auto text, model_io::modelText(built.model, options.out));
  return written(options.out, text,
                 {options.json ? asJson(options, results) : summary(options, results), made.warnings()}, options.json);
}

}  // namespace tactus::cli
