#include "app/cli/study_build.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <utility>

#include "app/cli/output_file.h"
#include "app/session/data_checks.h"
#include "app/session/study_source.h"
#include "app/version.h"
#include "core/base/clock.h"
#include "core/base/error.h"
#include "core/base/json/json_writer.h"
#include "core/base/tables/csv.h"
#include "core/base/text.h"
#include "core/procedure/procedure.h"
#include "core/study/table_line.h"
#include "elicitation/model/published_settings.h"

namespace tactus::cli {
namespace {

using study::DataFinding;
using Kind = DataFinding::Kind;

/// The participants of the refused findings of each kind that was accepted.
std::map<std::string, std::vector<std::string>> byKind(const std::vector<DataFinding>& findings,
                                                       const std::vector<Kind>& accepted) {
  std::map<std::string, std::vector<std::string>> out;
  for (const auto& finding : findings) {
    if (study::isAccepted(finding, accepted)) out[std::string(name(finding.kind))].push_back(finding.participant);
  }
  return out;
}

}  // namespace

std::vector<std::string> acceptableWords() {
  std::vector<std::string> words;
  for (const Kind kind : study::kAcceptable) words.emplace_back(name(kind));
  return words;
}

base::Result<std::vector<Kind>> acceptedKinds(const std::vector<std::string>& words) {
  std::vector<Kind> kinds;
  for (const auto& word : words) {
    const auto kind = study::acceptableKind(word);
    if (!kind) {
      const auto known = acceptableWords();
      return base::fail(base::ErrorCode::kValue, "--accept", base::quoted(word),
                        "one of " + base::joined(known, ", ") + base::suggestion(word, known));
    }
    if (std::find(kinds.begin(), kinds.end(), *kind) == kinds.end()) kinds.push_back(*kind);
  }
  return kinds;
}

std::vector<std::string> acceptedNotes(const std::vector<DataFinding>& findings, const std::vector<Kind>& accepted) {
  const auto found = byKind(findings, accepted);
  std::vector<std::string> notes;
  std::vector<std::string> parts;
  for (const auto& [kind, participants] : found) parts.push_back(kind + " of " + base::joined(participants, ", "));
  if (!parts.empty()) notes.push_back("Accepted as it is: " + base::joined(parts, "; ") + ".");
  for (const Kind kind : accepted) {
    if (found.contains(std::string(name(kind)))) continue;
    notes.push_back("Nothing was refused for " + std::string(name(kind)) + ": --accept has no effect.");
  }
  return notes;
}

std::string acceptedJson(const std::vector<DataFinding>& findings, const std::vector<Kind>& accepted) {
  std::vector<std::string> members;
  for (const auto& [kind, participants] : byKind(findings, accepted)) {
    std::vector<std::string> codes;
    for (const auto& code : participants) codes.push_back(base::jsonString(code));
    members.push_back(base::jsonString(kind) + ": [" + base::joined(codes, ", ") + "]");
  }
  return members.empty() ? std::string() : "{ " + base::joined(members, ", ") + " }";
}

namespace {

using base::Result;
using elicitation::WeightPolicy;

Result<elicitation::WeightSettings> weightSettings(const std::string& word) {
  elicitation::WeightSettings settings;
  for (const auto policy :
       {WeightPolicy::kEqual, WeightPolicy::kYears, WeightPolicy::kCategory, WeightPolicy::kColumn}) {
    if (word != name(policy)) continue;
    settings.policy = policy;
    return settings;
  }
  const auto table = base::CsvTable::read(word);
  if (!table) {
    auto error = table.error();
    if (error.code == base::ErrorCode::kIo) error.wanted = "equal, years, category, column or a CSV file for --weights";
    return tl::unexpected(error);
  }
  TACTUS_TRY(auto weights, elicitation::readWeightTable(*table));
  settings.policy = WeightPolicy::kTable;
  settings.table = std::move(weights);
  settings.table_file = word;
  return settings;
}

/// An error of the elicitation, told to whom it concerns: the file it names, an option, or the study.
tl::unexpected<base::Error> explainedError(base::Error error, const BuildOptions& options,
                                           const std::string& weights_file) {
  if (error.file.empty() &&
      (error.place == "alpha" || error.place == "trim" || error.place == "force-end" || error.place == "depths")) {
    error.place = "--" + error.place;
    return tl::unexpected(std::move(error));
  }
  if (!error.file.empty() && error.file == weights_file) return tl::unexpected(std::move(error));
  return study::inStudyFolder(std::move(error), options.study);
}

}  // namespace

std::vector<std::string> StudyBuild::warnings() const {
  auto all = notices;
  all.insert(all.end(), tables.notes.begin(), tables.notes.end());
  return all;
}

Result<StudyBuild> buildStudy(const BuildOptions& options, RulesNeeded rules) {
  if (auto ok = requireOutput(options.out, {options.study, options.weights}); !ok) return tl::unexpected(ok.error());
  TACTUS_TRY(auto weights, weightSettings(options.weights));
  TACTUS_TRY(auto accepted, acceptedKinds(options.accept));
  TACTUS_TRY(auto whole, session::readWholeStudy(options.study));
  auto& [tables, aside, in_order] = whole;
  StudyBuild out;
  for (const auto& notice : tables.notices) out.notices.push_back(options.study + ": " + notice);
  out.data = session::dataFindings(tables.study);
  if (auto ok = study::refuseData(out.data, accepted); !ok) return study::inStudyFolder(ok.error(), options.study);

  auto& settings = out.settings;
  settings.created_utc = base::formatUtc(std::chrono::system_clock::now());
  settings.generator = kGenerator;
  settings.speed.alpha = options.alpha;
  settings.speed.trim = options.trim;
  settings.speed.centres = options.centres;
  settings.averaging = options.averaging;
  settings.force_terms = options.force_terms;
  settings.force_end_n = options.force_end_n;
  if (aside) {
    out.usability = std::move(aside->usability);
    out.usability_simulated = aside->usability_simulated;
    settings.measured_depths = std::move(aside->measured_depths);
  } else if (options.depths == elicitation::DepthsFrom::kMeasured) {
    return tl::unexpected(aside.error());
  } else {
    out.notices.push_back(aside.error().message());
  }
  settings.depths = options.depths;
  if (auto members = acceptedJson(out.data, accepted); !members.empty()) {
    settings.extra.push_back({"accepted_data", std::move(members)});
  }
  const std::string weights_file = weights.table_file;
  settings.weights = std::move(weights);
  settings.terms = options.own_terms ? elicitation::SpeedTermsOf::kOwn : elicitation::SpeedTermsOf::kAveraged;
  const auto forms = session::knownForms(procedure::of(tables.study));
  const bool terms_only = rules == RulesNeeded::kNo && !elicitation::hasRules(tables.study);
  auto built = terms_only ? elicitation::buildTerms(tables.study, settings)
                          : elicitation::buildModel(tables.study, forms, settings);
  if (!built) return explainedError(built.error(), options, weights_file);
  elicitation::noteUnlikePublished(*built, tables.study, forms, settings);
  out.built = std::move(*built);
  out.tables = std::move(tables);
  out.accepted = std::move(accepted);
  out.in_order = std::move(in_order);
  return out;
}

}  // namespace tactus::cli
