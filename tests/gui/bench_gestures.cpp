#include "tests/gui/bench_gestures.h"

#include <QCoreApplication>
#include <bit>
#include <cstdint>
#include <limits>
#include <utility>

#include "app/editing/hole_acceptance.h"
#include "app/editing/lint_fixes.h"
#include "app/editing/partition.h"
#include "app/editing/rule_edits.h"
#include "app/editing/rule_grid.h"
#include "app/editing/same_bits.h"
#include "core/fuzzy/validate.h"
#include "core/model_io/model_file.h"
#include "elicitation/rule_lint.h"

#include "tests/support/random_model.h"

namespace tactus::tests {
namespace {

using editing::TermListId;
using workbench::Grip;
using Part = Grip::Part;

constexpr int kPoints = 6;  // at which the compiled form is compared

bool sameBits(const fuzzy::Evaluation& one, const fuzzy::Evaluation& other) {
  return one.fired == other.fired &&
         std::bit_cast<std::uint64_t>(one.force_n) == std::bit_cast<std::uint64_t>(other.force_n);
}

}  // namespace

BenchGestures::BenchGestures(std::uint64_t seed, workbench::ModelController& models, workbench::SceneController& scene,
                             workbench::EditController& edits, workbench::TermController& terms)
    : random_(seed), models_(models), scene_(scene), edits_(edits), terms_(terms) {
  kept_[edits_.history().current()] = edits_.model();
  QObject::connect(&edits_, &workbench::EditController::refused, &terms_, [this] { ++refusals_; });
}

std::string BenchGestures::play() {
  switch (random_.below(24)) {
    case 0:
    case 1:
      return editTerm();
    case 2:
    case 3:
      return editMode();
    case 4:
    case 5:
      return editRule();
    case 6:
    case 7:
      return editFreeRule();
    case 8:
    case 9:
    case 10:
      return answer();
    case 11:
      return oneIn(4) ? acceptance() : look();
    case 12:
      return oneIn(12) ? fix() : look();
    case 13:
    case 14:
    case 15:
      return travel();
    case 16:
      return steps();
    default:
      return drag();
  }
}

std::string BenchGestures::check(bool with_file) {
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
  if (!is_new && !editing::sameBits(kept->second, model)) return "a state came back with another model";
  if (!with_file) return {};
  fuzzy::ForceModel saved = model;
  editing::refreshChecks(saved, open.compiled);
  const auto read = model_io::parseModel(model_io::formatModel(saved), "fuzz");
  if (!read) return "the file does not read back: " + read.error().message();
  return editing::sameBits(read->model, saved) ? "" : "the file reads back as another model";
}

std::string BenchGestures::unwind() {
  edits_.commit();
  while (edits_.canUndo()) {
    edits_.undo();
    if (auto wrong = check(false); !wrong.empty()) return "undo: " + wrong;
  }
  if (!editing::sameBits(edits_.model(), kept_.at(0))) return "undo does not end at the model that was opened";
  while (edits_.canRedo()) {
    edits_.redo();
    if (auto wrong = check(false); !wrong.empty()) return "redo: " + wrong;
  }
  for (const auto& [state, model] : kept_) {
    edits_.returnTo(state);
    if (!editing::sameBits(edits_.model(), model)) return "a state came back with another model";
  }
  edits_.returnTo(0);
  return editing::sameBits(edits_.model(), kept_.at(0)) ? "" : "the way back does not end at the model that was opened";
}

std::string BenchGestures::drag() {
  if (terms_.terms().empty()) return "nothing";
  const std::size_t term = below(terms_.terms().size());
  Grip grip;
  grip.term = term;
  switch (random_.below(4)) {
    case 0:
      grip.part = oneIn(2) ? Part::kLeftEdge : Part::kRightEdge;
      break;
    case 1:
      break;
    default:
      grip = pick(workbench::handlesOf(terms_.terms(), term)).grip;
  }
  // A Gaussian has no edges to take hold of.
  if (!workbench::holds(terms_.terms(), grip)) return "nothing";
  const fuzzy::Variable& variable = terms_.variable();
  const double range = variable.max - variable.min;
  terms_.beginMove(grip);
  const int moves = random_.below(6);
  for (int i = 0; i < moves; ++i) {
    terms_.moveBy(number(-range, range) * (oneIn(3) ? 1 : 0.1));
    if (oneIn(8)) QCoreApplication::processEvents();
    if (oneIn(60)) edits_.undo();  // in the middle
    if (oneIn(60)) terms_.setKeepsSum(oneIn(2));
  }
  if (oneIn(6)) {
    terms_.cancelMove();
    return "drag, cancelled";
  }
  if (!oneIn(12)) terms_.endMove();  // otherwise the next gesture has to end it
  return "drag";
}

std::string BenchGestures::steps() {
  terms_.selectNext(oneIn(2) ? 1 : -1);
  const int count = random_.below(5);
  for (int i = 0; i < count; ++i) terms_.step(random_.below(7) - 3, oneIn(2));
  if (!oneIn(4)) terms_.endSteps();
  return "arrow keys";
}

std::string BenchGestures::editTerm() {
  const std::string term = termId();
  const fuzzy::Variable& variable = terms_.variable();
  switch (random_.below(7)) {
    case 0:
      terms_.add(QStringLiteral("New %1").arg(random_.below(9)), place(variable));
      return "add a term";
    case 1:
      terms_.rename(term, oneIn(4) ? QString() : QStringLiteral("Name %1").arg(random_.below(9)));
      return "rename a term";
    case 2:
      terms_.remove(term, oneIn(2));
      return "remove a term";
    case 3: {
      std::vector<double> cuts = {place(variable)};
      if (oneIn(3)) cuts.push_back(place(variable));
      terms_.split(term, cuts);
      return "split a term";
    }
    case 4:
      terms_.convert(term, fuzzy::kShapes[below(3)]);
      return "convert a term";
    default:
      terms_.setPoint(term, below(5), place(variable));
      return "type a value";
  }
}

std::string BenchGestures::editMode() {
  switch (random_.below(6)) {
    case 0:
      terms_.setLocked(termId(), below(4), oneIn(2));
      return "lock";
    case 1:
      terms_.setKeepsSum(oneIn(2));
      return "terms that sum to one";
    case 2:
      terms_.setOwnList(oneIn(2));
      return "own list";
    case 3:
      terms_.setExpert(oneIn(2) ? std::string() : someExpert());
      return "another expert";
    default:
      terms_.setVariable(someVariable().id);
      return "another variable";
  }
}

std::string BenchGestures::editRule() {
  const fuzzy::Expert& expert = pick(edits_.model().experts);
  const std::string who = expert.id;
  std::vector<std::size_t> rules;
  for (int i = random_.below(3); i >= 0; --i) rules.push_back(below(expert.rules.size() + 1));
  switch (random_.below(6)) {
    case 0:
      edits_.apply(editing::enableRules(edits_.model(), who, rules, oneIn(2)));
      return "enable rules";
    case 1:
      edits_.apply(editing::removeRules(edits_.model(), who, std::span(rules).first(1)));
      return "remove a rule";
    case 2:
      edits_.apply(editing::setRuleWeight(edits_.model(), who, rules[0], number(-0.2, 1.2)));
      return "weigh a rule";
    case 3:
      edits_.apply(editing::setConsequent(edits_.model(), who, rules[0], pick(edits_.model().output.terms).id));
      return "set a consequent";
    case 4:
      edits_.apply(editing::setExpertWeight(edits_.model(), who, number(-0.2, 2)));
      return "weigh an expert";
    default: {
      // A weight turned step by step is one gesture.
      edits_.begin();
      for (int i = 0; i < 3; ++i) {
        edits_.update(editing::setRuleWeight(edits_.base(), who, rules[0], number(0, 1)));
      }
      if (oneIn(4)) {
        edits_.cancel();
      } else {
        edits_.commit();
      }
      return "weigh a rule in steps";
    }
  }
}

fuzzy::Rule BenchGestures::someRule(const fuzzy::Expert& expert) {
  const fuzzy::ForceModel& model = edits_.model();
  fuzzy::Rule rule;
  for (std::size_t i = 1 + below(4); i > 0; --i) {
    const fuzzy::Variable& input = pick(model.inputs);
    rule.conditions.push_back({input.id, oneIn(30) ? "nowhere" : pick(termsFor(expert, input)).id});
  }
  rule.then = oneIn(30) ? "nothing" : pick(termsFor(expert, model.output)).id;
  rule.weight = oneIn(3) ? number(0, 1) : 1;
  rule.enabled = !oneIn(6);
  return rule;
}

std::string BenchGestures::editFreeRule() {
  const fuzzy::Expert& expert = pick(edits_.model().experts);
  const fuzzy::Rule rule = someRule(expert);
  if (oneIn(3)) {
    edits_.apply(editing::replaceRule(edits_.model(), expert.id, below(expert.rules.size() + 1), rule));
    return "replace a rule";
  }
  edits_.apply(editing::addRule(edits_.model(), expert.id, rule));
  return "add a rule";
}

std::string BenchGestures::answer() {
  const fuzzy::ForceModel& model = edits_.model();
  const fuzzy::Expert& expert = pick(model.experts);
  const fuzzy::Variable& condition = pick(model.inputs);
  const fuzzy::Variable& region = pick(model.inputs);
  const editing::CellPlace cell{pick(termsFor(expert, condition)).id, pick(termsFor(expert, region)).id};
  std::optional<std::string> then;
  if (!oneIn(5)) then = pick(termsFor(expert, model.output)).id;
  edits_.apply(editing::setAnswer(model, {expert.id, condition.id, region.id}, cell, then));
  return "answer a cell";
}

std::string BenchGestures::acceptance() {
  const fuzzy::ForceModel& model = edits_.model();
  const auto holes = editing::holeNames(model);
  if (oneIn(3)) {
    edits_.apply(editing::forgetLapsed(model));
  } else if (!model.accepted_holes.empty() && oneIn(2)) {
    edits_.apply(editing::withdrawAcceptance(model, pick(model.accepted_holes)));
  } else if (holes && !holes->empty()) {
    edits_.apply(editing::acceptHole(model, pick(*holes)));
  }
  return "accept a hole";
}

std::string BenchGestures::fix() {
  edits_.commit();
  const auto compiled = models_.current()->compiled;
  const auto lint = elicitation::ruleLint(edits_.model(), compiled);
  if (lint.findings.empty()) return "nothing found";
  auto fixes = editing::fixesFor(edits_.model(), compiled, pick(lint.findings));
  if (fixes.empty()) return "nothing to fix";
  edits_.apply(std::move(fixes[below(fixes.size())].edit));
  return "fix";
}

std::string BenchGestures::travel() {
  if (oneIn(5) && !kept_.empty()) {
    auto it = kept_.begin();
    std::advance(it, static_cast<std::ptrdiff_t>(below(kept_.size())));
    edits_.returnTo(it->first);
    return "return";
  }
  const bool back = oneIn(2);
  for (int i = random_.below(4); i >= 0; --i) back ? edits_.undo() : edits_.redo();
  return back ? "undo" : "redo";
}

std::string BenchGestures::look() {
  const auto input = below(edits_.model().inputs.size());
  scene_.setValue(input, place(edits_.model().inputs[input]));
  if (oneIn(4)) scene_.setXInput(input);
  scene_.reading();
  if (oneIn(20)) scene_.curves();
  return "look elsewhere";
}

double BenchGestures::number(double from, double to) {
  if (oneIn(40)) {
    constexpr double kOdd[] = {
        std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -1e308, 1e200, -0.0, 5e-324};
    return kOdd[below(6)];
  }
  return random_.uniform(from, to);
}

double BenchGestures::place(const fuzzy::Variable& variable) {
  const double range = variable.max - variable.min;
  return oneIn(5) ? number(variable.min - range, variable.max + range) : number(variable.min, variable.max);
}

std::string BenchGestures::termId() { return oneIn(30) ? "nowhere" : pick(terms_.terms()).id; }

const fuzzy::Variable& BenchGestures::someVariable() {
  const std::size_t index = below(edits_.model().inputs.size() + 1);
  return index < edits_.model().inputs.size() ? edits_.model().inputs[index] : edits_.model().output;
}

}  // namespace tactus::tests
