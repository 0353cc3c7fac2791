#include "app/workbench/model/selection.h"

#include <algorithm>
#include <utility>

#include "app/editing/rule_edits.h"
#include "app/workbench/model/edit_controller.h"

namespace tactus::workbench {
namespace {

using fuzzy::Rule;

bool hasTerm(const fuzzy::ForceModel& model, const editing::TermPlace& place) {
  const auto variable = editing::findVariable(model, place.list.variable);
  if (!variable) return false;
  if (place.list.expert.empty()) return fuzzy::findTerm((*variable)->terms, place.term) != nullptr;
  const auto expert = editing::findExpert(model, place.list.expert);
  return expert && fuzzy::findTerm(fuzzy::termsFor(**expert, **variable), place.term) != nullptr;
}

// As the expert has the term, with a list of their own or the shared one.
bool hasTermOf(const fuzzy::ForceModel& model, const std::string& expert, const fuzzy::Condition& condition) {
  const auto of = editing::findExpert(model, expert);
  const auto variable = editing::findVariable(model, condition.input);
  return of && variable && fuzzy::findTerm(fuzzy::termsFor(**of, **variable), condition.term) != nullptr;
}

// Where a rule went. Of rules with the same conditions the one with the same consequent comes first.
std::optional<std::size_t> newPlaceOf(const Rule& rule, std::size_t was, const std::vector<Rule>& rules) {
  if (was < rules.size() && editing::sameConditions(rules[was], rule)) return was;
  std::optional<std::size_t> found;
  for (std::size_t r = rules.size(); r-- > 0;) {
    if (!editing::sameConditions(rules[r], rule)) continue;
    if (rules[r].then == rule.then) return r;
    found = r;
  }
  return found;
}

void sortOnce(std::vector<std::size_t>& indices) {
  std::sort(indices.begin(), indices.end());
  indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
}

}  // namespace

Selection::Selection(const EditController& edits, QObject* parent) : QObject(parent), edits_(edits) {
  connect(&edits_, &EditController::modelReset, this, &Selection::adoptModel);
  connect(&edits_, &EditController::changed, this, &Selection::refreshState);
  if (edits_.isOpen()) adoptModel();
}

std::optional<std::size_t> Selection::rule() const {
  return rules_.size() == 1 ? std::optional(rules_.front()) : std::nullopt;
}

const std::vector<Rule>* Selection::rulesOfExpert() const {
  if (!edits_.isOpen()) return nullptr;
  const auto expert = editing::findExpert(edits_.model(), expert_);
  return expert ? &(*expert)->rules : nullptr;
}

void Selection::setExpert(std::string id) {
  if (id == expert_ || !edits_.isOpen() || !editing::findExpert(edits_.model(), id)) return;
  expert_ = std::move(id);
  const bool had = !rules_.empty() || !gap_.empty();
  rules_.clear();
  gap_.clear();
  kept_.clear();
  emit expertChanged();
  if (had) emit rulesChanged();
}

void Selection::selectRules(std::vector<std::size_t> rules) {
  const std::vector<Rule>* const all = rulesOfExpert();
  if (all == nullptr) return;
  std::erase_if(rules, [&](std::size_t rule) { return rule >= all->size(); });
  sortOnce(rules);
  if (rules == rules_ && gap_.empty()) return;
  rules_ = std::move(rules);
  gap_.clear();
  keep();
  emit rulesChanged();
}

void Selection::selectGap(std::vector<fuzzy::Condition> conditions) {
  if (rulesOfExpert() == nullptr || conditions == gap_) return;
  const auto& model = edits_.model();
  const bool known = std::all_of(conditions.begin(), conditions.end(),
                                 [&](const auto& condition) { return hasTermOf(model, expert_, condition); });
  if (!known) return;
  rules_.clear();
  kept_.clear();
  gap_ = std::move(conditions);
  followGap(*rulesOfExpert());
  emit rulesChanged();
}

// A place that got a rule is that rule. Returns whether anything changed.
bool Selection::followGap(const std::vector<Rule>& rules) {
  if (gap_.empty()) return false;
  const auto gone = [this](const fuzzy::Condition& condition) {
    return !hasTermOf(edits_.model(), expert_, condition);
  };
  if (std::any_of(gap_.begin(), gap_.end(), gone)) {
    gap_.clear();
    return true;
  }
  Rule there;
  there.conditions = gap_;
  const auto found =
      std::find_if(rules.begin(), rules.end(), [&](const Rule& rule) { return editing::sameConditions(rule, there); });
  if (found == rules.end()) return false;
  gap_.clear();
  rules_ = {static_cast<std::size_t>(found - rules.begin())};
  keep();
  return true;
}

void Selection::pointAtRules(std::string expert, std::vector<std::size_t> rules) {
  if (!edits_.isOpen() || !editing::findExpert(edits_.model(), expert)) return;
  setExpert(std::move(expert));
  selectRules(std::move(rules));
  emit rulesPointed();
}

void Selection::pointAtTerm(editing::TermPlace term) {
  if (!edits_.isOpen() || !hasTerm(edits_.model(), term)) return;
  term_ = std::move(term);
  emit termPointed();
}

void Selection::editRules() {
  if (edits_.isOpen()) emit editAsked();
}

void Selection::editTerm(editing::TermPlace term) {
  if (!edits_.isOpen() || !hasTerm(edits_.model(), term)) return;
  emit termEditAsked();
  pointAtTerm(std::move(term));
}

void Selection::adoptModel() {
  const auto& experts = edits_.model().experts;
  const bool known = editing::findExpert(edits_.model(), expert_).has_value();
  const bool had = !rules_.empty() || !gap_.empty();
  rules_.clear();
  gap_.clear();
  kept_.clear();
  term_.reset();
  if (!known) expert_ = experts.front().id;
  if (had) emit rulesChanged();
}

void Selection::refreshState() {
  const std::vector<Rule>* const all = rulesOfExpert();
  if (all == nullptr) {
    adoptModel();
    emit expertChanged();
    return;
  }
  if (term_ && !hasTerm(edits_.model(), *term_)) term_.reset();
  std::vector<std::size_t> now;
  for (std::size_t i = 0; i < rules_.size(); ++i) {
    if (const auto place = newPlaceOf(kept_[i], rules_[i], *all)) now.push_back(*place);
  }
  sortOnce(now);
  const bool moved = now != rules_;
  rules_ = std::move(now);
  keep();
  if (followGap(*all) || moved) emit rulesChanged();
}

void Selection::keep() {
  kept_.clear();
  const std::vector<Rule>& all = *rulesOfExpert();
  for (const std::size_t rule : rules_) kept_.push_back(all[rule]);
}

}  // namespace tactus::workbench
