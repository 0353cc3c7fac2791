// What has to hold after every gesture, and on the way back.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

#include "app/editing/edit.h"
#include "app/editing/rule_grid.h"
#include "core/fuzzy/membership.h"
#include "core/fuzzy/validate.h"
#include "core/model_io/model_file.h"

#include "tests/gui/bench_gestures.h"
#include "tests/support/random_model.h"

namespace tactus::tests {
namespace {

constexpr int kPoints = 6;  // at which the compiled form is compared

bool sameBits(const fuzzy::Evaluation& one, const fuzzy::Evaluation& other) {
  return one.fired == other.fired &&
         std::bit_cast<std::uint64_t>(one.force_n) == std::bit_cast<std::uint64_t>(other.force_n);
}

/// docs/semantics.md: weight times the smallest membership, of a rule that is enabled.
double strengthOf(const fuzzy::ForceModel& model, const fuzzy::Expert& expert, const fuzzy::Rule& rule,
                  const std::vector<double>& point) {
  double smallest = 1;
  for (const fuzzy::Condition& condition : rule.conditions) {
    for (std::size_t i = 0; i < model.inputs.size(); ++i) {
      if (model.inputs[i].id != condition.input) continue;
      const fuzzy::Term& term = *fuzzy::findTerm(fuzzy::termsFor(expert, model.inputs[i]), condition.term);
      smallest = std::min(smallest, fuzzy::MembershipFunction::of(term)(point[i]));
    }
  }
  return rule.enabled ? rule.weight * smallest : 0;
}

bool sameCell(const editing::GridCell& one, const editing::GridCell& other) {
  return one.rule == other.rule && one.then == other.then && one.weight == other.weight &&
         one.enabled == other.enabled && one.conflict == other.conflict;
}

}  // namespace

std::string BenchGestures::check(bool with_file) {
  if (!broken_.empty()) return std::exchange(broken_, {});
  if (auto wrong = checkModel(); !wrong.empty()) return wrong;
  if (edits_.inGesture()) {
    const auto [kept, is_new] = kept_.try_emplace(edits_.history().current(), edits_.base());
    return is_new || editing::sameBits(kept->second, edits_.base()) ? "" : "a gesture changed what it began with";
  }
  if (auto wrong = checkShown(); !wrong.empty()) return wrong;
  if (auto wrong = checkRules(); !wrong.empty()) return wrong;
  return with_file ? checkFile() : "";
}

std::string BenchGestures::checkModel() {
  const fuzzy::ForceModel& model = edits_.model();
  if (const auto valid = fuzzy::validate(model); !valid) return "invalid: " + valid.error().message();
  if (edits_.inGesture()) return {};
  const auto& open = *models_.current();
  if (!editing::sameBits(open.model, model)) return "the open model is not that of the history";
  const auto fresh = fuzzy::compile(model);
  if (!fresh) return "does not compile: " + fresh.error().message();
  for (int i = 0; i < kPoints; ++i) {
    const auto point = support::randomPoint(random_, model);
    if (!sameBits(open.compiled.evaluate(point), fresh->evaluate(point))) return "the compiled form is another";
    const std::size_t e = below(model.experts.size());
    if (!sameBits(open.compiled.evaluateExpert(e, point), fresh->evaluateExpert(e, point))) {
      return "the compiled form of an expert is another";
    }
  }
  const auto [kept, is_new] = kept_.try_emplace(edits_.history().current(), model);
  return is_new || editing::sameBits(kept->second, model) ? "" : "a state came back with another model";
}

std::string BenchGestures::checkShown() {
  workbench::CompareController& compare = bench_.compare;
  const auto shown = models_.shown();
  if (scene_.shared() != shown) return "the scene looks at another model";
  if (!compare.showsAnother()) return shown == models_.current() ? "" : "another model is shown, and nobody compares";
  const auto side = compare.modelOf(*compare.shown());
  if (!side) return "what is shown cannot be made: " + side.error().message();
  return editing::sameBits((*side)->model, shown->model) ? "" : "what is shown is not the side of the comparison";
}

std::string BenchGestures::checkRules() {
  const fuzzy::ForceModel& model = edits_.model();
  const fuzzy::Expert& expert = rules_.expert();
  for (const auto& grid : rules_.grids()) {
    const auto fresh = editing::ruleGrid(model, grid.id);
    if (!fresh) return "a grid that cannot be: " + fresh.error().message();
    const bool same = fresh->rows == grid.cells.rows && fresh->columns == grid.cells.columns &&
                      std::equal(fresh->cells.begin(), fresh->cells.end(), grid.cells.cells.begin(),
                                 grid.cells.cells.end(), sameCell);
    if (!same) return "a grid is older than the rules";
  }
  if (const auto cell = rules_.selected(); cell && rules_.conditionsOf(*cell).isEmpty()) return "a cell without a name";
  if (expert.rules.empty()) return {};
  const std::size_t rule = below(expert.rules.size());
  const double wanted = strengthOf(model, expert, expert.rules[rule], scene_.readingPoint());
  return std::abs(rules_.strength(rule) - wanted) <= 1e-12 ? "" : "a rule acts with another strength";
}

std::string BenchGestures::checkFile() {
  fuzzy::ForceModel saved = edits_.model();
  editing::refreshChecks(saved, models_.current()->compiled);
  const auto read = model_io::parseModel(model_io::formatModel(saved), "fuzz");
  if (!read) return "the file does not read back: " + read.error().message();
  return editing::sameBits(read->model, saved) ? "" : "the file reads back as another model";
}

std::string BenchGestures::unwind() {
  edits_.commit();
  if (auto wrong = check(false); !wrong.empty()) return wrong;
  const editing::StateId end = edits_.history().current();
  while (edits_.canUndo()) {
    edits_.undo();
    if (auto wrong = check(false); !wrong.empty()) return "undo: " + wrong;
  }
  if (!editing::sameBits(edits_.model(), kept_.at(0))) return "undo does not end at the model that was opened";
  while (edits_.history().current() != end && edits_.canRedo()) {
    edits_.redo();
    if (auto wrong = check(false); !wrong.empty()) return "redo: " + wrong;
  }
  if (edits_.history().current() != end) return "redo does not come back to the end";
  if (!editing::sameBits(edits_.model(), kept_.at(end))) return "redo ends at another model";
  for (const auto& [state, model] : kept_) {
    edits_.returnTo(state);
    if (!editing::sameBits(edits_.model(), model)) return "a state came back with another model";
  }
  edits_.returnTo(0);
  return editing::sameBits(edits_.model(), kept_.at(0)) ? "" : "the way back does not end at the model that was opened";
}

}  // namespace tactus::tests
