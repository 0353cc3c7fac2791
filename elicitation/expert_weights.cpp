#include "elicitation/expert_weights.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/text.h"

namespace tactus::elicitation {
namespace {

using base::ErrorCode;
using base::fail;
using base::Result;

std::optional<double> find(const std::map<std::string, double>& table, const std::string& key) {
  const auto it = table.find(key);
  return it == table.end() ? std::nullopt : std::optional(it->second);
}

std::string keys(const std::map<std::string, double>& table) {
  std::vector<std::string> out;
  for (const auto& [key, weight] : table) out.push_back(key);
  return out.empty() ? "none" : base::joined(out, ", ");
}

Result<double> weightOf(const study::Participant& expert, const WeightSettings& settings) {
  const std::string place = "participant " + expert.code;
  switch (settings.policy) {
    case WeightPolicy::kEqual:
      return 1.0;
    case WeightPolicy::kYears:
      if (expert.years_experience) return *expert.years_experience;
      return study::atCell(
          {ErrorCode::kData, {}, place, "no years of experience", "a number, because the weights are the years"},
          {study::kParticipantsTable, expert.line, "years_experience"}, "an empty cell");
    case WeightPolicy::kCategory:
      if (const auto weight = find(settings.categories, base::lowered(expert.category))) return *weight;
      return study::atCell({ErrorCode::kData,
                            {},
                            place,
                            expert.category.empty() ? "no category" : "category " + base::quoted(expert.category),
                            "one of " + keys(settings.categories) + ", because the weights follow the category"},
                           {study::kParticipantsTable, expert.line, "category"},
                           expert.category.empty() ? "an empty cell" : base::quoted(expert.category));
    case WeightPolicy::kColumn:
      if (expert.weight) return *expert.weight;
      return study::atCell({ErrorCode::kData, {}, place, "no weight", "a number in the column 'weight'"},
                           {study::kParticipantsTable, expert.line, "weight"}, "an empty cell");
    case WeightPolicy::kTable:
      if (const auto weight = find(settings.table, expert.code)) return *weight;
      return tl::unexpected(base::Error{ErrorCode::kData, settings.table_file, place, "no row in the table of weights",
                                        "one row per expert (there are: " + keys(settings.table) + ")"});
  }
  return 1.0;
}

}  // namespace

std::string_view name(WeightPolicy policy) noexcept {
  switch (policy) {
    case WeightPolicy::kEqual:
      return "equal";
    case WeightPolicy::kYears:
      return "years";
    case WeightPolicy::kCategory:
      return "category";
    case WeightPolicy::kColumn:
      return "column";
    case WeightPolicy::kTable:
      return "file";
  }
  return "";
}

Result<std::vector<double>> expertWeights(std::span<const study::Participant> experts, const WeightSettings& settings) {
  std::vector<double> weights;
  for (const auto& expert : experts) {
    const auto weight = weightOf(expert, settings);
    if (!weight) return tl::unexpected(weight.error());
    if (!std::isfinite(*weight) || *weight < 0) {
      return fail(ErrorCode::kValue, "participant " + expert.code, "weight " + base::formatNumber(*weight),
                  "a number of 0 or more");
    }
    weights.push_back(*weight);
  }
  if (!weights.empty() && *std::max_element(weights.begin(), weights.end()) <= 0) {
    const std::string file = settings.policy == WeightPolicy::kTable ? settings.table_file : "";
    return tl::unexpected(
        base::Error{ErrorCode::kData, file, "weights", "0 for every expert", "at least one weight above 0"});
  }
  return weights;
}

std::vector<std::string> unusedWeightNotes(std::span<const study::Participant> participants,
                                           const WeightSettings& settings) {
  std::vector<std::string> notes;
  if (settings.policy != WeightPolicy::kTable) return notes;
  const std::string table = settings.table_file.empty() ? "The table of weights" : settings.table_file;
  for (const auto& [code, weight] : settings.table) {
    const bool known = std::any_of(participants.begin(), participants.end(),
                                   [&key = code](const study::Participant& one) { return one.code == key; });
    if (!known) notes.push_back(table + " has a weight for " + base::quoted(code) + ", who is not in the study.");
  }
  return notes;
}

Result<std::map<std::string, double>> readWeightTable(const base::CsvTable& table) {
  const auto participant = table.require("participant");
  if (!participant) return tl::unexpected(participant.error());
  const auto weight = table.require("weight");
  if (!weight) return tl::unexpected(weight.error());
  std::map<std::string, double> weights;
  for (std::size_t row = 0; row < table.rowCount(); ++row) {
    const auto value = table.number(row, *weight);
    if (!value) return tl::unexpected(value.error());
    if (*value < 0) return table.refuse(row, *weight, ErrorCode::kValue, "a number of 0 or more");
    const std::string code(base::trimmed(table.cell(row, *participant)));
    if (code.empty()) return table.refuse(row, *participant, ErrorCode::kValue, "a participant");
    if (!weights.emplace(code, *value).second) {
      return table.refuse(row, *participant, ErrorCode::kData, "each participant once");
    }
  }
  return weights;
}

}  // namespace tactus::elicitation
