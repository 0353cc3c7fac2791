// S4's 45 rules (Table A2 of the paper) in each possible reading of its region labels.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/study/records.h"

namespace tactus::questionnaires {

/// One way to read the regions of Table A2. The table has no oropharynx, and its questionnaire has no stomach. No
/// reading is proved, so the researcher chooses, and the choice stays visible.
struct TableReading {
  std::string id;  ///< e.g. `ngt-a2-printed`; GivenRule::form of its rules
  std::string title;
  std::string assumes;                                       ///< one sentence
  std::string depth_terms;                                   ///< name of the matching set of depth terms
  std::vector<std::pair<std::string, std::string>> regions;  ///< printed depth term, intended depth term
};

/// The reading without a depth that lacks a rule.
inline constexpr std::string_view kDefaultReading = "ngt-a2-five-regions";

/// The readings of Table A2: as printed, shifted, five regions.
std::vector<TableReading> s4Readings();

/// S4's rules in the reading with the id `reading`, in the order of Table A2. For an unknown id returns an error with
/// the list of ids.
base::Result<std::vector<study::GivenRule>> s4Rules(std::string_view reading = kDefaultReading);

}  // namespace tactus::questionnaires
