// What a researcher should look at in the rules of a model: a finding names the expert, the rule and the newtons at
// stake.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/analysis/finding_place.h"
#include "elicitation/rules/rules_from_answers.h"

namespace tactus::elicitation {

struct RuleFinding {
  enum class Kind {
    kHole,               ///< a region where no rule of the expert, or of any, fires; newtons: the jump of that force at
                         ///< its boundary to the default force
    kAbstentionJump,     ///< an expert abstains while others go on; newtons: the jump of the mean at the boundary
    kForceStep,          ///< the force of the mean or an expert steps along an input: more than one just-noticeable
                         ///< difference within 1 mm, or steeper than the renderer's stiffness; newtons: the change
    kRegionWithoutRule,  ///< a region of the expert that no rule mentions; newtons: of a hole inside it
    kMissingItem,        ///< an item without an answer; newtons: how far the expert's force at a point where the item
                         ///< applies in full depends on which answer it would be
    kConflict,           ///< the same conditions with another consequent; newtons: between the two rules, each alone
    kExpertsApart,       ///< two experts more than two just-noticeable differences apart; newtons: between them
    kAgainstDeclaration,  ///< the force moves against the direction that the study declares; newtons: the expert's
                          ///< change
    kLevelJump,           ///< neighbouring answers some levels apart; newtons: the change of the expert's force
    kDirectionChange,     ///< from here on as in analysis::Finding
    kDisagreement,
    kRedundantRule,
    kUnreachableRule,
    kUnreachableTerm,
    kUnusedTerm,
  };
  /// A rule, or an item that gives none.
  struct Source {
    std::optional<std::size_t> rule;  ///< index in Expert::rules; nothing for an item without an answer
    RuleOrigin origin;                ///< empty where only the model is known
  };

  Kind kind = Kind::kHole;
  std::vector<std::string> experts;  ///< ids; empty where the averaged model is meant
  std::vector<Source> sources;       ///< of the first expert (kExpertsApart: one of each); empty where no rules are to
                                     ///< blame
  analysis::FindingPlace where;      ///< a hole, conditions, a term, a step or an input
  std::string place;                 ///< the same in words; nothing reads them back
  std::string text;                  ///< one sentence, with the sources
  std::optional<double> newtons;     ///< the force at stake, where it has a meaning
  bool at_least = false;             ///< the largest one of the settings looked at; elsewhere it may be larger
  /// The points that `newtons` is about: the force changes from one to the other. The same point twice where it is the
  /// experts, or the possible answers, that differ there. Both empty where there is no such point.
  std::vector<double> from;
  std::vector<double> to;
};

/// `hole`, `missing_item`, …
std::string_view name(RuleFinding::Kind kind) noexcept;

/// `items 3, 8 (answers.csv, lines 4, 9)`, `rule 2 (rules.csv, line 3)`; a rule's number counts from 1. Empty without
/// sources.
std::string describe(const std::vector<RuleFinding::Source>& sources);

}  // namespace tactus::elicitation
