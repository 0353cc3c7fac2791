// The contracts of a model in the output of `tactus check` and `tactus verify`.
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/json/json_writer.h"
#include "core/contracts/contract_check.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::cli {

struct CheckedContract {
  fuzzy::Contract contract;  ///< its id is empty if it was given on the command line
  std::string sentence;
  contracts::ContractResult result;
};

/// Checks the contracts of `model`, then those of `sentences`. Refused: a sentence that is no contract of the model.
base::Result<std::vector<CheckedContract>> checkedContracts(const fuzzy::ForceModel& model,
                                                            const fuzzy::CompiledModel& compiled,
                                                            const std::vector<std::string>& sentences);

/// A line for each contract with its verdict, and where it is violated. Empty without contracts.
std::string contractsAsText(const fuzzy::ForceModel& model, const std::vector<CheckedContract>& contracts);

/// Writes them as the member `contracts` of the open object of `json`.
void writeContracts(const std::vector<CheckedContract>& contracts, base::JsonWriter& json);

/// The sentence for the first violated contract and the number of others; empty if none is violated.
std::string brokenContract(const std::vector<CheckedContract>& contracts);

}  // namespace tactus::cli
