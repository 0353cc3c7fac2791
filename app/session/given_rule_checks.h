// Whether the rules that participants gave directly can be meant.
#pragma once

#include <span>
#include <vector>

#include "core/study/data_finding.h"
#include "core/study/records.h"

namespace tactus::session {

/// Findings about the given rules of each participant, of 10 rules or more: nine tenths with one consequent; the rules
/// of an earlier participant in 19 of 20.
std::vector<study::DataFinding> givenRuleFindings(std::span<const study::GivenRule> rules);

}  // namespace tactus::session
