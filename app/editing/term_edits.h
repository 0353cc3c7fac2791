// Adds, renames and removes terms.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/editing/term_list.h"
#include "core/analysis/term_conversion.h"

namespace tactus::editing {

// Makes terms a partition: their memberships sum to one everywhere (Ruspini). What one is:
// core/analysis/term_conversion.h.

using analysis::kNarrowestShare;
using analysis::partitionOrder;
using analysis::TermOrder;

/// Makes the terms a partition. Neighbors, in the order of the middles of their cores, share the mean of their two
/// facing edges (sorted if they cross). The first and the last term are stretched to the ends of the universe. Terms
/// become trapezoids; a triangle that keeps its peak stays a triangle. Refused: a Gaussian in the list.
base::Result<Edit> makeSumToOne(const fuzzy::ForceModel& model, const TermListId& list);

// The rules of an expert that name a term: find, rename, remove.

/// Whether `rule` names the term: in a condition on an input, or as consequent if `variable` is the output.
bool names(const fuzzy::Rule& rule, const fuzzy::ForceModel& model, const fuzzy::Variable& variable,
           const std::string& term);

/// The rule with `to` in place of the term `from`.
fuzzy::Rule withTerm(fuzzy::Rule rule, const fuzzy::ForceModel& model, const fuzzy::Variable& variable,
                     const std::string& from, const std::string& to);

/// The event at the term `from` of the list, if there is one, is at `to` from now on. Expert's own lists have no
/// events.
void moveEvents(fuzzy::ForceModel& model, const TermListId& list, const std::string& from, const std::string& to);

/// Removes the rules of `expert` that name the term, or refuses if there are any; `rules` chooses. `expert` and
/// `variable` are parts of `model`.
base::Result<void> letGo(fuzzy::Expert& expert, const fuzzy::ForceModel& model, const fuzzy::Variable& variable,
                         const std::string& term, RulesOfTerm rules);

// Converts a term to another shape.

/// The model with the converted term (analysis::convertedTerm). Terms that summed to one may no longer do so.
base::Result<Edit> convertShape(const fuzzy::ForceModel& model, const TermPlace& place, fuzzy::Shape shape);

/// Splits a term into parts, as the paper proposes for its esophagus (Section 6), and copies its rules to the parts.
struct TermName {
  std::string id;
  std::string label;
};

struct SplitOptions {
  std::vector<double> cuts;  ///< ascending, inside the core, in the unit of the variable; n cuts make n + 1 parts
  /// Width of the ramps at the cuts. Nothing: the mean of the term's own ramps (without ramps 1/100 of the universe),
  /// but at most half of the shortest piece of the core.
  std::optional<double> overlap;
  std::vector<TermName> names;  ///< one per part; empty: `esophagus_1`, `Esophagus 1` and so on
  bool copy_rules = true;       ///< false: the rules stay with the part that holds the middle of the core
};

/// Splits a trapezoid. The parts overlap around each cut so that their sum is the old term; a partition stays a
/// partition. A rule with the term in a condition becomes one rule for each part, in their order and at its place, so
/// the force outside the overlaps does not change. Consequents are never copied, because the copies would conflict: the
/// rules of an output term stay with the part that holds the middle of its core. An event stays at its place, with the
/// last part. Refused: a triangle or Gaussian
/// (convert it first), cuts or an overlap outside the core.
base::Result<Edit> splitTerm(const fuzzy::ForceModel& model, const TermPlace& place, const SplitOptions& options);

/// An id that is free in the list, made from `wanted`: itself, or with the first free number appended.
std::string freeTermId(const std::vector<fuzzy::Term>& terms, const std::string& wanted);

/// A default term: a trapezoid around `at` with a core of 1/20 of the universe and ramps of the same width.
fuzzy::Term suggestedTerm(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms, double at);

/// Inserts `term` before the first term whose core has its middle farther right. No rule names it yet. To make room in
/// a partition, split a term without copying its rules instead (splitTerm).
base::Result<Edit> addTerm(const fuzzy::ForceModel& model, const TermListId& list, const fuzzy::Term& term);

/// Gives a term another id and label. The rules that use the list are updated, and the event at the term.
base::Result<Edit> renameTerm(const fuzzy::ForceModel& model, const TermPlace& place, const std::string& id,
                              const std::string& label);

struct RemoveOptions {
  RulesOfTerm rules = RulesOfTerm::kRefuse;
  /// The terms sum to one before and after. The neighbors meet in the middle of the removed core, with a ramp as wide
  /// as the mean of its two ramps. At an end of the universe the only neighbor takes its place.
  bool sum_to_one = false;
};

/// Removes a term, with the event at it. Refused: the last term of a list; with `sum_to_one`, terms that do not sum to
/// one.
base::Result<Edit> removeTerm(const fuzzy::ForceModel& model, const TermPlace& place, const RemoveOptions& options);

}  // namespace tactus::editing
