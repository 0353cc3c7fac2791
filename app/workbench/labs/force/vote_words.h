// The reasons of the vote and the methods of the force terms, in words.
#pragma once

#include <QString>

#include "elicitation/force/force_terms.h"
#include "elicitation/force/force_voting.h"

namespace tactus::workbench {

/// In a word or two: `majority`, `tie, the higher wins`; with what was done afterwards: `majority, raised`.
QString reasonText(const elicitation::VoteStep& step);
/// The rule behind it, one sentence.
QString reasonRule(const elicitation::VoteStep& step);

/// `Vote`, `Frequency`, `Thresholds`, `Probit`.
QString methodName(elicitation::ForceTermsFrom from);
/// How the method comes to its terms, one sentence.
QString methodRule(elicitation::ForceTermsFrom from);

/// `ascending`, `descending`, `random` for the screen; any other name unchanged.
QString seriesText(const std::string& series);

}  // namespace tactus::workbench
