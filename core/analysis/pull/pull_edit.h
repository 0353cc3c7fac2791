// One small edit of a force model, as pulling a force offers it.
//
// Ramp: what two neighbors of a list that sums to one share, from the core end p of the left term to the core start q
// of the right one. Moving it changes four vertices and keeps the sum:
//   left term   (…, …, p, q)        right term   (p, q, …, …)
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/analysis/finding_place.h"
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

/// `model` after the edit; its checks are not computed again. The result may be invalid only for kVertex (an output
/// term without width in the universe) and kWord (the same rule twice).
fuzzy::ForceModel applied(fuzzy::ForceModel model, const PullEdit& edit);

}  // namespace tactus::analysis
