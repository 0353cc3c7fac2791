// Whether a model keeps its contracts, over the whole input space: proved, violated with the largest case found, or
// open with what is known. Method: docs/contracts.md.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::contracts {

/// The just-noticeable difference around a force, as contracts mean it: sqrt(0.04^2 + (0.12 F)^2) N. Absolute threshold
/// and Weber fraction: King 2010, Feyzabadi 2013.
double justNoticeableDifference(double force_n);

enum class Verdict { kProved, kViolated, kOpen };

/// `proved`, `violated`, `open`.
std::string_view name(Verdict verdict) noexcept;

/// A point of the model, and its force.
struct ForcePlace {
  std::vector<double> inputs;
  fuzzy::Evaluation force;
};

struct ContractResult {
  Verdict verdict = Verdict::kOpen;
  /// Where it is violated: one point, or two that the contract compares, with what it speaks of first.
  std::vector<ForcePlace> counterexample;
  double excess_n = 0;            ///< by how much it is violated there: the largest case found; 0 in a silent place
  std::optional<double> bound_n;  ///< no case is larger, certainly; nothing where that is not known
  std::size_t parts = 0;          ///< of the input space that were bounded
  std::string reason;             ///< of an open one: one sentence
};

/// A proof says that no case is larger than this share of the output's universe.
inline constexpr double kProofShare = 1e-7;

struct Effort {
  std::size_t parts = 100'000;  ///< of the input space for one contract; then it is open
};

/// Checks one contract of `model`. `compiled`: of it. Deterministic. Ends soon after `stop` is requested, with an open
/// verdict. Thread: any.
ContractResult checkContract(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                             const fuzzy::Contract& contract, const Effort& effort = {},
                             const std::stop_token& stop = {});

// The sentence of a contract, and back.

/// The sentence, such as `more lubrication never raises the force`. Grammar: docs/contracts.md.
std::string sentenceOf(const fuzzy::ForceModel& model, const fuzzy::Contract& contract);

/// What is said where a model breaks the contract with this sentence, and `more` others: `found a violation of 'more
/// lubrication never raises the force', wanted contracts that the model keeps`.
std::string violationText(std::string_view sentence, std::size_t more = 0);

/// The contract that `sentence` means; its id is empty. Refused: another sentence, names that the model does not have.
base::Result<fuzzy::Contract> parseContract(const fuzzy::ForceModel& model, std::string_view sentence);

/// The range of an input in which its membership in a word of the shared list is at least one half, cut to the
/// universe. Nothing where the word is not there, or nowhere in the universe.
struct WordRange {
  double low = 0;
  double high = 0;
};
std::optional<WordRange> rangeOfWord(const fuzzy::Variable& input, std::string_view word);

}  // namespace tactus::contracts
