#include "elicitation/agreement/expert_cells.h"

#include <algorithm>
#include <map>

namespace tactus::elicitation {
namespace {

CellRule cellRule(const fuzzy::ForceModel& model, const fuzzy::Expert& expert, std::size_t rule) {
  CellRule out{rule, {}};
  for (const auto& condition : expert.rules[rule].conditions) {
    for (std::size_t k = 0; k < model.inputs.size(); ++k) {
      if (model.inputs[k].id != condition.input) continue;
      const auto* term = fuzzy::findTerm(fuzzy::termsFor(expert, model.inputs[k]), condition.term);
      out.memberships.emplace_back(k, fuzzy::MembershipFunction::of(*term));
    }
  }
  return out;
}

}  // namespace

bool CellRule::fires(const fuzzy::ForceModel& model, const std::vector<double>& point) const {
  return std::all_of(memberships.begin(), memberships.end(), [&](const auto& one) {
    const auto& input = model.inputs[one.first];
    return one.second(std::clamp(point[one.first], input.min, input.max)) > 0;
  });
}

std::vector<std::pair<std::string, std::string>> cellKey(const fuzzy::Rule& rule) {
  std::vector<std::pair<std::string, std::string>> key;
  for (const auto& condition : rule.conditions) key.emplace_back(condition.input, condition.term);
  std::sort(key.begin(), key.end());
  return key;
}

std::vector<ExpertCell> expertCells(const fuzzy::ForceModel& model) {
  std::vector<ExpertCell> cells;
  std::map<std::vector<std::pair<std::string, std::string>>, std::size_t> places;
  for (std::size_t e = 0; e < model.experts.size(); ++e) {
    const auto& expert = model.experts[e];
    for (std::size_t r = 0; r < expert.rules.size(); ++r) {
      if (!expert.rules[r].enabled || !(expert.rules[r].weight > 0)) continue;
      const auto [place, fresh] = places.try_emplace(cellKey(expert.rules[r]), cells.size());
      if (fresh)
        cells.push_back({expert.rules[r].conditions, std::vector<std::optional<CellRule>>(model.experts.size())});
      auto& kept = cells[place->second].rules[e];
      if (!kept) kept = cellRule(model, expert, r);
    }
  }
  return cells;
}

}  // namespace tactus::elicitation
