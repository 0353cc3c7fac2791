#include "app/workbench/model/finding_words.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "elicitation/force/noticeable_force.h"

namespace tactus::workbench {
namespace {

using elicitation::RuleFinding;
using fuzzy::Condition;
using fuzzy::Expert;
using fuzzy::ForceModel;
using fuzzy::Rule;
using fuzzy::Variable;
using Kind = RuleFinding::Kind;

const Variable* inputOf(const ForceModel& model, const std::string& id) {
  const auto it = std::find_if(model.inputs.begin(), model.inputs.end(), [&](const auto& v) { return v.id == id; });
  return it == model.inputs.end() ? nullptr : &*it;
}

// More than the items of one region.
constexpr qsizetype kMostListed = 12;

QString listed(const QStringList& numbers) {
  return numbers.mid(0, kMostListed).join(QStringLiteral(", ")) +
         (numbers.size() > kMostListed ? QStringLiteral(", …") : QString());
}

class Words {
  Q_DECLARE_TR_FUNCTIONS(FindingWords)

 public:
  Words(const ForceModel& model, const fuzzy::CompiledModel& compiled, const RuleFinding& finding)
      : model_(model), compiled_(compiled), finding_(finding), expert_(expertOf(model, finding)) {}

  QString sentence() const {
    switch (finding_.kind) {
      case Kind::kHole:
        return (expert_ == nullptr ? tr("No rule of any expert fires: %1") : tr("No rule fires: %1")).arg(where()) +
               unanswered();
      case Kind::kAbstentionJump: return jump();
      case Kind::kForceStep: return cliff();
      case Kind::kRegionWithoutRule:
      case Kind::kUnusedTerm: return tr("No rule mentions %1").arg(term()) + unanswered();
      case Kind::kMissingItem: return missing();
      case Kind::kConflict: return conflict();
      case Kind::kExpertsApart: return apart();
      case Kind::kAgainstDeclaration: return step(tr("%1: against the declared direction"));
      case Kind::kLevelJump: return step(tr("%1: three levels or more at once"));
      case Kind::kDirectionChange: return step(tr("%1: against most other steps of this expert"));
      case Kind::kDisagreement: return disagreement();
      case Kind::kRedundantRule: return rule(tr("Redundant: a rule with fewer conditions already gives %2: %1"));
      case Kind::kUnreachableRule: return rule(tr("The conditions are never true together: %1"));
      case Kind::kUnreachableTerm: return unreachableTerm();
    }
    return text(finding_.text);
  }

 private:
  const Rule* ruleAt(std::size_t source) const {
    if (expert_ == nullptr || source >= finding_.sources.size()) return nullptr;
    const auto index = finding_.sources[source].rule;
    return index && *index < expert_->rules.size() ? &expert_->rules[*index] : nullptr;
  }

  // A rule by its item of the form if the study is known, otherwise by its number.
  QString numbers() const {
    QStringList items;
    QStringList rules;
    for (const auto& source : finding_.sources) {
      if (!source.rule) continue;
      const int item = source.origin.item;
      (item > 0 ? items : rules) << QString::number(item > 0 ? item : static_cast<int>(*source.rule) + 1);
    }
    QString out;
    if (!items.isEmpty()) out += tr(" (item(s) %1)", nullptr, static_cast<int>(items.size())).arg(listed(items));
    if (!rules.isEmpty()) out += tr(" (rule(s) %1)", nullptr, static_cast<int>(rules.size())).arg(listed(rules));
    return out;
  }

  // The items without an answer that would have given a rule there.
  QString unanswered() const {
    QStringList items;
    for (const auto& source : finding_.sources) {
      if (!source.rule && source.origin.item > 0) items << QString::number(source.origin.item);
    }
    if (items.isEmpty()) return {};
    return tr("; no answer to item(s) %1", nullptr, static_cast<int>(items.size())).arg(listed(items));
  }

  QString missing() const {
    const auto* const place = std::get_if<analysis::ConditionPlace>(&finding_.where);
    if (place == nullptr) return text(finding_.text);
    const int item = finding_.sources.empty() ? 0 : finding_.sources.front().origin.item;
    return tr("No answer to item %1: %2").arg(QString::number(item), conditionsText(place->conditions));
  }

  QString termText(const Condition& condition) const {
    const Variable* const input = inputOf(model_, condition.input);
    if (input == nullptr || expert_ == nullptr) return text(condition.term);
    const fuzzy::Term* const found = fuzzy::findTerm(termsFor(*expert_, *input), condition.term);
    return found == nullptr ? text(condition.term) : labelOf(*found);
  }
  QString inputText(const std::string& id) const {
    const Variable* const input = inputOf(model_, id);
    return input == nullptr ? text(id) : labelOf(*input);
  }
  QString conditionText(const Condition& condition) const {
    return tr("%1 is %2").arg(inputText(condition.input), termText(condition));
  }
  QString conditionsText(const std::vector<Condition>& conditions) const {
    QStringList out;
    for (const Condition& condition : conditions) out << conditionText(condition);
    return out.join(tr(" and "));
  }
  QString consequentText(const Rule& rule) const {
    const fuzzy::Term* const found = fuzzy::findTerm(termsFor(*expert_, model_.output), rule.then);
    return found == nullptr ? text(rule.then) : labelOf(*found);
  }
  QString force(double force_n) const { return forceText(force_n, model_.output.unit); }

  QString where() const {
    const auto* const hole = std::get_if<analysis::Hole>(&finding_.where);
    return hole == nullptr ? text(finding_.place) : holeText(model_, *hole);
  }

  QString term() const {
    const auto [input, found] = termOfFinding(model_, finding_);
    return found == nullptr ? text(finding_.place) : tr("%1 of %2").arg(labelOf(*found), labelOf(*input));
  }

  QString jump() const {
    if (finding_.from.empty()) {
      return tr("The mean jumps where this expert abstains: %1").arg(where()) + unanswered();
    }
    return tr("The mean jumps from %1 to %2 where this expert abstains: %3")
               .arg(force(compiled_.evaluate(finding_.from).force_n), force(compiled_.evaluate(finding_.to).force_n),
                    where()) +
           unanswered();
  }

  QString cliff() const {
    const auto* const place = std::get_if<analysis::CliffPlace>(&finding_.where);
    if (place == nullptr || finding_.from.empty()) return text(finding_.text);
    const Variable& input = model_.inputs[place->input];
    const auto at = [&](const std::vector<double>& point) {
      if (expert_ == nullptr) return force(compiled_.evaluate(point).force_n);
      return force(compiled_.evaluateExpert(static_cast<std::size_t>(expert_ - model_.experts.data()), point).force_n);
    };
    if (placeText(input, place->low) == placeText(input, place->high)) {
      return tr("The force steps from %1 to %2 at once: %3 %4")
          .arg(at(finding_.from), at(finding_.to), labelOf(input), placeText(input, place->low));
    }
    return tr("The force steps from %1 to %2 within %3: %4 %5")
        .arg(at(finding_.from), at(finding_.to), quantityText(place->high - place->low, input.unit), labelOf(input),
             rangeText(input, place->low, place->high));
  }

  QString conflict() const {
    const Rule* const one = ruleAt(0);
    const Rule* const two = ruleAt(1);
    if (one == nullptr || two == nullptr) return text(finding_.text);
    return tr("%1 and %2 where %3").arg(consequentText(*one), consequentText(*two), conditionsText(one->conditions)) +
           numbers();
  }

  // Two experts, and the place is one condition or none.
  QString apart() const {
    QStringList forces;
    for (const std::string& id : finding_.experts) {
      for (std::size_t e = 0; e < model_.experts.size(); ++e) {
        if (model_.experts[e].id != id || finding_.from.empty()) continue;
        forces << tr("%1 %2").arg(labelOf(model_.experts[e]),
                                  force(compiled_.evaluateExpert(e, finding_.from).force_n));
      }
    }
    if (forces.size() != 2) return text(finding_.text);
    QString out =
        tr("%1 against %2, the mean %3").arg(forces[0], forces[1], force(compiled_.evaluate(finding_.from).force_n));
    const auto* const place = std::get_if<analysis::ConditionPlace>(&finding_.where);
    if (place == nullptr || place->conditions.empty()) return out + nearMean();
    const Condition& where = place->conditions.front();
    QString region = text(where.term);
    const Variable* const input = inputOf(model_, where.input);
    // One of the two may not have been asked about the region.
    for (const Expert& expert : model_.experts) {
      const fuzzy::Term* const found =
          input == nullptr ? nullptr : fuzzy::findTerm(termsFor(expert, *input), where.term);
      if (found != nullptr) region = labelOf(*found);
    }
    return out + tr(" where %1 is %2").arg(inputText(where.input), region) + nearMean() + notAsked(where);
  }

  // Whether an expert's own force is near the mean of the disagreeing experts: if not, the mean is no expert's force.
  QString nearMean() const {
    const double mean = compiled_.evaluate(finding_.from).force_n;
    const double noticeable = elicitation::justNoticeableDifference(std::abs(mean));
    const Expert* nearest = nullptr;
    double distance = 0;
    for (std::size_t e = 0; e < model_.experts.size(); ++e) {
      if (compiled_.weight(e) == 0) continue;
      const auto own = compiled_.evaluateExpert(e, finding_.from);
      const double apart = std::abs(own.force_n - mean);
      if (!own.fired || (nearest != nullptr && apart >= distance)) continue;
      nearest = &model_.experts[e];
      distance = apart;
    }
    if (nearest == nullptr) return {};
    return distance > noticeable ? tr("; no expert's force is near the mean")
                                 : tr("; the mean is near the force of %1").arg(labelOf(*nearest));
  }

  // An expert without a term for the region gives the force of another region's rules there.
  QString notAsked(const Condition& where) const {
    QString out;
    const Variable* const input = inputOf(model_, where.input);
    for (const Expert& expert : model_.experts) {
      const bool named =
          std::find(finding_.experts.begin(), finding_.experts.end(), expert.id) != finding_.experts.end();
      if (input == nullptr || !named || fuzzy::findTerm(termsFor(expert, *input), where.term) != nullptr) continue;
      out += tr("; %1 was not asked about this region").arg(labelOf(expert));
    }
    return out;
  }

  // The two rules differ in the term of one input.
  QString step(const QString& frame) const {
    const Rule* const before = ruleAt(0);
    const Rule* const after = ruleAt(1);
    if (before == nullptr || after == nullptr) return text(finding_.text);
    QString along;
    std::vector<Condition> others;
    for (const Condition& condition : before->conditions) {
      const auto same = [&](const Condition& c) { return c.input == condition.input; };
      const auto other = std::find_if(after->conditions.begin(), after->conditions.end(), same);
      if (other == after->conditions.end()) return text(finding_.text);
      if (other->term == condition.term) {
        others.push_back(condition);
      } else {
        along = tr("%1 from %2 to %3").arg(inputText(condition.input), termText(condition), termText(*other));
      }
    }
    QString out = tr("%1, force from %2 to %3").arg(along, consequentText(*before), consequentText(*after));
    if (!others.empty()) out += tr(" where %1").arg(conditionsText(others));
    return frame.arg(out + numbers());
  }

  QString disagreement() const {
    const auto* const place = std::get_if<analysis::InputPlace>(&finding_.where);
    const QString input = place == nullptr ? text(finding_.place) : labelOf(analysis::variableAt(model_, place->input));
    if (expert_ == nullptr || finding_.from.empty()) {
      return tr("The force goes the other way with %1 than for most experts").arg(input) + numbers();
    }
    const auto e = static_cast<std::size_t>(expert_ - model_.experts.data());
    const double change =
        compiled_.evaluateExpert(e, finding_.to).force_n - compiled_.evaluateExpert(e, finding_.from).force_n;
    return (change > 0 ? tr("The force rises with %1, for most experts it falls")
                       : tr("The force falls with %1, for most experts it rises"))
               .arg(input) +
           numbers();
  }

  QString rule(const QString& frame) const {
    const Rule* const one = ruleAt(0);
    if (one == nullptr) return text(finding_.text);
    QString out = frame;
    out.replace(QLatin1String("%1"), conditionsText(one->conditions));
    out.replace(QLatin1String("%2"), consequentText(*one));
    return out + numbers();
  }

  QString unreachableTerm() const {
    const auto [variable, found] = termOfFinding(model_, finding_);
    if (found == nullptr) return text(finding_.text);
    if (variable == &model_.output) return tr("No rule concludes %1").arg(labelOf(*found));
    return tr("%1 is outside the universe of %2").arg(labelOf(*found), labelOf(*variable));
  }

  const ForceModel& model_;
  const fuzzy::CompiledModel& compiled_;
  const RuleFinding& finding_;
  const Expert* expert_;
};

}  // namespace

QString findingSentence(const ForceModel& model, const fuzzy::CompiledModel& compiled, const RuleFinding& finding) {
  return Words(model, compiled, finding).sentence();
}

namespace {

using elicitation::RuleFinding;
using fuzzy::Expert;
using fuzzy::ForceModel;
using fuzzy::Variable;
using Kind = RuleFinding::Kind;

struct FindingNames {
  Q_DECLARE_TR_FUNCTIONS(FindingWords)
};

}  // namespace

QString kindText(RuleFinding::Kind kind) {
  switch (kind) {
    case Kind::kHole: return FindingNames::tr("Hole");
    case Kind::kAbstentionJump: return FindingNames::tr("Mean jumps");
    case Kind::kForceStep: return FindingNames::tr("Force steps");
    case Kind::kRegionWithoutRule: return FindingNames::tr("Region without a rule");
    case Kind::kMissingItem: return FindingNames::tr("Missing answer");
    case Kind::kConflict: return FindingNames::tr("Conflict");
    case Kind::kExpertsApart: return FindingNames::tr("Experts apart");
    case Kind::kAgainstDeclaration: return FindingNames::tr("Against the declaration");
    case Kind::kLevelJump: return FindingNames::tr("Level jump");
    case Kind::kDirectionChange: return FindingNames::tr("Change of direction");
    case Kind::kDisagreement: return FindingNames::tr("Disagreement");
    case Kind::kRedundantRule: return FindingNames::tr("Redundant rule");
    case Kind::kUnreachableRule: return FindingNames::tr("Rule never fires");
    case Kind::kUnreachableTerm: return FindingNames::tr("Unreachable term");
    case Kind::kUnusedTerm: return FindingNames::tr("Unused term");
  }
  return {};
}

QString findingWho(const ForceModel& model, const RuleFinding& finding) {
  QStringList out;
  for (const std::string& id : finding.experts) {
    for (const Expert& expert : model.experts) {
      if (expert.id == id) out << labelOf(expert);
    }
  }
  return out.isEmpty() ? FindingNames::tr("Mean") : out.join(FindingNames::tr(" and "));
}

QString holeText(const ForceModel& model, const analysis::Hole& hole) {
  return text(analysis::describe(hole, model, [](const Variable& input) { return labelOf(input).toStdString(); }));
}

const Expert* expertOf(const ForceModel& model, const RuleFinding& finding) {
  if (finding.experts.empty()) return nullptr;
  const auto it = std::find_if(model.experts.begin(), model.experts.end(),
                               [&](const Expert& expert) { return expert.id == finding.experts.front(); });
  return it == model.experts.end() ? nullptr : &*it;
}

PlacedTerm termOfFinding(const ForceModel& model, const RuleFinding& finding) {
  const auto* const place = std::get_if<analysis::TermPlace>(&finding.where);
  const Expert* const expert = expertOf(model, finding);
  if (place == nullptr || expert == nullptr) return {};
  const fuzzy::Term* const term = analysis::termAt(finding.where, model, *expert);
  return term == nullptr ? PlacedTerm{} : PlacedTerm{&analysis::variableAt(model, place->variable), term};
}

}  // namespace tactus::workbench
