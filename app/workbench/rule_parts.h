// Adds the rule editor to the window.
#pragma once

namespace tactus::workbench {

class MainWindow;
class RuleController;

class RuleParts {
 public:
  /// Create before a model is opened: a stage gets its layout at its first use.
  RuleParts(MainWindow& window, RuleController& rules);
};

}  // namespace tactus::workbench
