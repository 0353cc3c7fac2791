#include "app/cli/contracts_text.h"

#include <algorithm>

#include "app/cli/model_arguments.h"
#include "app/cli/terminal.h"
#include "core/base/text.h"

namespace tactus::cli {
namespace {

using contracts::ContractResult;
using contracts::ForcePlace;
using contracts::Verdict;

std::string newtons(double value, const std::string& unit) { return base::roundedNumber(value) + ' ' + unit; }

std::string placeText(const fuzzy::ForceModel& model, const ForcePlace& place) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < place.inputs.size(); ++i)
    parts.push_back(model.inputs[i].id + "=" + base::formatNumber(place.inputs[i]));
  return base::oneLine(base::joined(parts, ",")) + ": " +
         (place.force.fired ? base::formatFixed(place.force.force_n, 6) + ' ' + model.output.unit
                            : "no rule fires, default " + newtons(place.force.force_n, model.output.unit));
}

std::string detailsOf(const fuzzy::ForceModel& model, const ContractResult& result) {
  switch (result.verdict) {
    case Verdict::kProved: return {};
    case Verdict::kOpen: {
      std::string text = wrapped(result.reason, "            ", 12);
      if (result.bound_n)
        text += "            never violated by more than " + newtons(*result.bound_n, model.output.unit) + '\n';
      return text;
    }
    case Verdict::kViolated: {
      std::string text;
      if (result.excess_n > 0)
        text = "            by " + newtons(result.excess_n, model.output.unit) + ", the largest case found\n";
      for (const ForcePlace& place : result.counterexample) text += "            " + placeText(model, place) + '\n';
      return text;
    }
  }
  return {};
}

}  // namespace

base::Result<std::vector<CheckedContract>> checkedContracts(const fuzzy::ForceModel& model,
                                                            const fuzzy::CompiledModel& compiled,
                                                            const std::vector<std::string>& sentences) {
  std::vector<CheckedContract> out;
  for (const fuzzy::Contract& contract : model.contracts)
    out.push_back({contract, contracts::sentenceOf(model, contract), {}});
  for (const std::string& sentence : sentences) {
    auto contract = contracts::parseContract(model, sentence);
    if (!contract) return base::inFile(contract.error(), "--contract");
    std::string text = contracts::sentenceOf(model, *contract);
    out.push_back({*std::move(contract), std::move(text), {}});
  }
  for (CheckedContract& one : out) one.result = contracts::checkContract(model, compiled, one.contract);
  return out;
}

std::string contractsAsText(const fuzzy::ForceModel& model, const std::vector<CheckedContract>& contracts) {
  if (contracts.empty()) return {};
  const auto count = [&](Verdict verdict) {
    return std::to_string(std::count_if(contracts.begin(), contracts.end(),
                                        [&](const CheckedContract& one) { return one.result.verdict == verdict; }));
  };
  std::string text = "contracts: proved " + count(Verdict::kProved) + ", violated " + count(Verdict::kViolated) +
                     ", open " + count(Verdict::kOpen) + '\n';
  for (const CheckedContract& one : contracts) {
    text += wrapped(one.sentence, "  " + padded(name(one.result.verdict), 9) + ' ', 12) + detailsOf(model, one.result);
  }
  return text;
}

void writeContracts(const std::vector<CheckedContract>& contracts, base::JsonWriter& json) {
  json.key("contracts").beginArray();
  for (const CheckedContract& one : contracts) {
    const ContractResult& result = one.result;
    json.beginObject().key("id");
    one.contract.id.empty() ? json.null() : json.value(one.contract.id);
    json.key("sentence").value(one.sentence).key("verdict").value(name(result.verdict));
    json.key("excess_n").value(result.excess_n).key("bound_n").value(result.bound_n);
    json.key("parts").value(result.parts).key("counterexample").beginArray();
    for (const ForcePlace& place : result.counterexample) {
      json.beginObject(base::JsonWriter::Layout::kInline).key("in").values(place.inputs);
      json.key("force").value(place.force.force_n).key("fired").value(place.force.fired).endObject();
    }
    json.endArray();
    if (!result.reason.empty()) json.key("reason").value(result.reason);
    json.endObject();
  }
  json.endArray();
}

std::string brokenContract(const std::vector<CheckedContract>& contracts) {
  std::size_t count = 0;
  const CheckedContract* first = nullptr;
  for (const CheckedContract& one : contracts) {
    if (one.result.verdict != Verdict::kViolated) continue;
    if (count++ == 0) first = &one;
  }
  if (first == nullptr) return {};
  return contracts::violationText(first->sentence, count - 1);
}

}  // namespace tactus::cli
