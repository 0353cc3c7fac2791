#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/error.h"
#include "core/base/text.h"
#include "elicitation/model/model_builder.h"

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
    case WeightPolicy::kEqual: return 1.0;
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

/// The column of participants.csv that a policy reads; empty where it reads none.
std::string_view columnOf(WeightPolicy policy) {
  if (policy == WeightPolicy::kYears) return "years_experience";
  if (policy == WeightPolicy::kCategory) return "category";
  if (policy == WeightPolicy::kColumn) return "weight";
  return "";
}

/// The weight `value` of `expert` is none.
tl::unexpected<base::Error> refuseWeight(const study::Participant& expert, double value,
                                         const WeightSettings& settings) {
  const std::string found = "weight " + base::formatNumber(value);
  base::Error error{ErrorCode::kValue, {}, "participant " + expert.code, found, "a finite number of 0 or more"};
  if (settings.policy == WeightPolicy::kTable) error.file = settings.table_file;
  const auto column = columnOf(settings.policy);
  if (column.empty()) return tl::unexpected(std::move(error));
  return study::atCell(std::move(error), {study::kParticipantsTable, expert.line, column}, found);
}

/// Weights relative to the largest add up without overflow.
std::vector<double> shares(std::span<const double> weights) {
  const double largest = *std::max_element(weights.begin(), weights.end());
  std::vector<double> out;
  double sum = 0;
  for (const double weight : weights) {
    out.push_back(weight / largest);
    sum += out.back();
  }
  for (double& share : out) share /= sum;
  return out;
}

std::string percent(double share) {
  return share >= 0.001 ? base::formatFixed(100 * share, 1) + " %" : "less than 0.1 %";
}

}  // namespace

std::string_view name(WeightPolicy policy) noexcept {
  switch (policy) {
    case WeightPolicy::kEqual: return "equal";
    case WeightPolicy::kYears: return "years";
    case WeightPolicy::kCategory: return "category";
    case WeightPolicy::kColumn: return "column";
    case WeightPolicy::kTable: return "file";
  }
  return "";
}

Result<std::vector<double>> expertWeights(std::span<const study::Participant> experts, const WeightSettings& settings) {
  std::vector<double> weights;
  for (const auto& expert : experts) {
    TACTUS_TRY(const auto weight, weightOf(expert, settings));
    if (!std::isfinite(weight) || weight < 0) return refuseWeight(expert, weight, settings);
    weights.push_back(weight);
  }
  if (!weights.empty() && *std::max_element(weights.begin(), weights.end()) <= 0) {
    base::Error error{ErrorCode::kData, {}, "weights", "0 for every expert", "at least one weight above 0"};
    if (settings.policy == WeightPolicy::kTable) error.file = settings.table_file;
    return study::inTable(std::move(error), study::kParticipantsTable,
                          columnOf(settings.policy).empty() ? study::TableLine{} : experts.front().line);
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

std::vector<std::string> weightNotes(std::span<const study::Participant> experts, std::span<const double> weights,
                                     const std::vector<bool>& simulated) {
  constexpr double kHardly = 0.01;
  std::vector<std::string> notes;
  if (experts.empty()) return notes;
  const auto share = shares(weights);
  std::vector<std::string> made_up;
  double made_up_share = 0;
  for (std::size_t e = 0; e < experts.size(); ++e) {
    if (weights[e] == 0) {
      notes.push_back("Participant " + experts[e].code + " has the weight 0 and does not count in the mean.");
    } else if (share[e] < kHardly) {
      notes.push_back("Participant " + experts[e].code + " hardly counts in the mean: the weight " +
                      base::formatNumber(weights[e]) + " is " + percent(share[e]) + " of all.");
    }
    if (!simulated[e] || weights[e] == 0) continue;
    made_up.push_back(experts[e].code);
    made_up_share += share[e];
  }
  if (!made_up.empty() && made_up_share < 1 && made_up.size() < experts.size()) {
    notes.push_back("Simulated experts (" + base::joined(made_up, ", ") + ") have " + percent(made_up_share) +
                    " of the weight of the mean.");
  }
  return notes;
}

Result<std::map<std::string, double>> readWeightTable(const base::CsvTable& table) {
  TACTUS_TRY(const auto participant, table.require("participant"));
  TACTUS_TRY(const auto weight, table.require("weight"));
  std::map<std::string, double> weights;
  for (std::size_t row = 0; row < table.rowCount(); ++row) {
    TACTUS_TRY(const auto value, table.number(row, weight));
    if (value < 0) return table.refuse(row, weight, ErrorCode::kValue, "a number of 0 or more");
    const std::string code(base::trimmed(table.cell(row, participant)));
    if (code.empty()) return table.refuse(row, participant, ErrorCode::kValue, "a participant");
    if (!weights.emplace(code, value).second) {
      return table.refuse(row, participant, ErrorCode::kData, "each participant once");
    }
  }
  return weights;
}

}  // namespace tactus::elicitation
