#include "core/fuzzy/validate.h"

#include <cmath>
#include <span>
#include <string>
#include <utility>

#include "core/base/text.h"
#include "core/fuzzy/model_checks.h"
#include "core/fuzzy/resolve.h"

namespace tactus::fuzzy {
namespace {

using base::ErrorCode;
using base::formatNumber;

Problem checkUniverse(const Variable& variable, const Place& place) {
  if (auto wrong = checkNumber(variable.min, -kLargest, kLargest, place["min"])) return wrong;
  if (auto wrong = checkNumber(variable.max, -kLargest, kLargest, place["max"])) return wrong;
  if (variable.max - variable.min >= kNarrowest) return nullptr;
  return problem(ErrorCode::kValue, place["max"], formatNumber(variable.max),
                 "more than min, which is " + formatNumber(variable.min));
}

Problem checkVariables(const ForceModel& model, ModelNames& names) {
  const Place root;
  const Place inputs = root["inputs"];
  const Place output = root["output"];
  if (auto wrong = checkCount(model.inputs.size(), kMostInputs, "inputs", inputs)) return wrong;
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    const Place place = inputs[i];
    if (auto wrong = checkUnique(names.variables, model.inputs[i].id, place["id"])) return wrong;
    if (auto wrong = checkUniverse(model.inputs[i], place)) return wrong;
    if (auto wrong = checkTerms(model.inputs[i].terms, nullptr, place["terms"], names.terms[i])) return wrong;
  }
  for (const auto of : {&wayOf, &rateOf}) {
    const auto first = of(model.inputs);
    if (!first) continue;
    const auto more = of(std::span(model.inputs).subspan(*first + 1));
    if (!more) continue;
    return problem(ErrorCode::kValue, inputs[*first + 1 + *more]["role"], "a second way or rate",
                   "at most one input that is the way of the tip, and one that is its speed");
  }
  if (auto wrong = checkUnique(names.variables, model.output.id, output["id"])) return wrong;
  if (auto wrong = checkUniverse(model.output, output)) return wrong;
  return checkTerms(model.output.terms, &model.output, output["terms"], names.terms[model.inputs.size()]);
}

Problem checkRenderer(const RendererParameters& renderer) {
  const Place root;
  const Place place = root["renderer"];
  if (renderer.version != 1) {
    return problem(ErrorCode::kVersion, place["version"], std::to_string(renderer.version), "version 1");
  }
  for (const auto& field : kRendererFields) {
    const double value = renderer.*field.member;
    if (std::isfinite(value) && value <= field.max && (field.min_excluded ? value > field.min : value >= field.min))
      continue;
    return problem(ErrorCode::kValue, place[field.key], formatNumber(value),
                   "a number in " + std::string(field.min_excluded ? "(" : "[") + formatNumber(field.min) + ", " +
                       formatNumber(field.max) + "]");
  }
  return nullptr;
}

Problem checkChecks(const ForceModel& model) {
  const Place root;
  const Place all = root["checks"];
  for (std::size_t i = 0; i < model.checks.size(); ++i) {
    const Place place = all[i];
    const Check& check = model.checks[i];
    if (check.in.size() != model.inputs.size()) {
      return problem(ErrorCode::kSchema, place["in"], std::to_string(check.in.size()) + " numbers",
                     std::to_string(model.inputs.size()) + ", one per input");
    }
    for (std::size_t k = 0; k < check.in.size(); ++k) {
      if (!std::isfinite(check.in[k])) {
        return problem(ErrorCode::kValue, place["in"][k], formatNumber(check.in[k]), "a finite number");
      }
    }
    if (!std::isfinite(check.force)) {
      return problem(ErrorCode::kValue, place["force"], formatNumber(check.force), "a finite number");
    }
  }
  return nullptr;
}

/// The names in a contract may be gone; its numbers must mean something.
Problem checkContracts(const ForceModel& model) {
  const Place root;
  const Place all = root["contracts"];
  if (model.contracts.size() > kMostContracts) {
    return problem(ErrorCode::kLimit, all, std::to_string(model.contracts.size()) + " contracts",
                   "at most " + std::to_string(kMostContracts));
  }
  NameList ids;
  for (std::size_t i = 0; i < model.contracts.size(); ++i) {
    const Place place = all[i];
    const Contract& contract = model.contracts[i];
    if (auto wrong = checkUnique(ids, contract.id, place["id"])) return wrong;
    if (auto wrong = checkNumber(contract.limit, -kLargest, kLargest, place["limit"])) return wrong;
    if (contract.kind == Contract::Kind::kNoStep) {
      if (auto wrong = checkNumber(contract.limit, kNarrowest, kLargest, place["limit"])) return wrong;
      if (auto wrong = checkNumber(contract.within, kNarrowest, kLargest, place["within"])) return wrong;
    }
    for (std::size_t k = 0; k < contract.where.size(); ++k) {
      for (std::size_t j = 0; j < k; ++j) {
        if (contract.where[j].input != contract.where[k].input) continue;
        return problem(ErrorCode::kSchema, place["where"],
                       "the input " + base::quoted(contract.where[k].input) + " twice", "each input once");
      }
    }
  }
  return nullptr;
}

Problem checkEvents(const ForceModel& model) {
  if (model.events.empty()) return nullptr;
  const Place root;
  const Place all = root["events"];
  if (model.events.size() > kMostEvents) {
    return problem(ErrorCode::kLimit, all, std::to_string(model.events.size()) + " events",
                   "at most " + std::to_string(kMostEvents));
  }
  const auto way = wayOf(model.inputs);
  if (!way) return problem(ErrorCode::kReference, all, "events in a model without a way", "an input that is the way");
  NameList terms;
  for (std::size_t i = 0; i < model.events.size(); ++i) {
    const Place place = all[i];
    const TubeEvent& event = model.events[i];
    if (findTerm(model.inputs[*way].terms, event.term) == nullptr) {
      std::vector<std::string> known;
      for (const Term& term : model.inputs[*way].terms) known.push_back(term.id);
      return problem(ErrorCode::kReference, place["term"], base::quoted(event.term),
                     "a term of " + base::quoted(model.inputs[*way].id) + ": " + base::joined(known, ", "));
    }
    if (!terms.add(event.term)) {
      return problem(ErrorCode::kSchema, place["term"], base::quoted(event.term) + " again", "each term once");
    }
    if (!(event.share > 0 && event.share < 1)) {
      return problem(ErrorCode::kValue, place["share"], formatNumber(event.share), "a number above 0 and below 1");
    }
  }
  return nullptr;
}

}  // namespace

base::Result<void> validate(const ForceModel& model) {
  ModelTables unused;
  if (auto wrong = resolve(model, unused)) return tl::unexpected(std::move(*wrong));
  return {};
}

Problem resolve(const ForceModel& model, ModelTables& tables) {
  const Place root;
  ModelNames names;
  if (auto wrong = checkVariables(model, names)) return wrong;
  if (auto wrong = checkNumber(model.default_force_n, -kLargest, kLargest, root["default_force_n"])) return wrong;
  if (auto wrong = resolveExperts(model, names, tables)) return wrong;
  if (model.renderer) {
    if (auto wrong = checkRenderer(*model.renderer)) return wrong;
  }
  if (auto wrong = checkContracts(model)) return wrong;
  if (auto wrong = checkEvents(model)) return wrong;
  return checkChecks(model);
}

}  // namespace tactus::fuzzy
