#include <algorithm>
#include <utility>

#include "app/editing/rule_edits.h"
#include "core/contracts/contract_check.h"

namespace tactus::editing {
namespace {

using fuzzy::Contract;
using fuzzy::ForceModel;

bool sameSentence(const Contract& one, Contract other) {
  other.id = one.id;
  return one == other;
}

/// Without the values of other kinds: the file keeps what the sentence says.
Contract onlyWhatItSays(Contract contract) {
  const auto has = fuzzy::membersOf(contract.kind);
  const Contract none;
  if (!has.input) contract.input = none.input;
  if (!has.words) contract.word = contract.than = none.word;
  if (!has.limit) contract.limit = none.limit;
  if (!has.within) {
    contract.within = none.within;
    contract.limit_in_jnd = none.limit_in_jnd;
  }
  return contract;
}

base::Result<void> requireNew(const ForceModel& model, const Contract& contract, std::optional<std::size_t> beside) {
  for (std::size_t i = 0; i < model.contracts.size(); ++i) {
    if (i == beside || !sameSentence(model.contracts[i], contract)) continue;
    return base::fail(base::ErrorCode::kValue, "contracts",
                      base::quoted(contracts::sentenceOf(model, contract)) + " already",
                      "a contract that the model does not have");
  }
  return {};
}

/// `never_above`, `never_above 2`, …: one that no contract of `model` has.
std::string freeId(const ForceModel& model, Contract::Kind kind) {
  const std::string stem(fuzzy::name(kind));
  std::string id = stem;
  const auto is_taken = [&] {
    return std::any_of(model.contracts.begin(), model.contracts.end(), [&](const auto& one) { return one.id == id; });
  };
  for (std::size_t number = 2; is_taken(); ++number) id = stem + ' ' + std::to_string(number);
  return id;
}

base::Result<void> requireIndex(const ForceModel& model, std::size_t index) {
  if (index < model.contracts.size()) return {};
  return base::fail(base::ErrorCode::kReference, "contracts", "no contract " + std::to_string(index + 1),
                    "one of " + std::to_string(model.contracts.size()));
}

}  // namespace

base::Result<Edit> addContract(const ForceModel& model, Contract contract) {
  contract = onlyWhatItSays(std::move(contract));
  if (const auto ok = requireNew(model, contract, std::nullopt); !ok) return tl::unexpected(ok.error());
  ForceModel out = model;
  contract.id = freeId(model, contract.kind);
  std::string label = "Contract added: " + contracts::sentenceOf(model, contract);
  out.contracts.push_back(std::move(contract));
  return finished(std::move(out), std::move(label));
}

base::Result<Edit> replaceContract(const ForceModel& model, std::size_t index, Contract contract) {
  contract = onlyWhatItSays(std::move(contract));
  if (const auto ok = requireIndex(model, index); !ok) return tl::unexpected(ok.error());
  if (const auto ok = requireNew(model, contract, index); !ok) return tl::unexpected(ok.error());
  ForceModel out = model;
  contract.id = model.contracts[index].id;
  std::string label = "Contract changed: " + contracts::sentenceOf(model, contract);
  out.contracts[index] = std::move(contract);
  return finished(std::move(out), std::move(label));
}

base::Result<Edit> removeContract(const ForceModel& model, std::size_t index) {
  if (const auto ok = requireIndex(model, index); !ok) return tl::unexpected(ok.error());
  ForceModel out = model;
  std::string label = "Contract removed: " + contracts::sentenceOf(model, model.contracts[index]);
  out.contracts.erase(out.contracts.begin() + static_cast<std::ptrdiff_t>(index));
  return finished(std::move(out), std::move(label));
}

}  // namespace tactus::editing
