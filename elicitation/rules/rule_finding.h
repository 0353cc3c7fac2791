// Findings about the rules of a model, for the researcher. A finding names the expert, the rule and the difference of
// forces in N.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/analysis/coverage.h"
#include "core/analysis/finding_place.h"
#include "core/analysis/force_probe.h"
#include "core/fuzzy/force_model.h"
#include "elicitation/rules/expert_rules.h"

namespace tactus::elicitation {

// The effect of a missing answer.

/// How much an expert's force depends on a missing answer.
struct AnswerStake {
  double newtons = 0;         ///< largest minus smallest force over all answers
  std::vector<double> point;  ///< the point of that difference; it fully meets the conditions of the item
};

/// The stake of a missing rule with `conditions` of expert number `expert`. Tries each output term as its consequent,
/// together with the expert's other rules. Returns the largest stake over at most `samples` settings of the inputs that
/// the conditions do not mention. Nothing if the conditions are unknown, can never be fully met, or already have a
/// rule.
std::optional<AnswerStake> answerStake(const analysis::ForceProbe& probe, std::size_t expert,
                                       const std::vector<fuzzy::Condition>& conditions, std::size_t samples);

/// Whether a rule of `expert` with `conditions` would fire somewhere inside `hole`.
bool wouldFireIn(const analysis::Hole& hole, const fuzzy::ForceModel& model, const fuzzy::Expert& expert,
                 const std::vector<fuzzy::Condition>& conditions);

struct RuleFinding {
  enum class Kind {
    kHole,                ///< a region where no rule of the expert, or of any expert, fires; newtons: the jump of that
                          ///< force to the default force at the boundary
    kAbstentionJump,      ///< an expert abstains while others continue; newtons: the jump of the mean at the boundary
    kForceStep,           ///< a step of the mean or of an expert's force along an input: more than one just-noticeable
                          ///< difference within 1 mm, or steeper than the renderer's stiffness; newtons: the change
    kRegionWithoutRule,   ///< a region of the expert that occurs in no rule; newtons: of a hole inside it
    kMissingItem,         ///< an item without an answer; newtons: the range of the expert's force over the possible
                          ///< answers, at a point that fully meets the item
    kConflict,            ///< two rules with the same conditions and different consequents; newtons: between the two
    kExpertsApart,        ///< two experts more than two just-noticeable differences apart; newtons: between them
    kAgainstDeclaration,  ///< the force moves against the direction that the study declares; newtons: the expert's
                          ///< change
    kLevelJump,           ///< neighboring answers some levels apart; newtons: the change of the expert's force
    kDirectionChange,     ///< this and the following kinds: as in analysis::Finding
    kDisagreement,
    kRedundantRule,
    kUnreachableRule,
    kUnreachableTerm,
    kUnusedTerm,
  };
  /// A rule, or an item without a rule.
  struct Source {
    std::optional<std::size_t> rule;  ///< index in Expert::rules; empty for an item without an answer
    RuleOrigin origin;                ///< empty if only the model is known
  };

  Kind kind = Kind::kHole;
  std::vector<std::string> experts;  ///< ids; empty for the averaged model
  std::vector<Source> sources;       ///< of the first expert (kExpertsApart: one of each); empty if no rule
                                     ///< is the cause
  analysis::FindingPlace where;      ///< a hole, conditions, a term, a step or an input
  std::string place;                 ///< the place in words; never parsed
  std::string text;                  ///< one sentence, with the sources
  std::optional<double> newtons;     ///< the difference of forces, if it applies
  bool at_least = false;  ///< `newtons` is the largest value found at the tried settings; others may be larger
  /// The two points between which the force changes by `newtons`. Equal if the experts, or the possible answers, differ
  /// at one point. Empty if there is no such point.
  std::vector<double> from;
  std::vector<double> to;
};

/// `hole`, `missing_item`, …
std::string_view name(RuleFinding::Kind kind) noexcept;

/// `items 3, 8 (answers.csv, lines 4, 9)`, `rule 2 (rules.csv, line 3)`. Rule numbers count from 1. Empty without
/// sources.
std::string describe(const std::vector<RuleFinding::Source>& sources);

}  // namespace tactus::elicitation
