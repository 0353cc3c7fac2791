#include "app/workbench/tune/terms/term_controller.h"

#include <QString>
#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include "app/editing/edit.h"
#include "app/editing/term_edits.h"
#include "app/workbench/base/display_text.h"
#include "core/fuzzy/membership.h"

namespace tactus::workbench {
namespace {

// The id of a new term, from the label that a person typed.

constexpr std::size_t kLongestId = 48;  // bytes; leaves room for a number behind it

/// `Upper esophagus` becomes `upper_esophagus`; letters and digits of ASCII stay, at most 48 bytes; `term` if none is
/// left.
std::string termIdFrom(const QString& label) {
  std::string id;
  for (const QChar letter : label.toLower()) {
    const char c = letter.toLatin1();
    const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
    if (plain) {
      id += c;
    } else if (!id.empty() && id.back() != '_') {
      id += '_';
    }
    if (id.size() == kLongestId) break;
  }
  while (!id.empty() && id.back() == '_') id.pop_back();
  return id.empty() ? "term" : id;
}

using editing::TermListId;
using editing::VertexPlace;
using fuzzy::Shape;
using fuzzy::Term;
using Part = Grip::Part;

// A lock belongs to a corner; the corners of another shape are others.
void unlock(std::vector<VertexPlace>& locked, const TermListId& list, const std::string& term) {
  std::erase_if(locked, [&](const VertexPlace& place) { return place.list == list && place.term == term; });
}

double startOf(const std::vector<Term>& terms, const Grip& grip) {
  return terms[grip.term].points[pointsOf(terms, grip).front()];
}

}  // namespace

TermController::TermController(EditController& edits, QObject* parent) : QObject(parent), edits_(edits) {
  connect(&edits_, &EditController::modelReset, this, &TermController::adoptModel);
  connect(&edits_, &EditController::changed, this, &TermController::refreshState);
  if (edits_.isOpen()) adoptModel();
}

const fuzzy::Variable& TermController::variable() const { return **editing::findVariable(model(), list_.variable); }

const std::vector<Term>& TermController::terms() const { return termsIn(model()); }

const std::vector<Term>& TermController::termsIn(const fuzzy::ForceModel& model) const {
  const fuzzy::Variable& variable = **editing::findVariable(model, list_.variable);
  if (list_.expert.empty()) return variable.terms;
  return fuzzy::termsFor(**editing::findExpert(model, list_.expert), variable);
}

std::vector<std::string> TermController::readers() const {
  std::vector<std::string> out;
  for (const std::size_t e : editing::readersOf(model(), list_)) out.push_back(model().experts[e].id);
  return out;
}

bool TermController::isSharedWithOthers() const {
  return isOpen() && !expert_.empty() && list_.expert.empty() && editing::readersOf(model(), list_).size() > 1;
}

bool TermController::editsForAll() const {
  return std::find(for_all_.begin(), for_all_.end(), TermListId{list_.variable, expert_}) != for_all_.end();
}

void TermController::chooseScope(bool for_all) {
  const auto edit = std::exchange(pending_, nullptr);
  if (!isSharedWithOthers()) return;
  const TermListId of_expert{list_.variable, expert_};
  std::erase(for_all_, of_expert);
  if (for_all) {
    for_all_.push_back(of_expert);
  } else {
    setOwnList(true);
  }
  emit scopeChosen();
  if (edit && (for_all || !isSharedWithOthers())) edit();
}

// The terms of three experts must not move when the user means those of one.
bool TermController::waitsForScope(std::function<void()> edit) {
  if (!isSharedWithOthers() || editsForAll()) return false;
  pending_ = std::move(edit);
  emit scopeAsked();
  return true;
}

std::size_t TermController::rulesOf(const std::string& term) const {
  std::size_t count = 0;
  for (const fuzzy::Expert& expert : model().experts) {
    if (!editing::reads(expert, list_)) continue;
    count += static_cast<std::size_t>(std::count_if(expert.rules.begin(), expert.rules.end(), [&](const auto& rule) {
      return editing::names(rule, model(), variable(), term);
    }));
  }
  return count;
}

bool TermController::isLocked(const std::string& term, std::size_t point) const {
  return std::find(locked_.begin(), locked_.end(), VertexPlace{list_, term, point}) != locked_.end();
}

bool TermController::keepsSum() const {
  const bool off = std::find(sum_not_kept_.begin(), sum_not_kept_.end(), list_) != sum_not_kept_.end();
  return !off && editing::partitionOrder(variable(), terms()).has_value();
}

void TermController::setVariable(std::string id) {
  if (id == list_.variable) return;
  edits_.commit();
  pending_ = nullptr;
  list_.variable = std::move(id);
  resolveList();
  selected_.reset();
  emit listChanged();
}

void TermController::setExpert(std::string id) {
  if (id == expert_) return;
  edits_.commit();
  pending_ = nullptr;
  expert_ = std::move(id);
  resolveList();
  selected_.reset();
  emit listChanged();
}

void TermController::select(std::optional<Grip> grip) {
  if (grip && !holds(terms(), *grip)) grip.reset();
  if (grip == selected_) return;
  selected_ = grip;
  emit selectionChanged();
}

void TermController::selectNext(int direction) {
  std::vector<Grip> all;
  for (std::size_t t = 0; t < terms().size(); ++t) {
    for (const GripHandle& handle : handlesOf(terms(), t)) all.push_back(handle.grip);
  }
  const auto now = selected_ ? std::find(all.begin(), all.end(), *selected_) : all.end();
  if (now == all.end()) {
    // An edge or a whole term leads to the first handle of its term.
    const std::size_t term = selected_ ? selected_->term : 0;
    const auto first = std::find_if(all.begin(), all.end(), [term](const Grip& grip) { return grip.term == term; });
    if (first != all.end()) select(*first);
    return;
  }
  const auto count = static_cast<std::ptrdiff_t>(all.size());
  const auto next = (now - all.begin() + direction + count) % count;
  select(all[static_cast<std::size_t>(next)]);
}

void TermController::setLocked(std::string term, std::size_t point, bool locked) {
  const VertexPlace place{list_, term, point};
  if (isLocked(term, point) == locked) return;
  if (locked) {
    locked_.push_back(place);
  } else {
    std::erase(locked_, place);
  }
  emit locksChanged();
}

void TermController::setKeepsSum(bool keeps) {
  const bool edits = keeps && !editing::partitionOrder(variable(), terms());
  if (edits && waitsForScope([this, keeps] { setKeepsSum(keeps); })) {
    emit termsChanged();
    return;
  }
  std::erase(sum_not_kept_, list_);
  if (!keeps) sum_not_kept_.push_back(list_);
  if (edits) edits_.apply(editing::makeSumToOne(model(), list_));
  emit termsChanged();
}

void TermController::beginMove(const Grip& grip) {
  endSteps();
  select(grip);
  // The drag begins anew once it is known for whom it is.
  if (waitsForScope(nullptr)) return;
  edits_.begin();
  moving_ = grip;
}

void TermController::moveBy(double by) {
  if (moving_ && edits_.inGesture()) edits_.update(moved(*moving_, by));
}

void TermController::endMove() {
  moving_.reset();
  stepping_ = false;
  edits_.commit();
}

void TermController::cancelMove() {
  moving_.reset();
  stepping_ = false;
  edits_.cancel();
}

base::Result<editing::Edit> TermController::moved(const Grip& grip, double by) const {
  const fuzzy::ForceModel& base = edits_.base();
  const std::string& term = terms()[grip.term].id;
  const auto place = [&](double value) { return roundedPlace(variable(), value); };
  switch (grip.part) {
    case Part::kVertex: {
      const VertexPlace vertex{list_, term, grip.point};
      const double from = termsIn(base)[grip.term].points[grip.point];
      const double to = from + (grip.mirrored ? -by : by);
      // A hand that is back where it began leaves the value as it was, rounded or not.
      return editing::moveVertex(base, vertex, place(by) == 0 ? from : place(to), options());
    }
    case Part::kLeftEdge: return editing::moveEdge(base, placeOf(term), editing::Side::kLeft, place(by), options());
    case Part::kRightEdge: return editing::moveEdge(base, placeOf(term), editing::Side::kRight, place(by), options());
    case Part::kTerm: break;
  }
  return editing::moveTerm(base, placeOf(term), place(by), options());
}

void TermController::step(int count, bool coarse) {
  const auto again = [this, count, coarse] {
    step(count, coarse);
    endSteps();
  };
  if (selected_ && waitsForScope(again)) return;
  if (!selected_ || (moving_ && !stepping_ && edits_.inGesture())) return;
  if (!stepping_ || !edits_.inGesture()) {
    edits_.begin();
    moving_ = selected_;
    stepping_ = true;
    stepped_by_ = 0;
  }
  const Grip grip = *moving_;
  const double start = startOf(terms(), grip);
  const double step = editing::editStep(variable(), coarse ? editing::StepSize::kCoarse : editing::StepSize::kFine);
  const int direction = grip.mirrored ? -count : count;
  if (grip.part == Part::kVertex) {
    edits_.update(editing::moveVertex(edits_.base(), {list_, terms()[grip.term].id, grip.point},
                                      editing::stepped(start, step, direction), options()));
    return;
  }
  const double by = editing::stepped(stepped_by_, step, direction);
  if (edits_.update(moved(grip, by)) && edits_.stopped().isEmpty()) stepped_by_ = by;
}

void TermController::endSteps() {
  if (stepping_) endMove();
}

void TermController::setPoint(std::string term, std::size_t point, double value) {
  endSteps();
  if (waitsForScope([=, this] { setPoint(term, point, value); })) return;
  edits_.apply(editing::moveVertex(model(), {list_, term, point}, value, options()));
}

void TermController::convert(std::string term, Shape shape) {
  endSteps();
  if (waitsForScope([=, this] { convert(term, shape); })) return;
  if (edits_.apply(editing::convertShape(model(), placeOf(term), shape))) {
    unlock(locked_, list_, term);
    emit locksChanged();
  }
}

void TermController::add(const QString& label, double at) {
  endSteps();
  if (waitsForScope([=, this] { add(label, at); })) return;
  const std::string id = editing::freeTermId(terms(), termIdFrom(label));
  const std::string name = label.trimmed().toStdString();
  if (!keepsSum()) {
    Term term = editing::suggestedTerm(variable(), terms(), at);
    term.id = id;
    term.label = name;
    if (edits_.apply(editing::addTerm(model(), list_, term))) selectTerm(id);
    return;
  }
  // Terms that sum to one make room: the one that holds the place in full is cut there, and keeps its rules.
  const auto full = std::find_if(terms().begin(), terms().end(),
                                 [at](const Term& term) { return fuzzy::MembershipFunction::of(term)(at) == 1; });
  if (full == terms().end()) {
    edits_.refuse(tr("%1: no term holds %2 in full, so none can make room there. Choose a place inside a term, or "
                     "switch off that the terms sum to one.")
                      .arg(labelOf(variable()), placeText(variable(), at)));
    return;
  }
  const auto shape = fuzzy::MembershipFunction::of(*full);
  const double from = std::max(shape.b, variable().min);
  const double to = std::min(shape.c, variable().max);
  const editing::TermName old_name{full->id, full->label};
  editing::SplitOptions options;
  options.cuts = {at};
  options.copy_rules = false;
  // The rules stay with the part that holds the middle; so does the name.
  options.names = at > (from + to) / 2 ? std::vector<editing::TermName>{old_name, {id, name}}
                                       : std::vector<editing::TermName>{{id, name}, old_name};
  if (edits_.apply(editing::splitTerm(model(), placeOf(full->id), options))) selectTerm(id);
}

void TermController::rename(std::string term, const QString& label) {
  endSteps();
  if (waitsForScope([=, this] { rename(term, label); })) return;
  edits_.apply(editing::renameTerm(model(), placeOf(term), term, label.trimmed().toStdString()));
}

void TermController::remove(std::string term, bool with_rules) {
  endSteps();
  if (waitsForScope([=, this] { remove(term, with_rules); })) return;
  editing::RemoveOptions options;
  options.rules = with_rules ? editing::RulesOfTerm::kRemove : editing::RulesOfTerm::kRefuse;
  options.sum_to_one = keepsSum();
  edits_.apply(editing::removeTerm(model(), placeOf(term), options));
}

QString TermController::whyNotSplit(const std::string& term, const std::vector<double>& cuts) const {
  editing::SplitOptions options;
  options.cuts = cuts;
  const auto edit = editing::splitTerm(model(), placeOf(term), options);
  return edit ? QString() : text(edit.error().message());
}

// A new term is the one that the user goes on with.
void TermController::selectTerm(const std::string& id) {
  const auto& all = terms();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Term& term) { return term.id == id; });
  if (found != all.end()) select(Grip{static_cast<std::size_t>(found - all.begin()), Part::kTerm});
}

void TermController::split(std::string term, const std::vector<double>& cuts) {
  endSteps();
  if (waitsForScope([=, this] { split(term, cuts); })) return;
  editing::SplitOptions options;
  options.cuts = cuts;
  edits_.apply(editing::splitTerm(model(), placeOf(term), options));
}

void TermController::setOwnList(bool own) {
  if (expert_.empty() || own == !list_.expert.empty()) return;
  endSteps();
  const TermListId of_expert{list_.variable, expert_};
  edits_.apply(own ? editing::makeOwn(model(), of_expert)
                   : editing::backToShared(model(), of_expert, editing::RulesOfTerm::kRefuse));
}

editing::MoveOptions TermController::options() const { return {keepsSum(), locked_}; }

void TermController::adoptModel() {
  expert_.clear();
  locked_.clear();
  sum_not_kept_.clear();
  for_all_.clear();
  pending_ = nullptr;
  moving_.reset();
  stepping_ = false;
  selected_.reset();
  const bool known = isOpen() && editing::findVariable(model(), list_.variable).has_value();
  if (isOpen() && !known) {
    // Where a person most likely begins: the way of the tube.
    list_.variable = model().inputs[fuzzy::wayOf(model().inputs).value_or(0)].id;
  }
  resolveList();
  emit listChanged();
}

void TermController::refreshState() {
  // Undo or another edit has ended the move.
  if (!edits_.inGesture()) {
    moving_.reset();
    stepping_ = false;
  }
  const TermListId before = list_;
  resolveList();
  if (selected_ && !holds(terms(), *selected_)) selected_.reset();
  if (list_ == before) {
    emit termsChanged();
  } else {
    emit listChanged();
  }
}

void TermController::resolveList() {
  list_.expert.clear();
  if (!isOpen() || expert_.empty()) return;
  const auto expert = editing::findExpert(model(), expert_);
  if (expert) {
    list_ = editing::listOf(**expert, list_.variable);
  } else {
    expert_.clear();
  }
}

}  // namespace tactus::workbench
