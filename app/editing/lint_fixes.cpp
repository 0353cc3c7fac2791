#include "app/editing/lint_fixes.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <span>
#include <utility>

#include "app/editing/edit.h"
#include "app/editing/rule_edits.h"
#include "app/editing/step_fixes.h"
#include "app/editing/term_edits.h"
#include "app/editing/term_list.h"
#include "core/analysis/coverage.h"
#include "core/analysis/finding_place.h"
#include "core/fuzzy/force_model.h"
#include "core/fuzzy/membership.h"

namespace tactus::editing {
namespace {

using analysis::Hole;
using analysis::InputRange;
using base::ErrorCode;
using base::fail;
using base::Result;
using fuzzy::Expert;
using fuzzy::ForceModel;
using fuzzy::MembershipFunction;
using fuzzy::Shape;
using fuzzy::Term;

/// The experts whose hole it is, as indices.
std::vector<std::size_t> expertsOf(const ForceModel& model, const std::string& expert) {
  std::vector<std::size_t> out;
  for (std::size_t e = 0; e < model.experts.size(); ++e) {
    if (expert.empty() ? model.experts[e].weight > 0 : model.experts[e].id == expert) out.push_back(e);
  }
  return out;
}

std::vector<Hole> holesOf(const ForceModel& model, const std::string& expert) {
  const auto experts = expertsOf(model, expert);
  return experts.empty() ? std::vector<Hole>() : analysis::coverage(model, experts).holes;
}

bool overlap(const InputRange& one, const InputRange& other) {
  const double low = std::max(one.low, other.low);
  const double high = std::min(one.high, other.high);
  if (low < high) return true;
  const auto holds = [low](const InputRange& r) {
    return (low > r.low || r.low_included) && (low < r.high || r.high_included);
  };
  return low == high && holds(one) && holds(other);
}

bool overlap(const Hole& one, const Hole& other) {
  return std::equal(one.ranges.begin(), one.ranges.end(), other.ranges.begin(),
                    [](const InputRange& a, const InputRange& b) { return overlap(a, b); });
}

bool isUsed(const ForceModel& model, const Expert& expert, const fuzzy::Variable& input, const std::string& term) {
  return std::any_of(expert.rules.begin(), expert.rules.end(), [&](const fuzzy::Rule& rule) {
    return fuzzy::takesPart(rule) && names(rule, model, input, term);
  });
}

/// Terms in use on both sides of a gap; null where there is none. A Gaussian has no edge that could be stretched.
struct Neighbors {
  Term* left = nullptr;  ///< the nearest that can be stretched
  Term* right = nullptr;
  const Term* nearest_left = nullptr;  ///< of any shape
  const Term* nearest_right = nullptr;
};

fuzzy::Support supportOf(const Term& term) { return fuzzy::supportOf(MembershipFunction::of(term)); }

Neighbors neighborsOf(const ForceModel& model, const Expert& expert, const fuzzy::Variable& input,
                      std::vector<Term>& terms, const InputRange& gap) {
  Neighbors out;
  for (Term& term : terms) {
    if (!isUsed(model, expert, input, term.id)) continue;
    const auto [low, high] = supportOf(term);
    const bool can_stretch = term.shape != Shape::kGaussian;
    const auto later = [high = high](const Term* other) { return other == nullptr || high > supportOf(*other).high; };
    const auto sooner = [low = low](const Term* other) { return other == nullptr || low < supportOf(*other).low; };
    if (high <= gap.low && can_stretch && later(out.left)) out.left = &term;
    if (high <= gap.low && later(out.nearest_left)) out.nearest_left = &term;
    if (low >= gap.high && can_stretch && sooner(out.right)) out.right = &term;
    if (low >= gap.high && sooner(out.nearest_right)) out.nearest_right = &term;
  }
  return out;
}

/// Its edge on the side of the gap goes from `from` to `to`.
void stretch(Term& term, bool to_the_right, double from, double to) {
  if (term.shape == Shape::kTriangle) {
    term.shape = Shape::kTrapezoid;
    term.points.insert(term.points.begin() + 1, term.points[1]);
  }
  const std::size_t first = to_the_right ? 2 : 0;
  term.points[first] = from;
  term.points[first + 1] = to;
}

/// The model with one term stretched over `gap`, or nothing where no term ends there.
std::optional<Result<Edit>> stretched(const ForceModel& model, std::size_t reader, bool own, const InputRange& gap,
                                      bool to_the_right, std::string& text) {
  ForceModel out = model;
  Expert& expert = out.experts[reader];
  const auto& input = **findVariable(out, gap.input);
  if (own) expert.overrides.push_back({gap.input, input.terms});
  const TermListId list = listOf(expert, gap.input);
  const auto open = openList(out, list);
  if (!open) return std::nullopt;
  const auto neighbors = neighborsOf(out, expert, input, *open->terms, gap);
  Term* const term = to_the_right ? neighbors.left : neighbors.right;
  const Term* const facing = to_the_right ? neighbors.nearest_right : neighbors.nearest_left;
  if (term == nullptr) return std::nullopt;
  const double end = to_the_right ? input.max : input.min;
  double from = end;
  double to = end;
  if (facing != nullptr) {
    const auto f = MembershipFunction::of(*facing);
    const auto [low, high] = supportOf(*facing);
    from = to_the_right ? low : f.gaussian ? f.mean : f.c;
    to = !to_the_right ? high : f.gaussian ? f.mean : f.b;
  }
  stretch(*term, to_the_right, from, to);
  text = "Stretch " + (list.expert.empty() ? "" : labelOf(expert) + "'s ") + labelOf(*term) + " over the gap";
  std::string label = open->title() + " / " + labelOf(*term) + ": stretched over " + numberText(input, gap.low) +
                      " to " + quantityText(input, gap.high);
  return finished(std::move(out), std::move(label));
}

/// Whether an expert's hole has to be closed in a list of its own, because others read the shared one too.
bool needsOwnList(const ForceModel& model, const std::string& expert, std::size_t reader, const std::string& input) {
  if (expert.empty() || listOf(model.experts[reader], input).expert == expert) return false;
  return std::count_if(model.experts.begin(), model.experts.end(), [&](const Expert& other) {
           return reads(other, {input, {}});
         }) > 1;
}

/// The edit without the acceptance of the hole `name`, where it closed that of the last expert.
Result<Edit> withoutAcceptance(Edit edit, const std::string& name) {
  auto& accepted = edit.model.accepted_holes;
  const auto it = std::find(accepted.begin(), accepted.end(), name);
  if (it == accepted.end()) return edit;
  const auto names = holeNames(edit.model);
  if (!names || std::find(names->begin(), names->end(), name) != names->end()) return edit;
  accepted.erase(it);
  return finished(std::move(edit.model), std::move(edit.label));
}

}  // namespace

std::vector<std::pair<std::string, Result<Edit>>> closeHole(const ForceModel& model, const std::string& expert,
                                                            const Hole& hole, const std::stop_token& stop) {
  std::vector<std::pair<std::string, Result<Edit>>> out;
  const auto holes = holesOf(model, expert);
  if (std::find(holes.begin(), holes.end(), hole) == holes.end()) return out;
  const std::string name = analysis::describe(hole, model);
  const auto offer = [&](std::size_t reader, bool own, const InputRange& gap, bool to_the_right) {
    std::string text;
    auto edit = stretched(model, reader, own, gap, to_the_right, text);
    if (!edit || !*edit) return;
    const auto left = holesOf((*edit)->model, expert);
    if (std::any_of(left.begin(), left.end(), [&](const Hole& one) { return overlap(one, hole); })) return;
    out.emplace_back(std::move(text), withoutAcceptance(std::move(**edit), name));
  };
  for (const InputRange& gap : hole.ranges) {
    if (gap.whole_universe || stop.stop_requested()) continue;
    std::vector<TermListId> tried;
    for (const std::size_t reader : expertsOf(model, expert)) {
      const bool own = needsOwnList(model, expert, reader, gap.input);
      const TermListId list =
          own ? TermListId{gap.input, model.experts[reader].id} : listOf(model.experts[reader], gap.input);
      if (stop.stop_requested() || out.size() >= kMostStretches ||
          std::find(tried.begin(), tried.end(), list) != tried.end())
        continue;
      tried.push_back(list);
      for (const bool to_the_right : {true, false}) offer(reader, own, gap, to_the_right);
    }
  }
  const auto& accepted = model.accepted_holes;
  if (std::find(accepted.begin(), accepted.end(), name) != accepted.end()) {
    out.emplace_back("Take the acceptance back", withdrawAcceptance(model, name));
  } else {
    out.emplace_back("Accept the hole", acceptHole(model, name));
  }
  return out;
}

namespace {

using fuzzy::CompiledModel;
using fuzzy::Expert;
using fuzzy::ForceModel;
using Kind = analysis::Finding::Kind;

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
      case Kind::kAbstentionJump: addHole(); break;
      case Kind::kForceStep: addStep(); break;
      case Kind::kRegionWithoutRule:
        addTerm();
        addHoleOfRegion();
        break;
      case Kind::kConflict: addConflict(); break;
      case Kind::kRedundantRule:
      case Kind::kUnreachableRule:
        if (!finding_.rules.empty()) disable(finding_.rules.front(), "Disable the rule");
        break;
      case Kind::kUnusedTerm:
      case Kind::kUnreachableTerm: addTerm(); break;
      default: break;
    }
    return std::move(out_);
  }

 private:
  void add(std::string text, base::Result<Edit> edit) {
    if (!edit || stop_.stop_requested()) return;
    const auto impact = editImpact(model_, compiled_, edit->model, edit->compiled);
    out_.push_back({std::move(text), std::move(*edit), impact});
  }

  void close(const analysis::Hole& hole) {
    for (auto& [text, edit] : closeHole(model_, finding_.expert, hole, stop_)) add(text, std::move(edit));
  }

  void addHole() {
    if (const auto* const hole = std::get_if<analysis::Hole>(&finding_.where)) close(*hole);
  }

  /// The newtons of a region are those of the hole that it leaves.
  void addHoleOfRegion() {
    if (finding_.to.size() != model_.inputs.size()) return;
    if (const auto hole = holeAt(model_, finding_.expert, finding_.to)) close(*hole);
  }

  void addStep() {
    const auto* const where = std::get_if<analysis::CliffPlace>(&finding_.where);
    const auto& from = finding_.from;
    const auto& to = finding_.to;
    const std::size_t inputs = model_.inputs.size();
    if (where == nullptr || where->input >= inputs || from.size() != inputs || to.size() != inputs) return;
    const bool of_mean = finding_.expert.empty();
    std::vector<std::size_t> experts;
    for (std::size_t e = 0; e < model_.experts.size(); ++e) {
      const auto& expert = model_.experts[e];
      if (of_mean ? expert.weight > 0 : expert.id == finding_.expert) experts.push_back(e);
    }
    for (auto& [text, edit] : widenStep(model_, experts, of_mean, {where->input, from, to}, stop_)) {
      add(std::move(text), std::move(edit));
    }
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

}  // namespace

std::vector<Fix> fixesFor(const ForceModel& model, const CompiledModel& compiled, const analysis::Finding& finding,
                          const std::stop_token& stop) {
  return Fixes(model, compiled, finding, stop).run();
}

}  // namespace tactus::editing
