// How much each expert counts in the averaged force.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/tables/csv.h"
#include "core/study/records.h"

namespace tactus::elicitation {

enum class WeightPolicy {
  kEqual,     ///< 1 each (paper, Eq. 2)
  kYears,     ///< years of experience
  kCategory,  ///< WeightSettings::categories of the participant's category
  kColumn,    ///< the participant's own weight (column `weight` of participants.csv)
  kTable,     ///< WeightSettings::table
};

/// `equal`, `years`, `category`, `column`, `file`: the words of `tactus build --weights`.
std::string_view name(WeightPolicy policy) noexcept;

struct WeightSettings {
  WeightPolicy policy = WeightPolicy::kEqual;
  /// Weight of each category, in lower case. The default ranks them in equal steps, a choice of this project.
  std::map<std::string, double> categories{{"beginner", 1}, {"intermediate", 2}, {"expert", 3}};
  std::map<std::string, double> table;  ///< weight by participant
  std::string table_file;               ///< where the table comes from, for errors and notes; may be empty
};

/// One weight per expert, in their order. Refused: a participant without the value that the policy needs, a weight that
/// is not finite or below 0, no weight above 0. The error names the table and line of the value, or that it should be
/// in.
base::Result<std::vector<double>> expertWeights(std::span<const study::Participant> experts,
                                                const WeightSettings& settings);

/// One sentence for each participant of WeightSettings::table who is not one of `participants`, where the policy uses
/// the table.
std::vector<std::string> unusedWeightNotes(std::span<const study::Participant> participants,
                                           const WeightSettings& settings);

/// What to know of `weights`, one for each of `experts` and accepted by `expertWeights`: experts who do not count or
/// hardly count (less than 1 % of the sum), and how much of the mean is simulated where not all of it is. `simulated`:
/// whether an expert's rules are. One sentence each.
std::vector<std::string> weightNotes(std::span<const study::Participant> experts, std::span<const double> weights,
                                     const std::vector<bool>& simulated);

/// Reads a table `participant,weight`. Refused: a missing column, a participant twice, a weight below 0.
base::Result<std::map<std::string, double>> readWeightTable(const base::CsvTable& table);

}  // namespace tactus::elicitation
