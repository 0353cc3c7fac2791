// Contracts in words, with the labels of the model, and those that are offered.
#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/editing/edit.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/model/open_model.h"
#include "app/workbench/tune/contracts/contracts_controller.h"
#include "core/base/text.h"
#include "elicitation/rules/rule_lint.h"

namespace tactus::workbench {
namespace {

using contracts::ForcePlace;
using contracts::Verdict;
using fuzzy::Contract;
using ContractKind = fuzzy::Contract::Kind;

struct ContractText {
  Q_DECLARE_TR_FUNCTIONS(ContractText)
};

QString inputName(const fuzzy::ForceModel& model, const std::string& id) {
  const auto input = inputNamed(model, id);
  return input ? labelOf(model.inputs[*input]) : harmless(spelled(id));
}

QString wordName(const fuzzy::ForceModel& model, const std::string& input_id, const std::string& id) {
  const auto input = inputNamed(model, input_id);
  const fuzzy::Term* const term = input ? fuzzy::findTerm(model.inputs[*input].terms, id) : nullptr;
  return term != nullptr ? labelOf(*term) : harmless(spelled(id));
}

QString roundedForce(double force_n, const std::string& unit) {
  constexpr double kSmall = 1e-3;
  const QString number =
      std::abs(force_n) < kSmall ? QString::number(force_n, 'g', 2) : text(base::roundedNumber(force_n));
  return (number + QLatin1Char(' ') + unitText(unit)).trimmed();
}

/// `Tube lubrication 0.4`.
QString valueText(const fuzzy::Variable& input, double value) {
  return ContractText::tr("%1 %2").arg(labelOf(input), text(editing::quantityText(input, value)));
}

/// The values of all inputs but `along`.
QString placeWords(const fuzzy::ForceModel& model, const std::vector<double>& place,
                   std::optional<std::size_t> along = std::nullopt) {
  QStringList out;
  for (std::size_t i = 0; i < place.size(); ++i) {
    if (i != along) out << valueText(model.inputs[i], place[i]);
  }
  return out.join(QStringLiteral(", "));
}

QString forceWords(const fuzzy::ForceModel& model, const ForcePlace& place) {
  const QString force = forceText(place.force.force_n, model.output.unit);
  return place.force.fired ? force : ContractText::tr("%1 (no rule fires)").arg(force);
}

QString counterexample(const fuzzy::ForceModel& model, const contracts::ContractResult& result) {
  const auto& places = result.counterexample;
  const QString by = roundedForce(result.excess_n, model.output.unit);
  if (places.size() == 1) {
    const QString at = placeWords(model, places[0].inputs);
    if (!places[0].force.fired && result.excess_n == 0) return ContractText::tr("No rule fires at %1.").arg(at);
    return ContractText::tr("By %1: the force is %2 at %3.").arg(by, forceWords(model, places[0]), at);
  }
  if (places.size() != 2) return {};
  const auto differs = std::mismatch(places[0].inputs.begin(), places[0].inputs.end(), places[1].inputs.begin());
  const auto along = static_cast<std::size_t>(differs.first - places[0].inputs.begin());
  if (along >= model.inputs.size()) return {};
  const fuzzy::Variable& input = model.inputs[along];
  const auto value = [&](std::size_t place) { return text(editing::quantityText(input, places[place].inputs[along])); };
  const QString sentence =
      ContractText::tr("By %1: with %2 %3 the force is %4, with %5 it is %6")
          .arg(by, labelOf(input), value(0), forceWords(model, places[0]), value(1), forceWords(model, places[1]));
  const QString others = placeWords(model, places[0].inputs, along);
  return others.isEmpty() ? ContractText::tr("%1.").arg(sentence)
                          : ContractText::tr("%1, at %2.").arg(sentence, others);
}

/// 1 for 1.1, 20 for 23.
double roundedDown(double value) {
  if (!(value > 0)) return value;
  const double digit = std::pow(10, std::floor(std::log10(value)));
  return std::floor(value / digit) * digit;
}

bool says(const Contract& one, Contract other) {
  other.id = one.id;
  return one == other;
}

}  // namespace

QString contractSentence(const fuzzy::ForceModel& model, const Contract& contract) {
  const QString input = inputName(model, contract.input);
  const QString limit = contract.limit_in_jnd ? ContractText::tr("%1 JND").arg(exactText(contract.limit, {}))
                                              : exactText(contract.limit, model.output.unit);
  const auto word = [&](const std::string& id) { return wordName(model, contract.input, id); };
  QString sentence;
  switch (contract.kind) {
    case ContractKind::kNeverRaises: sentence = ContractText::tr("More “%1” never raises the force").arg(input); break;
    case ContractKind::kNeverLowers: sentence = ContractText::tr("More “%1” never lowers the force").arg(input); break;
    case ContractKind::kNeverHarder:
      sentence =
          ContractText::tr("%1: “%2” is never harder than “%3”").arg(input, word(contract.word), word(contract.than));
      break;
    case ContractKind::kNoStep: {
      const auto index = inputNamed(model, contract.input);
      sentence = ContractText::tr("The force never changes by more than %1 within %2 of “%3”")
                     .arg(limit, exactText(contract.within, index ? model.inputs[*index].unit : std::string()), input);
      break;
    }
    case ContractKind::kNeverAbove: sentence = ContractText::tr("The force is never above %1").arg(limit); break;
    case ContractKind::kNeverBelow: sentence = ContractText::tr("The force is never below %1").arg(limit); break;
    case ContractKind::kNeverSilent:
      sentence = ContractText::tr("The model is never silent: some rule fires everywhere");
      break;
  }
  QStringList where;
  for (const fuzzy::Condition& one : contract.where) {
    where << ContractText::tr("“%1” is “%2”").arg(inputName(model, one.input), wordName(model, one.input, one.term));
  }
  if (where.isEmpty()) return sentence;
  return ContractText::tr("%1, where %2").arg(sentence, where.join(ContractText::tr(" and ")));
}

QString contractDetails(const fuzzy::ForceModel& model, const contracts::ContractResult& result) {
  switch (result.verdict) {
    case Verdict::kProved: return {};
    case Verdict::kViolated: return counterexample(model, result);
    case Verdict::kOpen: break;
  }
  const QString reason = text(result.reason);
  if (!result.bound_n) return reason;
  return ContractText::tr("%1 It is never violated by more than %2, proved.")
      .arg(reason, roundedForce(*result.bound_n, model.output.unit));
}

std::vector<Contract> offeredContracts(const fuzzy::ForceModel& model) {
  std::vector<Contract> out;
  const auto offer = [&](Contract contract) {
    const bool there = std::any_of(model.contracts.begin(), model.contracts.end(),
                                   [&](const Contract& one) { return says(one, contract); });
    if (!there) out.push_back(std::move(contract));
  };
  const auto of = [](ContractKind kind, const std::string& input) {
    Contract contract;
    contract.kind = kind;
    contract.input = input;
    return contract;
  };
  const auto declared = elicitation::declaredDirections(model);
  const auto falls = [](const auto& one) { return one.direction == analysis::Direction::kFalls; };
  for (const auto& one : declared) {
    if (inputNamed(model, one.input))
      offer(of(falls(one) ? ContractKind::kNeverRaises : ContractKind::kNeverLowers, one.input));
  }
  for (const auto& one : declared) {
    const auto input = inputNamed(model, one.input);
    if (!input || model.inputs[*input].terms.size() < 2) continue;
    const auto& terms = model.inputs[*input].terms;
    Contract contract = of(ContractKind::kNeverHarder, one.input);
    contract.word = falls(one) ? terms.back().id : terms.front().id;
    contract.than = falls(one) ? terms.front().id : terms.back().id;
    offer(std::move(contract));
    break;
  }
  if (const auto way = fuzzy::wayOf(model.inputs)) {
    Contract contract = of(ContractKind::kNoStep, model.inputs[*way].id);
    contract.within = 1;
    contract.limit = 1;
    contract.limit_in_jnd = model.output.unit == "N";
    if (contract.limit_in_jnd) offer(std::move(contract));
  }
  Contract most = of(ContractKind::kNeverAbove, {});
  most.limit = roundedDown(model.output.max);
  offer(std::move(most));
  offer(of(ContractKind::kNeverSilent, {}));
  return out;
}

QString stateText(ContractState state, bool old) {
  switch (state) {
    case ContractState::kProved: return old ? ContractText::tr("was proved") : ContractText::tr("proved");
    case ContractState::kBroken: return old ? ContractText::tr("was broken") : ContractText::tr("broken");
    case ContractState::kOpen: return old ? ContractText::tr("was open") : ContractText::tr("open");
    case ContractState::kComputing: break;
  }
  return ContractText::tr("computing…");
}

}  // namespace tactus::workbench
