// Pulling the force at a point to a wanted value: the smallest edits of the model that do it, each with what else it
// moves. Background: docs/pull.md.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/analysis/expert_spread.h"
#include "core/analysis/force_difference.h"
#include "core/analysis/pull/elsewhere.h"
#include "core/analysis/pull/pull_edit.h"
#include "core/base/error.h"
#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

enum class PullKind {
  kPlace,      ///< terms of the curve's input
  kCondition,  ///< terms of another input
  kForceWord,  ///< terms of the output
  kRule,
};
/// `place`, `condition`, `force_word`, `rule`.
std::string_view name(PullKind kind) noexcept;

struct PullSettings {
  std::optional<std::size_t> expert;          ///< index; nothing: the mean, which only offers terms that experts share
  std::vector<std::size_t> locked;            ///< variables whose terms must not change; the output follows the inputs
  std::vector<LockedVertex> locked_vertices;  ///< no edit that moves one is offered
  bool lock_rules = false;                    ///< no edit of a rule is offered
  /// Points whose force stays within a quarter of a noticeable difference; an edit that moves it further is not
  /// offered.
  std::vector<std::vector<double>> pins;
  std::optional<std::size_t> curve_input;  ///< nothing: `depth`, or the last input
  std::size_t box_points = kBoxPoints;     ///< 0: k is k_curve, for an answer within a frame
};

struct PullCandidate {
  std::vector<PullEdit> edits;       ///< made one after the other
  PullKind kind = PullKind::kPlace;  ///< of the first edit
  double force_n = 0;                ///< at the point after the edits
  Elsewhere elsewhere;
  bool exact = false;   ///< gives the target; otherwise it comes within half a noticeable difference, or nearest
  bool folded = false;  ///< not plausible: a rule moved by two or more words or against the direction of its expert, a
                        ///< force word moved by more than half of its width
};

/// Why no single edit gives the target.
struct PullBlocker {
  enum class Kind {
    kNoRule,    ///< no rule fires at the point
    kLock,      ///< with `variable` unlocked, or the vertices of its terms, an edit does it; one above the output's:
                ///< the rules
    kPin,       ///< without the pins an edit does it
    kCentroid,  ///< `term` alone does not go beyond its own centroid, `limit_n`
    kOrder,     ///< `term` would have no core
    kRamp,      ///< the ramp beside `term` would have no width
    kUniverse,  ///< the end of the universe of `variable`
    kTurn,      ///< the best gesture turns back there
    kRules,     ///< the best is an edit of one rule; the others hold the force back
  };
  Kind kind = Kind::kNoRule;
  std::size_t variable = 0;
  std::string term;
  double limit_n = 0;  ///< the nearest force that an edit reaches
};

struct ForceInterval {
  double min_n = 0;
  double max_n = 0;
};

struct Pull {
  std::optional<double> before_n;  ///< nothing in a hole
  double target_n = 0;
  std::optional<ForceInterval> reachable;  ///< by one edit and by the candidates; its inside may have gaps
  std::optional<PullBlocker> blocker;      ///< set if no candidate comes within half a noticeable difference
  std::vector<PullCandidate> candidates;   ///< best first: plausible before folded, exact before near, then by k
};

/// The edits that give `target_n` at `point` (in the order and units of the model). Gestures on lists that sum to one
/// keep the sum; others move single vertices. Edits of one rule are offered for one expert, or a model of one.
/// Deterministic. Refused: a wrong number of values, a value that is not finite or outside its universe (of the point
/// or a pin), a pin at which no rule fires, a target that is not finite. Thread: any.
base::Result<Pull> pull(const fuzzy::ForceModel& model, std::span<const double> point, double target_n,
                        const NoticeableDifference& noticeable, const PullSettings& settings = {});

/// Whether `settings` lock what the edit of `model` changes.
bool isLocked(const fuzzy::ForceModel& model, const PullEdit& edit, const PullSettings& settings);

/// Refuses a wrong number of values, and a value that is not finite or outside its universe.
base::Result<void> checkPoint(const fuzzy::ForceModel& model, std::span<const double> point);

/// `model` after all edits of a candidate.
fuzzy::ForceModel applied(fuzzy::ForceModel model, std::span<const PullEdit> edits);

}  // namespace tactus::analysis
