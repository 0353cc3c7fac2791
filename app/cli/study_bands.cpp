// How far the averaged force of a study can be trusted: its bands along the depth, and whose words, whose rules.
#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/cli/model_arguments.h"
#include "app/cli/output_file.h"
#include "app/cli/study_build.h"
#include "app/cli/study_commands.h"
#include "app/cli/terminal.h"
#include "core/analysis/force_difference.h"
#include "core/base/error.h"
#include "core/base/json/json_writer.h"
#include "core/base/tables/csv.h"
#include "core/base/text.h"
#include "core/procedure/procedure.h"
#include "elicitation/force/word_intervals.h"
#include "elicitation/uncertainty/force_bands.h"
#include "elicitation/uncertainty/own_words.h"

namespace tactus::cli {
namespace {

using base::formatFixed;
using base::JsonWriter;
using base::Result;
using elicitation::BandKind;
using elicitation::ForceBand;

constexpr std::size_t kDepths = 121;    // every 5 mm
constexpr std::size_t kEachInText = 5;  // every 25 mm; the file and JSON have all
constexpr std::size_t kMostReplicates = 500;
constexpr BandKind kKinds[] = {BandKind::kAgain, BandKind::kOthers, BandKind::kNext, BandKind::kWords};

struct Found {
  std::vector<std::vector<double>> points;
  std::size_t depth = 0;  ///< the input of the curve
  std::vector<ForceBand> bands;
  std::vector<elicitation::OwnWords> words;
  std::vector<std::vector<std::optional<double>>> under_words;
  elicitation::WordsAndRules disagreement;
  std::vector<elicitation::WordInterval> intervals;
};

/// The inputs of the curve: those of Fig. 11 of Choi et al., and what was asked for.
Result<std::vector<double>> settingOf(const StudyBandsOptions& options, const procedure::Procedure& about,
                                      const fuzzy::ForceModel& model, std::size_t depth) {
  std::vector<double> at;
  for (std::size_t i = 0; i < model.inputs.size(); ++i) at.push_back(about.input_notes[i].usual);
  for (const auto& text : options.at) {
    TACTUS_TRY(const auto given, inputOption(model, "--at", text));
    if (given.first == depth) {
      return base::fail(base::ErrorCode::kValue, "--at", base::quoted(text),
                        "another input than the depth, along which the bands lie");
    }
    at[given.first] = given.second;
  }
  return at;
}

Result<Found> findBands(const StudyBandsOptions& options, const StudyBuild& made) {
  const auto& model = made.built.model;
  const auto& study = made.tables.study;
  Found out;
  out.depth = made.built.about().way();
  TACTUS_TRY(const auto at, settingOf(options, made.built.about(), model, out.depth));
  out.points = analysis::linePoints(model, at, out.depth, kDepths);
  const bool draws = options.replicates > 0;
  TACTUS_TRY(auto bands, elicitation::ForceBands::of(study, made.built, made.settings,
                                                     {.points = out.points,
                                                      .replicates = std::min(options.replicates, kMostReplicates),
                                                      .again = draws,
                                                      .others = draws,
                                                      .split = false}));
  while (bands.add(bands.planned())) {
  }
  for (const auto kind : kKinds) out.bands.push_back(bands.band(kind));
  out.words = bands.ownWords();
  out.under_words = bands.underOwnWords();
  TACTUS_TRY(out.disagreement, elicitation::wordsAndRules(study, made.built, made.settings));
  out.intervals = elicitation::wordIntervals(study.judgements, made.settings.series, made.built.about().output.terms);
  return out;
}

/// Low and high; nothing where the band has no force.
std::optional<std::pair<double, double>> rangeAt(const ForceBand& band, std::size_t p) {
  if (band.points.empty() || !band.points[p].force_n) return std::nullopt;
  return std::pair(band.points[p].low_n, band.points[p].high_n);
}

/// The averaged force, from a band that has points; a study of one participant without judgements has none.
std::optional<double> forceAt(const Found& found, std::size_t p) {
  for (const auto& band : found.bands) {
    if (!band.points.empty() && band.points[p].force_n) return band.points[p].force_n;
  }
  return std::nullopt;
}

/// The mean of the forces under own words.
std::optional<double> wordMeanAt(const Found& found, std::size_t p) {
  double sum = 0;
  double count = 0;
  for (const auto& forces : found.under_words) {
    if (!forces[p]) continue;
    sum += *forces[p];
    ++count;
  }
  return count > 0 ? std::optional(sum / count) : std::nullopt;
}

std::string numberOrDash(const std::optional<double>& force_n) { return force_n ? formatFixed(*force_n, 3) : "-"; }

std::string settingText(const Found& found, const fuzzy::ForceModel& model) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    if (i != found.depth) parts.push_back(model.inputs[i].id + ' ' + base::formatNumber(found.points.front()[i]));
  }
  return base::joined(parts, ", ");
}

std::string disagreementText(const elicitation::WordsAndRules& found) {
  std::string text = "whose words, whose rules\n" + wrapped(elicitation::wordsAndRulesSentence(found), "  ", 2);
  if (found.points == 0) return text;
  const auto cell = [](const elicitation::Disagreement& one) {
    return padded(formatFixed(one.sd_n, 3) + " (" + formatFixed(one.largest_n, 3) + ")", 18);
  };
  text += "  " + padded("", 14) + padded("shared rules", 18) + "own rules\n";
  text += "  " + padded("shared words", 14) + cell({}) + cell(found.rules) + '\n';
  text += "  " + padded("own words", 14) + cell(found.words) + cell(found.both) + '\n';
  text += wrapped("Standard deviation between " + std::to_string(found.participants.size()) +
                      " participants in N, root mean square over " + std::to_string(found.points) + " of " +
                      std::to_string(found.tried) + " points of the input space; in brackets the largest distance.",
                  "  ", 2);
  return text;
}

std::string bandsText(const Found& found, const fuzzy::ForceModel& model) {
  std::string text = "force in N along the depth at " + settingText(found, model) + "; bands of 95 %\n" +
                     padded("depth_mm", 9) + padded("force", 7);
  for (const auto& band : found.bands) text += padded(std::string(name(band.kind)), 14);
  text += "own words\n" + padded("", 16);
  text += padded("", 4 * 14) + "mean   ";
  for (const auto& own : found.words) text += padded(own.participant, 7);
  text += '\n';
  for (std::size_t p = 0; p < kDepths; p += kEachInText) {
    text += padded(base::formatNumber(found.points[p][found.depth]), 9) + padded(numberOrDash(forceAt(found, p)), 7);
    for (const auto& band : found.bands) {
      const auto range = rangeAt(band, p);
      text += padded(range ? formatFixed(range->first, 3) + "-" + formatFixed(range->second, 3) : "-", 14);
    }
    text += padded(numberOrDash(wordMeanAt(found, p)), 7);
    for (const auto& forces : found.under_words) text += padded(numberOrDash(forces[p]), 7);
    text += '\n';
  }
  text += '\n' + disagreementText(found.disagreement) + '\n';
  std::vector<std::string> notes;
  for (const auto& band : found.bands) {
    for (const auto& one : band.assumed) notes.push_back(std::string(name(band.kind)) + ", assumed: " + one);
    for (const auto& one : band.not_included) notes.push_back(std::string(name(band.kind)) + ": " + one);
  }
  for (const auto& one : notes) text += wrapped(one, "note: ", 6);
  return text;
}

std::string bandsCsv(const Found& found) {
  std::vector<std::string> header = {"depth_mm", "force_n"};
  for (const auto& band : found.bands) {
    header.push_back(std::string(name(band.kind)) + "_low_n");
    header.push_back(std::string(name(band.kind)) + "_high_n");
  }
  header.push_back("own_words_mean_n");
  for (const auto& own : found.words) header.push_back("own_words_" + own.participant + "_n");
  base::CsvWriter csv{std::span<const std::string>(header)};
  const auto cell = [&csv](const std::optional<double>& value) { value ? csv.cell(*value) : csv.cell(""); };
  for (std::size_t p = 0; p < kDepths; ++p) {
    csv.cell(found.points[p][found.depth]);
    cell(forceAt(found, p));
    for (const auto& band : found.bands) {
      const auto range = rangeAt(band, p);
      cell(range ? std::optional(range->first) : std::nullopt);
      cell(range ? std::optional(range->second) : std::nullopt);
    }
    cell(wordMeanAt(found, p));
    for (const auto& forces : found.under_words) cell(forces[p]);
    csv.endRow();
  }
  return csv.text();
}

void writeDisagreement(JsonWriter& json, const elicitation::WordsAndRules& found) {
  const auto part = [&json](std::string_view key, const elicitation::Disagreement& one) {
    json.key(key).beginObject(JsonWriter::Layout::kInline).key("sd_n").value(one.sd_n);
    json.key("largest_n").value(one.largest_n).endObject();
  };
  json.key("words_and_rules").beginObject().key("participants").values(found.participants);
  json.key("points").value(found.points).key("tried").value(found.tried);
  if (found.points > 0) {
    part("words", found.words);
    part("rules", found.rules);
    part("both", found.both);
  }
  json.key("sentence").value(elicitation::wordsAndRulesSentence(found));
  json.key("notes").values(found.notes).endObject();
}

std::string bandsJson(const StudyBandsOptions& options, const StudyBuild& made, const Found& found) {
  const auto& model = made.built.model;
  JsonWriter json;
  json.beginObject().key("study").value(options.study).key("at").beginObject(JsonWriter::Layout::kInline);
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    if (i != found.depth) json.key(model.inputs[i].id).value(found.points.front()[i]);
  }
  json.endObject().key("bands").beginArray();
  for (const auto& band : found.bands) {
    json.beginObject().key("band").value(name(band.kind)).key("available").value(!band.points.empty());
    json.key("assumed").values(band.assumed).key("not_included").values(band.not_included).endObject();
  }
  json.endArray().key("points").beginArray();
  for (std::size_t p = 0; p < kDepths; ++p) {
    json.beginObject(JsonWriter::Layout::kInline).key("depth_mm").value(found.points[p][found.depth]);
    json.key("force_n").value(forceAt(found, p));
    for (const auto& band : found.bands) {
      const auto range = rangeAt(band, p);
      json.key(std::string(name(band.kind)) + "_low_n").value(range ? std::optional(range->first) : std::nullopt);
      json.key(std::string(name(band.kind)) + "_high_n").value(range ? std::optional(range->second) : std::nullopt);
    }
    json.key("own_words_mean_n").value(wordMeanAt(found, p)).key("own_words_n").beginObject();
    for (std::size_t who = 0; who < found.words.size(); ++who)
      json.key(found.words[who].participant).value(found.under_words[who][p]);
    json.endObject().endObject();
  }
  json.endArray();
  writeDisagreement(json, found.disagreement);
  const auto& words = made.built.about().output.terms;
  json.key("word_intervals").beginArray();
  for (const auto& one : found.intervals) {
    json.beginObject(JsonWriter::Layout::kInline).key("person").value(one.participant);
    json.key("word").value(words[one.word].id).key("left_n").value(one.left_n);
    json.key("right_n").value(one.right_n).endObject();
  }
  json.endArray().key("notices").values(made.notices).endObject();
  return json.text();
}

}  // namespace

Result<Output> studyBands(const StudyBandsOptions& options) {
  TACTUS_TRY(const auto made, buildStudy(options));
  TACTUS_TRY(const auto found, findBands(options, made));
  Output said{options.json ? bandsJson(options, made, found) : bandsText(found, made.built.model), made.warnings()};
  if (options.out.empty()) return said;
  return written(options.out, bandsCsv(found), std::move(said), options.json);
}

}  // namespace tactus::cli
