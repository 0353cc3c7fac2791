// Synthetic models that grow in one number, for the cost of large models.
#pragma once

#include "core/fuzzy/force_model.h"

#include "tests/bench/cases.h"

namespace tactus::bench {

/// Four inputs and an output of eight terms each; a rule for each term of the first input, so that one fires
/// everywhere, and rules with all four inputs in the condition up to `rules` (45 to 4096).
fuzzy::ForceModel modelWithRules(int rules);

/// Four inputs and an output of `terms` terms each (3 to 64); 128 rules, of which one for each term of the first input.
fuzzy::ForceModel modelWithTerms(int terms);

/// `inputs` inputs (1 to 8) of three terms, five output terms; nine rules for each input, with the next one beside it.
fuzzy::ForceModel modelWithInputs(int inputs);

/// `count` points anywhere in the universes.
Points randomPoints(const fuzzy::ForceModel& model, std::size_t count);

}  // namespace tactus::bench
