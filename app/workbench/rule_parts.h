// Adds the rule editor to the window.
#pragma once

#include <QCoreApplication>

namespace tactus::workbench {

class MainWindow;
class RuleController;

class RuleParts {
  Q_DECLARE_TR_FUNCTIONS(RuleParts)

 public:
  /// Create before a model is opened: a stage gets its layout at its first use.
  RuleParts(MainWindow& window, RuleController& rules);
};

}  // namespace tactus::workbench
