#include "app/workbench/controllers/finding_words.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <utility>

#include "app/workbench/display_text.h"

namespace tactus::workbench {
namespace {

using elicitation::RuleFinding;
using fuzzy::Condition;
using fuzzy::Expert;
using fuzzy::ForceModel;
using fuzzy::Rule;
using fuzzy::Variable;
using Kind = RuleFinding::Kind;

QString tr(const char* text) { return QCoreApplication::translate("FindingWords", text); }

const Variable* inputOf(const ForceModel& model, const std::string& id) {
  const auto it = std::find_if(model.inputs.begin(), model.inputs.end(), [&](const auto& v) { return v.id == id; });
  return it == model.inputs.end() ? nullptr : &*it;
}

class Words {
 public:
  Words(const ForceModel& model, const fuzzy::CompiledModel& compiled, const RuleFinding& finding)
      : model_(model), compiled_(compiled), finding_(finding), expert_(expertOf(model, finding)) {}

  QString sentence() const {
    switch (finding_.kind) {
      case Kind::kHole:
        return (expert_ == nullptr ? tr("No rule of any expert fires: %1") : tr("No rule fires: %1"))
            .arg(holeText(model_, finding_.place));
      case Kind::kAbstentionJump:
        return jump();
      case Kind::kRegionWithoutRule:
      case Kind::kUnusedTerm:
        return tr("No rule mentions %1").arg(term());
      case Kind::kConflict:
        return conflict();
      case Kind::kExpertsApart:
        return apart();
      case Kind::kAgainstDeclaration:
        return step(tr("%1: against the declared direction"));
      case Kind::kLevelJump:
        return step(tr("%1: three levels or more at once"));
      case Kind::kDirectionChange:
        return step(tr("%1: against most other steps of this expert"));
      case Kind::kDisagreement:
        return disagreement();
      case Kind::kRedundantRule:
        return rule(tr("Another rule with fewer conditions already says %2: %1"));
      case Kind::kUnreachableRule:
        return rule(tr("The conditions are never true together: %1"));
      case Kind::kUnreachableTerm:
        return unreachableTerm();
      case Kind::kMissingItem:
        break;
    }
    return text(finding_.text);
  }

 private:
  const Rule* ruleAt(std::size_t source) const {
    if (expert_ == nullptr || source >= finding_.sources.size()) return nullptr;
    const auto index = finding_.sources[source].rule;
    return index && *index < expert_->rules.size() ? &expert_->rules[*index] : nullptr;
  }

  QString numbers() const {
    QStringList out;
    for (const auto& source : finding_.sources) {
      if (source.rule) out << QString::number(*source.rule + 1);
    }
    if (out.isEmpty()) return {};
    return (out.size() == 1 ? tr(" (rule %1)") : tr(" (rules %1)")).arg(out.join(QStringLiteral(", ")));
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

  QString term() const {
    if (expert_ == nullptr) return text(finding_.place);
    const auto [input, found] = termOfPlace(model_, *expert_, finding_.place);
    return found == nullptr ? text(finding_.place) : tr("%1 of %2").arg(labelOf(*found), labelOf(*input));
  }

  QString jump() const {
    const QString where = holeText(model_, finding_.place);
    if (finding_.from.empty()) return tr("The mean jumps where this expert abstains: %1").arg(where);
    return tr("The mean jumps from %1 to %2 where this expert abstains: %3")
        .arg(force(compiled_.evaluate(finding_.from).force_n), force(compiled_.evaluate(finding_.to).force_n), where);
  }

  QString conflict() const {
    const Rule* const one = ruleAt(0);
    const Rule* const two = ruleAt(1);
    if (one == nullptr || two == nullptr) return text(finding_.text);
    return tr("%1 and %2 where %3").arg(consequentText(*one), consequentText(*two), conditionsText(one->conditions)) +
           numbers();
  }

  // Two experts, and the place is a condition or `everywhere`.
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
    const auto is = finding_.place.find(" is ");
    if (is == std::string::npos) return out;
    Condition where{finding_.place.substr(0, is), finding_.place.substr(is + 4)};
    QString region = text(where.term);
    const Variable* const input = inputOf(model_, where.input);
    // One of the two may not have been asked about the region.
    for (const Expert& expert : model_.experts) {
      const fuzzy::Term* const found =
          input == nullptr ? nullptr : fuzzy::findTerm(termsFor(expert, *input), where.term);
      if (found != nullptr) region = labelOf(*found);
    }
    return out + tr(" where %1 is %2").arg(inputText(where.input), region);
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
    const QString input = inputText(finding_.place);
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
    if (expert_ != nullptr) {
      const auto [input, found] = termOfPlace(model_, *expert_, finding_.place);
      if (found != nullptr) return tr("%1 lies outside the universe of %2").arg(labelOf(*found), labelOf(*input));
      for (const fuzzy::Term& one : termsFor(*expert_, model_.output)) {
        if (finding_.place == model_.output.id + ' ' + one.id) return tr("No rule concludes %1").arg(labelOf(one));
      }
    }
    return text(finding_.text);
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

QString findingWho(const ForceModel& model, const RuleFinding& finding) {
  QStringList out;
  for (const std::string& id : finding.experts) {
    for (const Expert& expert : model.experts) {
      if (expert.id == id) out << labelOf(expert);
    }
  }
  return out.isEmpty() ? tr("Mean") : out.join(tr(" and "));
}

QString holeText(const ForceModel& model, const std::string& name) {
  QStringList parts = text(name).split(QStringLiteral(", "));
  for (QString& part : parts) {
    for (const Variable& input : model.inputs) {
      const QString start = text(input.id) + QLatin1Char(' ');
      if (!part.startsWith(start)) continue;
      part = labelOf(input) + QLatin1Char(' ') + part.mid(start.size());
      break;
    }
  }
  return parts.join(QStringLiteral(", "));
}

const Expert* expertOf(const ForceModel& model, const RuleFinding& finding) {
  if (finding.experts.empty()) return nullptr;
  const auto it = std::find_if(model.experts.begin(), model.experts.end(),
                               [&](const Expert& expert) { return expert.id == finding.experts.front(); });
  return it == model.experts.end() ? nullptr : &*it;
}

PlacedTerm termOfPlace(const ForceModel& model, const Expert& expert, const std::string& place) {
  for (const Variable& input : model.inputs) {
    for (const fuzzy::Term& term : termsFor(expert, input)) {
      if (place == input.id + ' ' + term.id) return {&input, &term};
    }
  }
  return {};
}

}  // namespace tactus::workbench
