// Edits of the rules of one expert, and of the contracts of the model. A rule may have any number of conditions.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/editing/edit.h"

namespace tactus::editing {

/// Appends `rule`, with its conditions in the order of the model's inputs. Refused: no condition, an unknown input or
/// term, an input twice, an existing rule.
base::Result<Edit> addRule(const fuzzy::ForceModel& model, const std::string& expert, fuzzy::Rule rule);

/// Replaces rule `index` by `rule`. Refused as above.
base::Result<Edit> replaceRule(const fuzzy::ForceModel& model, const std::string& expert, std::size_t index,
                               fuzzy::Rule rule);

/// Sets the consequent of a rule, a term id of the output.
base::Result<Edit> setConsequent(const fuzzy::ForceModel& model, const std::string& expert, std::size_t index,
                                 const std::string& then);

/// Sets the weight of a rule, in [0, 1].
base::Result<Edit> setRuleWeight(const fuzzy::ForceModel& model, const std::string& expert, std::size_t index,
                                 double weight);

/// The same for several rules at once. Refused: two rules that would become the same.
base::Result<Edit> setConsequent(const fuzzy::ForceModel& model, const std::string& expert,
                                 std::span<const std::size_t> indices, const std::string& then);
base::Result<Edit> setRuleWeight(const fuzzy::ForceModel& model, const std::string& expert,
                                 std::span<const std::size_t> indices, double weight);

/// Enables or disables rules. At least one index; each below the number of rules.
base::Result<Edit> enableRules(const fuzzy::ForceModel& model, const std::string& expert,
                               std::span<const std::size_t> indices, bool enabled);

/// Removes rules.
base::Result<Edit> removeRules(const fuzzy::ForceModel& model, const std::string& expert,
                               std::span<const std::size_t> indices);

/// Puts a block of rules (rule_grid.h) among those of the expert: a rule takes the place of the one with the same
/// conditions, the second of such rules that of the second one; the others are appended.
base::Result<Edit> putRules(const fuzzy::ForceModel& model, const std::string& expert,
                            std::span<const fuzzy::Rule> rules);

/// Sets the weight of an expert in the mean, >= 0. Refused: 0 for the only expert with a weight above 0.
base::Result<Edit> setExpertWeight(const fuzzy::ForceModel& model, const std::string& expert, double weight);

// Contracts (docs/contracts.md): no force changes.

/// Appends `contract` with an id of its own. Refused: a contract of the same sentence, numbers that mean nothing.
base::Result<Edit> addContract(const fuzzy::ForceModel& model, fuzzy::Contract contract);

/// Puts `contract` in the place of number `index`, with its id. Refused likewise.
base::Result<Edit> replaceContract(const fuzzy::ForceModel& model, std::size_t index, fuzzy::Contract contract);

base::Result<Edit> removeContract(const fuzzy::ForceModel& model, std::size_t index);

/// The rules of `expert` that contradict another one: both count (enabled, weight > 0) and have the same conditions but
/// different consequents. Ascending.
std::vector<std::size_t> conflictingRules(const fuzzy::Expert& expert);

/// The conditions of `rule` in the order of the model's inputs; those on unknown inputs come last.
fuzzy::Rule inOrderOfInputs(const fuzzy::ForceModel& model, fuzzy::Rule rule);

/// Whether the two rules have the same conditions in any order.
bool sameConditions(const fuzzy::Rule& one, const fuzzy::Rule& other);

}  // namespace tactus::editing
