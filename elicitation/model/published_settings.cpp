#include "elicitation/model/published_settings.h"

#include <algorithm>
#include <utility>

#include "core/analysis/force_difference.h"
#include "core/base/json/json_members.h"
#include "core/base/json/json_writer.h"
#include "core/base/text.h"
#include "core/fuzzy/compiled_model.h"
#include "elicitation/model/model_provenance.h"
#include "elicitation/model/record_influence.h"

namespace tactus::elicitation {
namespace {

constexpr std::string_view kMember = "unlike_published";

const fuzzy::NamedJson* memberOf(const std::vector<fuzzy::NamedJson>& members, std::string_view key) {
  const auto it = std::find_if(members.begin(), members.end(), [key](const auto& member) { return member.key == key; });
  return it == members.end() ? nullptr : &*it;
}

std::optional<double> largestDifference(const BuiltModel& built, const study::Study& study,
                                        std::span<const study::Form> forms, const BuildSettings& settings) {
  BuildSettings published;
  published.name = settings.name;
  published.created_utc = settings.created_utc;
  published.generator = settings.generator;
  const auto other = rebuiltModel(built, study, forms, published, SpeedsOf::kStudy);
  if (!other) return std::nullopt;
  const auto compiled = fuzzy::compile(built.model);
  const auto compiled_other = fuzzy::compile(*other);
  if (!compiled || !compiled_other) return std::nullopt;
  return analysis::forceDifference(built.model, *compiled, *other, *compiled_other).largest_n;
}

}  // namespace

std::vector<std::string> settingsUnlikePublished(const fuzzy::Provenance& origin) {
  std::vector<std::string> names;
  for (const auto& published : methodSettings(BuildSettings{})) {
    const auto* const own = memberOf(origin.settings, published.key);
    // Without judgements the terms of the force are those of the program, with any setting.
    const bool unused = published.key == "force_terms" && own != nullptr && own->json == base::jsonString("default");
    if (own != nullptr && !unused && own->json != published.json) names.push_back(published.key);
  }
  for (const char* other : {"depths", "force_end_n"}) {
    if (memberOf(origin.settings, other) != nullptr) names.emplace_back(other);
  }
  return names;
}

void noteUnlikePublished(BuiltModel& built, const study::Study& study, std::span<const study::Form> forms,
                         const BuildSettings& settings) {
  if (!built.model.provenance) return;
  auto& origin = *built.model.provenance;
  const auto names = settingsUnlikePublished(origin);
  if (names.empty()) return;
  std::vector<std::string> quoted;
  for (const auto& name : names) quoted.push_back(base::jsonString(name));
  std::string json = "{ \"settings\": [" + base::joined(quoted, ", ") + "]";
  if (const auto newtons = largestDifference(built, study, forms, settings))
    json += ", \"largest_n\": " + base::jsonNumber(*newtons);
  origin.settings.push_back({std::string(kMember), json + " }"});
}

std::optional<double> newtonsUnlikePublished(const fuzzy::Provenance& origin) {
  const auto* const member = memberOf(origin.settings, kMember);
  if (member == nullptr) return std::nullopt;
  const auto read = base::readJson(member->json, {}, [](base::JsonMembers& members, std::optional<base::Error>&) {
    std::optional<double> newtons;
    members.numberOrNull("largest_n", newtons);
    return newtons;
  });
  return read ? *read : std::nullopt;
}

}  // namespace tactus::elicitation
