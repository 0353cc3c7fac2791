// The columns of a study's tables. Their order in a file is free.
#pragma once

#include <array>
#include <string_view>

namespace tactus::study {

inline constexpr std::array<std::string_view, 6> kParticipantColumns = {"participant", "years_experience", "category",
                                                                        "handedness",  "weight",           "simulated"};
inline constexpr std::array<std::string_view, 6> kSpeedColumns = {"participant", "level",    "stroke",
                                                                  "time_s",      "depth_mm", "speed_mm_s"};
inline constexpr std::array<std::string_view, 5> kJudgementColumns = {"participant", "series", "step", "force_n",
                                                                      "term"};
/// `wording` is written only where one is known.
inline constexpr std::array<std::string_view, 6> kAnswerColumns = {"participant", "form",   "item",
                                                                   "term",        "status", "wording"};
/// rules.csv also has one column per input and optionally `form`.
inline constexpr std::array<std::string_view, 3> kRuleColumns = {"participant", "then", "weight"};

/// Columns that may be absent, and the meaning of their absence; empty: as usual, and nothing is said of it. rules.csv
/// may lack some input columns, but not all.
struct OptionalColumn {
  std::string_view table, column, meaning;
};
inline constexpr std::array<OptionalColumn, 9> kOptionalColumns = {{
    {"participants.csv", "years_experience", "not known"},
    {"participants.csv", "category", "not known"},
    {"participants.csv", "handedness", "not known"},
    {"participants.csv", "weight", "not set"},
    {"participants.csv", "simulated", "the data count as given by persons"},
    {"judgements.csv", "series", "all judgements count as 'ascending'"},
    {"answers.csv", "status", "an item with a term counts as answered, others as skipped"},
    {"answers.csv", "wording", ""},
    {"rules.csv", "weight", "each rule has the weight 1"},
}};

}  // namespace tactus::study
