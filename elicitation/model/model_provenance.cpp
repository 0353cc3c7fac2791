#include "elicitation/model/model_provenance.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/analysis/check_points.h"
#include "core/base/json/json_writer.h"
#include "core/base/text.h"
#include "core/fuzzy/validate.h"
#include "core/procedure/procedure.h"

namespace tactus::elicitation {
namespace {

// A model in the workbench evaluates them again at every edit.
constexpr std::size_t kMost = 120;

}  // namespace

base::Result<void> setChecks(fuzzy::ForceModel& model) {
  model.checks.clear();
  if (auto ok = fuzzy::validate(model); !ok) return ok;
  model.checks = analysis::ownChecks(model, kMost);
  return {};
}

namespace {

std::string jsonList(const std::vector<std::string>& texts) {
  std::vector<std::string> parts;
  parts.reserve(texts.size());
  for (const auto& text : texts) parts.push_back(base::jsonString(text));
  return "[" + base::joined(parts, ", ") + "]";
}

/// A JSON object with one member for each expert.
template <class Value>
std::string jsonByExpert(std::span<const ExpertRules> experts, Value value) {
  std::vector<std::string> parts;
  for (const auto& expert : experts) {
    parts.push_back(base::jsonString(expert.participant.code) + ": " + value(expert));
  }
  return "{ " + base::joined(parts, ", ") + " }";
}

/// One form as a text, several as a list, none as null.
std::string formNames(const ExpertRules& expert) {
  if (expert.forms.empty()) return "null";
  return expert.forms.size() == 1 ? base::jsonString(expert.forms.front()) : jsonList(expert.forms);
}

std::vector<std::string> simulatedParticipants(const study::Study& study) {
  std::vector<std::string> codes;
  for (const auto& participant : study.participants) {
    if (participant.simulated) codes.push_back(participant.code);
  }
  return codes;
}

/// Those of `codes` who have a row in `rows`.
template <class Rows>
std::vector<std::string> withRows(const Rows& rows, const std::vector<std::string>& codes) {
  std::set<std::string_view> present;
  std::string_view last;  // rows of one participant mostly stand together, a million of them may be samples
  for (const auto& row : rows) {
    if (!present.empty() && row.participant == last) continue;
    last = row.participant;
    present.insert(last);
  }
  std::vector<std::string> found;
  std::copy_if(codes.begin(), codes.end(), std::back_inserter(found),
               [&present](const std::string& code) { return present.contains(code); });
  return found;
}

/// `strokes and judgements of S1, S2; answers of S1`: kinds of data of the same participants stand together.
std::string simulatedKinds(const study::Study& study, const std::vector<std::string>& simulated) {
  const std::pair<std::string, std::vector<std::string>> kinds[] = {
      {"strokes", withRows(study.speeds, simulated)},
      {"judgements", withRows(study.judgements, simulated)},
      {"answers", withRows(study.answers, simulated)}};
  std::vector<std::pair<std::vector<std::string>, std::vector<std::string>>> groups;  // kinds, participants
  for (const auto& [kind, codes] : kinds) {
    if (codes.empty()) continue;
    if (groups.empty() || groups.back().second != codes) groups.push_back({{}, codes});
    groups.back().first.push_back(kind);
  }
  std::vector<std::string> parts;
  parts.reserve(groups.size());
  for (const auto& [names, codes] : groups) {
    parts.push_back(base::joined(names, " and ") + " of " + base::joined(codes, ", "));
  }
  return base::joined(parts, "; ");
}

std::string notesOn(const study::Study& study) {
  const auto simulated = simulatedParticipants(study);
  if (simulated.empty()) return {};
  const std::string kinds = simulatedKinds(study, simulated);
  std::string notes =
      kinds.empty()
          ? "Simulated participants without strokes, judgements and answers: " + base::joined(simulated, ", ") + "."
          : "Simulated, not measured: " + kinds + ".";
  const auto given = withRows(study.rules, simulated);
  if (!given.empty()) notes += " Rules given directly: " + base::joined(given, ", ") + ".";
  return notes;
}

}  // namespace

std::vector<fuzzy::NamedJson> methodSettings(const BuildSettings& settings) {
  return {{"alpha", base::jsonNumber(settings.speed.alpha)},
          {"m", base::jsonNumber(settings.speed.fcm.m)},
          {"clusters", std::to_string(settings.speed.fcm.clusters)},
          {"centres", base::jsonString(name(settings.speed.centres))},
          {"trim", base::jsonNumber(settings.speed.trim)},
          {"averaging", base::jsonString(name(settings.averaging))},
          {"terms", base::jsonString(name(settings.terms))},
          {"weights", base::jsonString(name(settings.weights.policy))},
          {"series", base::jsonString(settings.series)},
          {"force_terms", base::jsonString(name(settings.force_terms))}};
}

fuzzy::Provenance modelProvenance(const study::Study& study, std::span<const ExpertRules> experts,
                                  const BuildSettings& settings) {
  fuzzy::Provenance out;
  out.study = study.name;
  BuildSettings used = settings;
  if (const auto* const rate = procedure::of(study).rateInput()) used.speed.fcm.clusters = rate->terms.size();
  out.settings = methodSettings(used);
  if (study.judgements.empty()) out.settings.back().json = base::jsonString("default");
  if (study.procedure != nullptr && study.procedure != procedure::defaultProcedure())
    out.settings.push_back(procedure::modelSetting(*study.procedure));
  out.settings.push_back({"forms", jsonByExpert(experts, formNames)});
  out.settings.push_back(
      {"depth_terms", jsonByExpert(experts, [](const ExpertRules& e) { return base::jsonString(e.depth_terms); })});
  if (settings.depths == DepthsFrom::kMeasured && settings.measured_depths) {
    out.settings.push_back({"depths", base::jsonString(name(settings.depths))});
    // A model leaves the study; the name of an image or the length of a person may say who it was.
    auto measured = *settings.measured_depths;
    measured.image.clear();
    measured.nose_ear_xiphoid_mm.reset();
    out.settings.push_back({"depth_measurement", toText(measured)});
  }
  if (settings.force_end_n) out.settings.push_back({"force_end_n", base::jsonNumber(*settings.force_end_n)});
  std::vector<std::string> inferred;
  for (const auto& expert : experts) {
    if (expert.depth_terms_inferred) inferred.push_back(expert.participant.code);
  }
  if (!inferred.empty()) out.settings.push_back({"depth_terms_inferred", jsonList(inferred)});
  out.settings.insert(out.settings.end(), settings.extra.begin(), settings.extra.end());
  out.sources = {{"participants", std::to_string(study.participants.size())},
                 {"speeds", std::to_string(study.speeds.size())},
                 {"judgements", std::to_string(study.judgements.size())},
                 {"answers", std::to_string(study.answers.size())},
                 {"rules", std::to_string(study.rules.size())},
                 {"simulated", jsonList(simulatedParticipants(study))}};
  std::vector<std::string> without_force;
  for (const auto& participant : study.participants) {
    if (participant.virtual_device) without_force.push_back(participant.code);
  }
  if (!without_force.empty()) out.sources.push_back({"virtual", jsonList(without_force)});
  out.notes = notesOn(study);
  return out;
}

}  // namespace tactus::elicitation
