// The columns that the tables of a study must have. The order in the file is free.
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
inline constexpr std::array<std::string_view, 5> kAnswerColumns = {"participant", "form", "item", "term", "status"};
/// Besides these, rules.csv has one column per input and, if it likes, `form`.
inline constexpr std::array<std::string_view, 3> kRuleColumns = {"participant", "then", "weight"};

}  // namespace tactus::study
