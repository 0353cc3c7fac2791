// Gestures with rules: in the editor, in free form, and those that settle findings.
#include <QTest>
#include <utility>

#include "app/editing/rule_edits.h"
#include "app/editing/rule_grid.h"
#include "app/editing/step_fixes.h"

#include "tests/gui/bench_gestures.h"
#include "tests/gui/patience.h"

namespace tactus::tests {

using tests::kPatience;

// What keys and mouse do in the rule editor.
std::string BenchGestures::grid() {
  const std::size_t count = rules_.expert().rules.size();
  const std::size_t rule = below(count + 1);
  const auto cell = [&] { return workbench::RuleCell{below(4), below(6), below(6)}; };
  switch (random_.below(16)) {
    case 0: rules_.setExpert(oneIn(20) ? "nobody" : someExpert()); return "rules of another expert";
    case 1: rules_.setRegion(oneIn(20) ? "nowhere" : pick(edits_.model().inputs).id); return "another region";
    case 2: rules_.select(oneIn(10) ? std::nullopt : std::optional(cell())); return "a cell";
    case 3:
      rules_.step(random_.below(5) - 2, random_.below(5) - 2);
      rules_.stepGrid(oneIn(2) ? 1 : -1);
      return "another cell";
    case 4:
      rules_.stepToEnd(oneIn(2));
      rules_.goOn();
      return "the last cell";
    case 5:
      rules_.answer(oneIn(4) ? std::nullopt : std::optional(below(rules_.words().size() + 1)));
      return "answer the cell";
    case 6: rules_.setConsequent({rule}, oneIn(30) ? "nothing" : pick(rules_.words()).id); return "another consequent";
    case 7: rules_.setWeight({rule}, number(-0.2, 1.2)); return "type a weight";
    case 8:
      for (int i = random_.below(4); i >= 0; --i) rules_.weigh(rule, number(-0.1, 1.1));
      if (oneIn(2)) rules_.endWeighing();
      return "turn a weight";
    case 9: rules_.enable({rule}, oneIn(2)); return "enable a rule of the list";
    case 10: rules_.remove({rule}); return "remove a rule of the list";
    case 11: rules_.add(someRule(rules_.expert())); return "add a rule with the form";
    case 12: rules_.replace(rule, someRule(rules_.expert())); return "rewrite a rule with the form";
    case 13:
      rules_.selection().selectRules({rule, below(count + 1)});
      rules_.paste(oneIn(10) ? QStringLiteral("IF nothing") : rules_.copied());
      return "copy and paste rules";
    case 14:
      rules_.selection().pointAtRules(someExpert(), {rule});
      rules_.goWhereItActs();
      return "point at a rule and go there";
    default:
      rules_.select(cell());
      rules_.answerAndGoOn(below(rules_.words().size()));
      return "answer and go on";
  }
}

std::string BenchGestures::editRule() {
  const fuzzy::Expert& expert = pick(edits_.model().experts);
  const std::string who = expert.id;
  std::vector<std::size_t> rules;
  for (int i = random_.below(3); i >= 0; --i) rules.push_back(below(expert.rules.size() + 1));
  switch (random_.below(6)) {
    case 0: edits_.apply(editing::enableRules(edits_.model(), who, rules, oneIn(2))); return "enable rules";
    case 1: edits_.apply(editing::removeRules(edits_.model(), who, std::span(rules).first(1))); return "remove a rule";
    case 2:
      edits_.apply(editing::setRuleWeight(edits_.model(), who, rules[0], number(-0.2, 1.2)));
      return "weigh a rule";
    case 3:
      edits_.apply(editing::setConsequent(edits_.model(), who, rules[0], pick(edits_.model().output.terms).id));
      return "set a consequent";
    case 4: edits_.apply(editing::setExpertWeight(edits_.model(), who, number(-0.2, 2))); return "weigh an expert";
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

std::string BenchGestures::contract() {
  const fuzzy::ForceModel& model = edits_.model();
  const std::size_t index = below(model.contracts.size() + 1);
  fuzzy::Contract made;
  made.kind = fuzzy::kContractKinds[below(std::size(fuzzy::kContractKinds))];
  const fuzzy::Variable& input = pick(model.inputs);
  made.input = input.id;
  made.word = pick(input.terms).id;
  made.than = pick(input.terms).id;
  made.within = number(0, 2);
  made.limit = number(0, 1);
  if (oneIn(3)) {
    edits_.apply(editing::removeContract(model, index));
  } else if (oneIn(2)) {
    edits_.apply(editing::replaceContract(model, index, made));
  } else {
    edits_.apply(editing::addContract(model, made));
  }
  return "write a contract";
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

// A click on a finding and one on a button below it.
std::string BenchGestures::fix() {
  edits_.commit();
  workbench::FindingsController& findings = bench_.findings;
  findings.setWatched(true);
  if (!QTest::qWaitFor([&] { return findings.isCurrent(); }, kPatience)) broken_ = "no lint";
  std::string what = "no finding";
  if (!findings.findings().empty()) {
    findings.choose(below(findings.findings().size()));
    const bool ended =
        QTest::qWaitFor([&] { return findings.isCurrent() && !findings.isLookingForFixes(); }, kPatience);
    if (!ended) broken_ = "no end of looking for fixes";
    what = "no fix";
  }
  if (const std::size_t count = findings.fixes().size(); count > 0) {
    const std::size_t choice = below(count);
    what = "fix: " + findings.fixes()[choice].what.toStdString();
    if (!findings.apply(choice)) broken_ = "a fix was refused";
  }
  findings.setWatched(false);
  return what;
}

}  // namespace tactus::tests
