// The weights of the experts in the averaged force.
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

/// `equal`, `years`, `category`, `column`, `file`: the values of `tactus build --weights`.
std::string_view name(WeightPolicy policy) noexcept;

struct WeightSettings {
  WeightPolicy policy = WeightPolicy::kEqual;
  /// Weight of each category (lower case). The default has equal steps between ranks, a choice of this project.
  std::map<std::string, double> categories{{"beginner", 1}, {"intermediate", 2}, {"expert", 3}};
  std::map<std::string, double> table;  ///< weight by participant
  std::string table_file;               ///< source of the table, for errors and notes; may be empty
};

/// One weight per expert, in their order. Returns an error for: a participant without the value that the policy needs,
/// a weight that is not finite or below 0, no weight above 0. The error names table and line of the value, or of its
/// missing place.
base::Result<std::vector<double>> expertWeights(std::span<const study::Participant> experts,
                                                const WeightSettings& settings);

/// One sentence for each participant in WeightSettings::table who is not in `participants`, if the policy uses the
/// table.
std::vector<std::string> unusedWeightNotes(std::span<const study::Participant> participants,
                                           const WeightSettings& settings);

/// Notes about `weights`, one sentence each: experts with no or hardly any weight (less than 1 % of the sum), and the
/// simulated share of the mean if only a part is simulated. `weights`: one per expert, accepted by `expertWeights`.
/// `simulated`: whether an expert's rules are simulated.
std::vector<std::string> weightNotes(std::span<const study::Participant> experts, std::span<const double> weights,
                                     const std::vector<bool>& simulated);

/// Reads a table `participant,weight`. Returns an error for a missing column, a duplicate participant, or a weight
/// below 0.
base::Result<std::map<std::string, double>> readWeightTable(const base::CsvTable& table);

}  // namespace tactus::elicitation
