#include "core/analysis/lint.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "core/analysis/directions.h"
#include "core/analysis/reachable_range.h"
#include "core/base/text.h"

namespace tactus::analysis {
namespace {

using fuzzy::Expert;
using fuzzy::ForceModel;
using Kind = Finding::Kind;

void addHoles(const ForceModel& model, std::span<const std::size_t> experts, const std::string& who, Lint& out) {
  const Coverage found = coverage(model, experts);
  out.coverage_complete = out.coverage_complete && found.complete;
  for (const auto& hole : found.holes) {
    const std::string place = describe(hole, model);
    const std::string subject = who.empty() ? "every expert abstains" : "no rule fires";
    out.findings.push_back({Kind::kHole, who, place, subject + ": " + place});
  }
}

void addConflicts(const Expert& expert, Lint& out) {
  std::map<std::string, const fuzzy::Rule*> seen;
  for (const auto& rule : expert.rules) {
    if (!rule.enabled) continue;
    const std::string key = describe(rule.conditions);
    const auto [it, fresh] = seen.emplace(key, &rule);
    if (fresh) continue;
    out.findings.push_back(
        {Kind::kConflict, expert.id, key, "two rules for " + key + ": " + it->second->then + " and " + rule.then});
  }
}

void addUnusedTerms(const ForceModel& model, const Expert& expert, Lint& out) {
  std::set<std::pair<std::string, std::string>> used;
  for (const auto& rule : expert.rules) {
    if (!rule.enabled) continue;
    for (const auto& condition : rule.conditions) used.emplace(condition.input, condition.term);
    used.emplace(model.output.id, rule.then);
  }
  const auto look_at = [&](const fuzzy::Variable& variable) {
    for (const auto& term : termsFor(expert, variable)) {
      if (used.contains({variable.id, term.id})) continue;
      out.findings.push_back({Kind::kUnusedTerm, expert.id, variable.id + ' ' + term.id,
                              "no rule mentions " + variable.id + " is " + term.id});
    }
  };
  for (const auto& input : model.inputs) look_at(input);
  look_at(model.output);
}

void addDirections(const ForceModel& model, Lint& out) {
  for (const auto& input : model.inputs) {
    int votes = 0;
    std::vector<ExpertDirection> directions;
    for (const auto& expert : model.experts) {
      directions.push_back(direction(model, expert, input));
      votes += static_cast<int>(directions.back().prevailing);
    }
    for (std::size_t e = 0; e < directions.size(); ++e) {
      const auto& [prevailing, steps_against] = directions[e];
      const std::string& who = model.experts[e].id;
      for (const auto& step : steps_against) {
        out.findings.push_back(
            {Kind::kDirectionChange, who, step, "against the direction of most steps over " + input.id + ": " + step});
      }
      const bool falls = prevailing == Direction::kFalls;
      if (static_cast<int>(prevailing) * votes < 0) {
        out.findings.push_back({Kind::kDisagreement, who, input.id,
                                std::string("the force ") + (falls ? "falls" : "rises") + " with " + input.id +
                                    ", for most experts it " + (falls ? "rises" : "falls")});
      }
    }
  }
}

}  // namespace

std::string_view name(Kind kind) noexcept {
  switch (kind) {
    case Kind::kHole:
      return "hole";
    case Kind::kConflict:
      return "conflict";
    case Kind::kDirectionChange:
      return "direction_change";
    case Kind::kDisagreement:
      return "disagreement";
    case Kind::kUnusedTerm:
      return "unused_term";
  }
  return "";
}

Lint lint(const ForceModel& model, const fuzzy::CompiledModel& compiled) {
  Lint out;
  std::vector<std::size_t> weighty;
  for (std::size_t e = 0; e < model.experts.size(); ++e) {
    if (model.experts[e].weight > 0) weighty.push_back(e);
  }
  addHoles(model, weighty, "", out);
  for (std::size_t e = 0; e < model.experts.size(); ++e) {
    const auto& expert = model.experts[e];
    addHoles(model, std::span(&e, 1), expert.id, out);
    addConflicts(expert, out);
    addUnusedTerms(model, expert, out);
  }
  addDirections(model, out);
  out.reachable = reachableRange(model, compiled);
  return out;
}

}  // namespace tactus::analysis
