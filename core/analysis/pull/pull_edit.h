// One small edit of a force model, as pulling a force offers it.
//
// Ramp: what two neighbors of a list that sums to one share, from the core end p of the left term to the core start q
// of the right one. Moving it changes four vertices and keeps the sum:
//   left term   (…, …, p, q)        right term   (p, q, …, …)
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/analysis/finding_place.h"
#include "core/analysis/term_conversion.h"
#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

enum class Gesture {
  kBegin,   ///< p of a ramp
  kEnd,     ///< q of a ramp
  kShift,   ///< both by the same
  kWidth,   ///< p down, q up
  kMove,    ///< both ramps of an inner term by the same
  kWiden,   ///< its left ramp down, its right ramp up
  kVertex,  ///< one vertex of a term in a list that does not sum to one
  kWord,    ///< another consequent of a rule
  kOff,     ///< the rule disabled
  kWeight,  ///< another weight of a rule
};

/// `p`, `q`, `shift`, `width`, `move`, `widen`, `vertex`, `word`, `off`, `weight`.
std::string_view name(Gesture gesture) noexcept;

/// Whether the gesture belongs to a rule, not to a list of terms.
inline bool editsRule(Gesture gesture) noexcept { return gesture >= Gesture::kWord; }

/// A list of terms: that of variable number `variable` (the output follows the inputs), shared or an expert's own.
struct PulledList {
  std::size_t variable = 0;
  std::string owner;  ///< id of the expert who has an own list; empty: the shared list

  bool operator==(const PulledList&) const = default;
};

/// The index of the expert `id`, who exists.
std::size_t expertIndex(const fuzzy::ForceModel& model, std::string_view id);
/// The terms of a list that exists in `model`.
const std::vector<fuzzy::Term>& termsOf(const fuzzy::ForceModel& model, const PulledList& list);
/// The experts whose rules read the list, as indices.
std::vector<std::size_t> readersOf(const fuzzy::ForceModel& model, const PulledList& list);

struct PullEdit {
  Gesture gesture = Gesture::kShift;
  PulledList list;         ///< of a term; unused for a rule
  std::size_t place = 0;   ///< ramp from 0, or for kMove and kWiden the term, both in the order on the universe; for
                           ///< kVertex the term in the order of the list
  std::size_t vertex = 0;  ///< kVertex: index in Term::points
  std::string expert;      ///< of a rule, id
  std::size_t rule = 0;    ///< index in Expert::rules
  std::string then;        ///< kWord: the new consequent, id
  double delta = 0;        ///< in the unit of the variable; change of the weight; kWord: steps of the words, up or down

  bool operator==(const PullEdit&) const = default;
};

/// An edit of rule number `rule` of the expert `expert`.
PullEdit ruleEdit(Gesture gesture, const std::string& expert, std::size_t rule, double delta = 0,
                  const std::string& then = {});
/// An edit of a list of terms, with delta 0.
PullEdit termEdit(Gesture gesture, const PulledList& list, std::size_t place, std::size_t vertex = 0);

/// A vertex that must not move: point number `point` of a term.
struct LockedVertex {
  PulledList list;
  std::string term;
  std::size_t point = 0;
};

/// The first vertex of `locked` that the edit moves, whatever its delta; null if it moves none. An edit of a rule moves
/// none.
const LockedVertex* lockedVertexOf(const fuzzy::ForceModel& model, const PullEdit& edit,
                                   std::span<const LockedVertex> locked);

/// `model` after the edit; its checks are not computed again. The result may be invalid only for kVertex (an output
/// term without width in the universe) and kWord (the same rule twice).
fuzzy::ForceModel applied(fuzzy::ForceModel model, const PullEdit& edit);

/// A list of terms that sums to one, as its ramps (pull_edit.h), and how far each gesture can go before the order of
/// the vertices breaks.
struct Ramps {
  TermOrder order;           ///< of the terms, as indices in the list
  std::vector<double> p;     ///< ramp r between the terms order[r] and order[r + 1] begins here
  std::vector<double> q;     ///< and ends here
  double low = 0, high = 1;  ///< the universe
  double narrowest = 0;      ///< ramp
};

/// Nothing for a list that does not sum to one.
std::optional<Ramps> rampsOf(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms);

/// Writes the vertices that differ between `before` and `after`; the others keep their bits. A triangle that loses its
/// peak becomes a trapezoid.
void writeRamps(const Ramps& before, const Ramps& after, std::vector<fuzzy::Term>& terms);

/// A place of a gesture in a list: see PullEdit::place.
struct GesturePlace {
  Gesture gesture;
  std::size_t place;
};

/// All gestures of a list: four for each ramp, two for each inner term.
std::vector<GesturePlace> gesturesOf(const Ramps& ramps);

/// Values of a gesture's delta, 0 among them.
struct DeltaRange {
  double low = 0;
  double high = 0;

  bool holds(double delta) const noexcept { return delta >= low && delta <= high; }
};

/// How far the gesture can go: low <= p < q <= p of the next ramp <= high, each ramp at least `narrowest` wide.
DeltaRange allowedDeltas(const Ramps& ramps, Gesture gesture, std::size_t place);

Ramps moved(Ramps ramps, Gesture gesture, std::size_t place, double delta);

/// Membership of the left term of ramp `ramp` at x as far as this ramp decides it: 1 up to p, 0 from q on.
double shareBelow(const Ramps& ramps, std::size_t ramp, double x);

/// The memberships of all terms at x, by index in the list.
std::vector<double> membershipsAt(const Ramps& ramps, double x);

/// The delta with which `gesture` brings ramp `ramp` to the place where the left term has the membership `share` at x;
/// nothing if it does not move this ramp, or no delta does it. The caller compares with `allowedDeltas`.
std::optional<double> deltaFor(const Ramps& ramps, const GesturePlace& gesture, std::size_t ramp, double share,
                               double x);

}  // namespace tactus::analysis
