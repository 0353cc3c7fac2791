#include "app/editing/lint_fixes.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <span>
#include <utility>

#include "app/editing/edit_text.h"
#include "app/editing/hole_fixes.h"
#include "app/editing/partition.h"
#include "app/editing/rule_edits.h"
#include "app/editing/step_fixes.h"
#include "app/editing/term_edits.h"
#include "core/analysis/coverage.h"
#include "core/analysis/finding_place.h"

namespace tactus::editing {
namespace {

using fuzzy::CompiledModel;
using fuzzy::Expert;
using fuzzy::ForceModel;
using Kind = analysis::Finding::Kind;

class Fixes {
 public:
  Fixes(const ForceModel& model, const CompiledModel& compiled, const analysis::Finding& finding,
        const std::stop_token& stop)
      : model_(model), compiled_(compiled), finding_(finding), stop_(stop) {
    const auto expert = findExpert(model, finding.expert);
    if (expert) expert_ = *expert;
  }

  std::vector<Fix> run() {
    switch (finding_.kind) {
      case Kind::kHole:
      case Kind::kAbstentionJump:
        addHole();
        break;
      case Kind::kConflict:
        addConflict();
        break;
      case Kind::kRedundantRule:
      case Kind::kUnreachableRule:
        if (!finding_.rules.empty()) disable(finding_.rules.front(), "Disable the rule");
        break;
      case Kind::kUnusedTerm:
      case Kind::kUnreachableTerm:
        addTerm();
        break;
      case Kind::kDirectionChange:
      case Kind::kDisagreement:
        break;
    }
    return std::move(out_);
  }

 private:
  void add(std::string text, base::Result<Edit> edit) {
    if (!edit || stop_.stop_requested()) return;
    const auto impact = editImpact(model_, compiled_, edit->model, edit->compiled);
    out_.push_back({std::move(text), std::move(*edit), impact});
  }

  void addHole() {
    const auto* const hole = std::get_if<analysis::Hole>(&finding_.where);
    if (hole == nullptr) return;
    for (auto& [text, edit] : closeHole(model_, finding_.expert, *hole, stop_)) add(text, std::move(edit));
  }

  void disable(std::size_t rule, std::string text) {
    add(std::move(text), enableRules(model_, finding_.expert, std::span(&rule, 1), false));
  }

  void addConflict() {
    if (expert_ == nullptr || finding_.rules.size() != 2) return;
    for (const std::size_t kept : finding_.rules) {
      const std::size_t other = finding_.rules[kept == finding_.rules[0] ? 1 : 0];
      if (std::max(kept, other) >= expert_->rules.size()) return;
      disable(other, "Keep " + consequentText(model_, *expert_, expert_->rules[kept].then));
    }
  }

  void addTerm() {
    const auto* const where = std::get_if<analysis::TermPlace>(&finding_.where);
    const auto* const term = expert_ == nullptr ? nullptr : analysis::termAt(finding_.where, model_, *expert_);
    if (where == nullptr || term == nullptr) return;
    const auto& variable = analysis::variableAt(model_, where->variable);
    const TermPlace place{listOf(*expert_, variable.id), where->term};
    const std::string name = labelOf(*term);
    add("Remove " + name, removeTerm(model_, place, {RulesOfTerm::kRefuse, false}));
    if (&variable == &model_.output || !partitionOrder(variable, termsFor(*expert_, variable))) return;
    add("Remove " + name + ", its neighbors close up", removeTerm(model_, place, {RulesOfTerm::kRefuse, true}));
  }

  const ForceModel& model_;
  const CompiledModel& compiled_;
  const analysis::Finding& finding_;
  std::stop_token stop_;
  const Expert* expert_ = nullptr;
  std::vector<Fix> out_;
};

/// The expert's hole that holds `point`.
std::optional<analysis::Hole> holeAt(const ForceModel& model, const std::string& expert,
                                     const std::vector<double>& point) {
  for (std::size_t e = 0; e < model.experts.size(); ++e) {
    if (model.experts[e].id != expert) continue;
    for (const auto& hole : analysis::coverage(model, std::span(&e, 1)).holes) {
      bool inside = true;
      for (std::size_t i = 0; i < point.size(); ++i) {
        inside = inside && point[i] >= hole.ranges[i].low && point[i] <= hole.ranges[i].high;
      }
      if (inside) return hole;
    }
  }
  return std::nullopt;
}

std::optional<Kind> kindOf(elicitation::RuleFinding::Kind kind) {
  using From = elicitation::RuleFinding::Kind;
  switch (kind) {
    case From::kHole:
      return Kind::kHole;
    case From::kAbstentionJump:
      return Kind::kAbstentionJump;
    case From::kConflict:
      return Kind::kConflict;
    case From::kRedundantRule:
      return Kind::kRedundantRule;
    case From::kUnreachableRule:
      return Kind::kUnreachableRule;
    case From::kUnusedTerm:
    case From::kRegionWithoutRule:
      return Kind::kUnusedTerm;
    case From::kUnreachableTerm:
      return Kind::kUnreachableTerm;
    default:
      return std::nullopt;
  }
}

std::vector<Fix> fixesForStep(const ForceModel& model, const CompiledModel& compiled,
                              const elicitation::RuleFinding& finding, const std::stop_token& stop) {
  const auto* const where = std::get_if<analysis::CliffPlace>(&finding.where);
  const std::size_t inputs = model.inputs.size();
  std::vector<Fix> out;
  if (where == nullptr || where->input >= inputs || finding.from.size() != inputs || finding.to.size() != inputs) {
    return out;
  }
  const bool of_mean = finding.experts.empty();
  std::vector<std::size_t> experts;
  for (std::size_t e = 0; e < model.experts.size(); ++e) {
    const auto& expert = model.experts[e];
    if (of_mean ? expert.weight > 0 : expert.id == finding.experts.front()) experts.push_back(e);
  }
  for (auto& [text, edit] : widenStep(model, experts, of_mean, {where->input, finding.from, finding.to}, stop)) {
    if (!edit || stop.stop_requested()) continue;
    const auto impact = editImpact(model, compiled, edit->model, edit->compiled);
    out.push_back({std::move(text), std::move(*edit), impact});
  }
  return out;
}

}  // namespace

std::vector<Fix> fixesFor(const ForceModel& model, const CompiledModel& compiled, const analysis::Finding& finding,
                          const std::stop_token& stop) {
  return Fixes(model, compiled, finding, stop).run();
}

std::vector<Fix> fixesFor(const ForceModel& model, const CompiledModel& compiled,
                          const elicitation::RuleFinding& finding, const std::stop_token& stop) {
  if (finding.kind == elicitation::RuleFinding::Kind::kForceStep) return fixesForStep(model, compiled, finding, stop);
  const auto kind = kindOf(finding.kind);
  if (!kind) return {};
  analysis::Finding plain;
  plain.kind = *kind;
  if (!finding.experts.empty()) plain.expert = finding.experts.front();
  plain.where = finding.where;
  for (const auto& source : finding.sources) {
    if (source.rule) plain.rules.push_back(*source.rule);
  }
  auto out = fixesFor(model, compiled, plain, stop);
  if (finding.kind == elicitation::RuleFinding::Kind::kRegionWithoutRule && finding.to.size() == model.inputs.size()) {
    // Its newtons are those of the hole that it leaves.
    plain.kind = Kind::kHole;
    auto hole = holeAt(model, plain.expert, finding.to);
    if (!hole) return out;
    plain.where = std::move(*hole);
    auto of_hole = fixesFor(model, compiled, plain, stop);
    std::move(of_hole.begin(), of_hole.end(), std::back_inserter(out));
  }
  return out;
}

}  // namespace tactus::editing
