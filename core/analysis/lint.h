// What a researcher should know about a valid model before it is used: findings, not errors.
#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/analysis/finding_place.h"
#include "core/analysis/force_bounds.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

struct Finding {
  enum class Kind {
    kHole,             ///< a region where no rule fires; newtons: the jump to the default force at its boundary
    kAbstentionJump,   ///< an expert starts to abstain while others go on; newtons: the jump of the mean there
    kConflict,         ///< the same conditions with another consequent; newtons: between the two rules, each alone
    kRedundantRule,    ///< another rule says the same with fewer conditions; newtons: 0, it can be removed
    kDirectionChange,  ///< a step against the direction of most steps of the same expert and input; newtons: the
                       ///< change of the expert's force along it
    kDisagreement,     ///< an expert whose direction for an input is opposite to that of most experts; newtons: its
                       ///< change of force over the input against that of the others
    kUnusedTerm,       ///< an input term that no enabled rule of the expert mentions
    kUnreachableTerm,  ///< an input term outside its universe, or an output term that no rule ever concludes
    kUnreachableRule,  ///< a rule whose conditions are never true together
  };
  Kind kind = Kind::kHole;
  std::string expert;  ///< expert id; empty where the averaged model is meant
  FindingPlace where;  ///< what it is about: a hole, conditions, a term, a step, an input
  std::string place;   ///< the same in words, by `describe`; nothing reads them back
  std::string text;    ///< one sentence
  /// The force at stake. Where it comes from looking at settings of further inputs, the largest one seen. Nothing where
  /// a force has no meaning, or where no such setting was found.
  std::optional<double> newtons;
  std::vector<double> from;  ///< two points between which the force changes by `newtons`; empty where it is not so
  std::vector<double> to;
  /// The rules it is about, by their index in Expert::rules. kConflict: both. kRedundantRule, kUnreachableRule: that
  /// one. kDirectionChange: from the one to the other. kDisagreement: those of the steps that go the expert's way.
  std::vector<std::size_t> rules;
};

/// `hole`, `conflict`, …
std::string_view name(Finding::Kind kind) noexcept;

/// Smallest and largest force seen.
struct ForceRange {
  double min_n = 0;
  double max_n = 0;
  std::size_t points = 0;  ///< where it was looked at
  std::size_t fired = 0;   ///< of these, where some rule fired; 0 means that there is no range
};

struct Lint {
  std::vector<Finding> findings;
  bool coverage_complete = true;
  bool newtons_complete = true;  ///< false where a huge model used up the time for looking at forces
  ForceRange reachable;
  std::optional<ForceBounds> bounds;  ///< proved for every point where the mean fires; nothing where it never does
};

/// All findings about `model`, which must be valid. Holes have exact boundaries. Directions are read off the rules:
/// along the terms of one input, in the order of their centres, with the other conditions of a rule held fixed, each
/// change of the consequent is a step up or down; three quarters of an expert's steps in one direction make it the
/// direction. The reachable range is what was seen at the vertices of the terms and between them, so the true range may
/// be a little wider; it lies within the bounds.
/// It ends soon after `stop` says so; what it found until then is of no use.
Lint lint(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled, const std::stop_token& stop = {});

}  // namespace tactus::analysis
