// A finding about the rules with its words for the screen.
#pragma once

#include <QString>

#include "elicitation/rules/rule_finding.h"

namespace tactus::workbench {

struct WordedFinding {
  elicitation::RuleFinding finding;
  QString who;       ///< `S1 and S4`, or `Mean`
  QString sentence;  ///< with the labels of the model
};

}  // namespace tactus::workbench
