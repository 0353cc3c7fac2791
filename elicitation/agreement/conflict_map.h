// The conflict map: what the experts' different words cost, cell by cell, in newtons.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "core/fuzzy/membership.h"

namespace tactus::elicitation {

// The cells of a model's experts: conditions that their rules name, and who has a rule there.

/// One expert's rule in a cell, with the memberships of its conditions.
struct CellRule {
  std::size_t rule = 0;
  std::vector<std::pair<std::size_t, fuzzy::MembershipFunction>> memberships;  ///< by input

  /// Whether the rule has a strength > 0 at `point`.
  bool fires(const fuzzy::ForceModel& model, const std::vector<double>& point) const;
};

struct ExpertCell {
  std::vector<fuzzy::Condition> conditions;
  std::vector<std::optional<CellRule>> rules;  ///< per expert, in the model's order
};

/// The conditions of a rule as input and term, sorted: the same conditions in another order are the same cell.
std::vector<std::pair<std::string, std::string>> cellKey(const fuzzy::Rule& rule);

/// The cells of a valid model, in the order in which the experts' rules name them. Only rules that can fire count. Of
/// several rules of one expert with the same conditions the first stands for the cell; the lint names the conflict.
std::vector<ExpertCell> expertCells(const fuzzy::ForceModel& model);

/// One cell: a condition that at least one expert has a rule for, such as `lubrication is poor and depth is esophagus`.
struct CellConflict {
  std::vector<fuzzy::Condition> conditions;
  std::vector<std::string> words;  ///< the word of each expert, in the model's order; empty: no rule
  /// The upper median of the words of the experts of weight > 0, in the order of the output's terms.
  std::string middle_word;
  /// The mean force of each expert alone where the cell fires for the expert; 0 without a rule.
  std::vector<double> felt_n;
  /// How far the force of one expert moves with the word of another one: root mean square over all ordered pairs of
  /// experts and the points where the cell fires, in N and in just-noticeable differences around the averaged force.
  double rms_n = 0;
  double rms_noticeable = 0;
  double largest_n = 0;
  /// How far the averaged force moves if all take the middle word: root mean square where the cell fires, in N.
  double stake_n = 0;
  /// Share of the variance between the experts, over all points, that vanishes then. Can be negative.
  double share = 0;
  std::size_t points = 0;  ///< where the cell fires for some expert
};

struct ConflictMap {
  std::vector<CellConflict> cells;  ///< in the order in which the experts' rules name them
  /// Standard deviation (n - 1) of the experts' own forces at a point: root mean square over all points.
  double between_n = 0;
  double largest_spread_n = 0;  ///< largest distance between two experts' forces at a point
  std::vector<double> spread_at;
  std::size_t points = 0;
};

struct ConflictSettings {
  /// Where forces are compared, one value per input; empty: analysis::boxPoints. Give points of recorded use to weigh
  /// what occurs in practice.
  std::vector<std::vector<double>> points;
  std::stop_token stop;
  std::function<void(double share_done)> progress;  ///< called in the thread of the call, with rising values up to 1
};

/// Compares the experts of weight > 0 in every cell. Experts whose rules name other conditions have no word there.
/// Takes 45 cells of four experts in well under a second.
/// Returns the error of `fuzzy::compile`, or kCancelled after a stop request.
/// Thread: any.
base::Result<ConflictMap> conflictMap(const fuzzy::ForceModel& model, const ConflictSettings& settings = {});

}  // namespace tactus::elicitation
