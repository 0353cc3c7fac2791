// Lint of a valid model: findings that a researcher should know before using it. Findings are not errors.
#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/analysis/coverage.h"
#include "core/analysis/finding_place.h"
#include "core/analysis/force_probe.h"
#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

/// Proved bounds on the force, without sampling.
struct ForceBounds {
  double min_n = 0;
  double max_n = 0;
};

/// Bounds on the force of one expert at all points where it fires. Nothing if no rule can fire.
///
/// Lower bound: the centroid is at least c if the moment of the output set about c is not negative.
/// - The moment left of c is at most the sum over the terms that reach there.
/// - The moment right of c is at least any weighted mean of the same terms, if the weights add up to at most 1.
/// So c is a bound if there are weights with which each single term has no negative moment, at any strength from 0 to
/// the largest that its rules allow. The function returns the largest such c. The upper bound is the mirror image.
/// If a single term lies at an end of the range, as in ordered sets, the bound is the smallest (largest) centroid of
/// that term and therefore sharp. The proof also covers unions of terms, whose centroid may lie outside those of the
/// terms. A Gaussian reaches everywhere. If it is clipped, its bounds include the middle of the universe, which its
/// centroid approaches as the strength falls.
std::optional<ForceBounds> forceBounds(const fuzzy::ForceModel& model, std::size_t expert);

/// Bounds on the averaged force at all points where it fires. `always_fires`: one flag per expert, true only if it
/// never abstains. Any subset of the other experts may abstain.
std::optional<ForceBounds> forceBounds(const fuzzy::ForceModel& model, const std::vector<bool>& always_fires);

// The jump of the force at the boundary of a hole.

/// Two neighboring points, one ulp of one input apart, and the jump of the force between them.
struct BoundaryJump {
  double newtons = 0;
  std::vector<double> outside;  ///< the point at which the expert (or some expert) still fires
  std::vector<double> inside;   ///< the point in the hole
};

/// The largest jump between the force beside `hole` and the default force. Searches all faces of the hole. On each face
/// it tries at most `samples` settings of the other inputs, and as many near the best of them.
/// `expert`: its own hole and its own force; empty: a hole of all experts and the mean.
/// Nothing if no rule fires beside the hole.
std::optional<BoundaryJump> jumpToDefault(ForceProbe& probe, const Hole& hole, std::optional<std::size_t> expert,
                                          std::size_t samples);

/// The largest jump of the mean at the faces of `hole`, where `expert` starts to abstain and other experts continue.
/// The search is that of jumpToDefault. Nothing if no other expert fires inside the hole at the tried settings.
std::optional<BoundaryJump> jumpOfMean(ForceProbe& probe, const Hole& hole, std::size_t expert, std::size_t samples);

/// A place in a model's rules to look at. The model's own lint finds some of the kinds; the others need the study's
/// items, lines or declared directions (elicitation/rules/rule_lint.h).
struct Finding {
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
    kDirectionChange,     ///< a step against the direction of most steps of the same expert and input; newtons: the
                          ///< change of the expert's force along the step
    kDisagreement,        ///< an expert whose direction for an input is opposite to that of most experts; newtons: the
                          ///< difference between its change of force over the input and that of the others
    kRedundantRule,       ///< another rule has the same consequent and fewer conditions; newtons: 0, it can be removed
    kUnreachableRule,     ///< a rule with conditions that cannot all be true
    kUnreachableTerm,     ///< an input term outside its universe, or an output term that is no rule's consequent
    kUnusedTerm,          ///< an input term that occurs in no enabled rule of the expert
  };
  Kind kind = Kind::kHole;
  std::string expert;  ///< expert id; empty for the averaged model
  FindingPlace where;  ///< a hole, conditions, a term, a step or an input
  std::string place;   ///< `where` in words, by `describe`; never parsed
  std::string text;    ///< one sentence
  /// The difference of forces in question, the largest found if it depends on further inputs. Nothing if a force makes
  /// no sense here or no such setting was found.
  std::optional<double> newtons;
  /// The two points between which the force changes by `newtons`. Equal if the experts, or the possible answers, differ
  /// at one point. Empty if there is no such point.
  std::vector<double> from;
  std::vector<double> to;
  /// The rules concerned, by index in Expert::rules. kConflict: both. kRedundantRule, kUnreachableRule: the rule
  /// itself. kDirectionChange: the first, then the second. kDisagreement: those of the steps in the expert's direction.
  std::vector<std::size_t> rules;
};

/// `hole`, `missing_item`, …
std::string_view name(Finding::Kind kind) noexcept;

/// Smallest and largest force found.
struct ForceRange {
  double min_n = 0;
  double max_n = 0;
  std::size_t points = 0;  ///< number of tried points
  std::size_t fired = 0;   ///< points at which some rule fired; 0: there is no range
};

struct Lint {
  std::vector<Finding> findings;
  bool coverage_complete = true;
  bool newtons_complete = true;  ///< false if the budget for forces was used up (huge model)
  ForceRange reachable;
  std::optional<ForceBounds> bounds;  ///< proved for all points at which the mean fires; nothing if it never fires
};

/// All findings about `model`, which must be valid.
/// Holes have exact boundaries. Directions come from the rules: along the terms of one input, in the order of their
/// centers, with the other conditions of a rule fixed, each change of the consequent is a step up or down. The
/// direction of an expert is that of at least three quarters of its steps. The reachable range is the range found at
/// the vertices of the terms and between them. The true range may be a little wider; it lies within the bounds.
/// The lint ends soon after `stop` is requested; its result is then invalid.
Lint lint(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled, const std::stop_token& stop = {});

}  // namespace tactus::analysis
