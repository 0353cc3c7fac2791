// S4's 45 rules (Table A2 of the paper) in each of the readings that its region labels allow.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/study/records.h"

namespace tactus::questionnaires {

/// One way to read the regions of Table A2. The table has no oropharynx, the questionnaire that led to it no stomach:
/// no reading is proved, so the choice is the researcher's and stays visible.
struct TableReading {
  std::string id;  ///< e.g. `ngt-a2-printed`; GivenRule::form of its rules
  std::string title;
  std::string assumes;                                       ///< one sentence
  std::string depth_terms;                                   ///< name of the set of depth terms that goes with it
  std::vector<std::pair<std::string, std::string>> regions;  ///< printed depth term, depth term that is meant
};

/// `ngt-a2-five-regions`: the reading that leaves no depth without a rule.
inline constexpr std::string_view kDefaultReading = "ngt-a2-five-regions";

/// The readings of Table A2: as printed, shifted, five regions.
std::vector<TableReading> s4Readings();

/// S4's rules in the reading with the id `reading`, in the order of Table A2; an unknown id is an error that lists the
/// known ones.
base::Result<std::vector<study::GivenRule>> s4Rules(std::string_view reading = kDefaultReading);

}  // namespace tactus::questionnaires
