// Puts the rule editor into the window.
#pragma once

namespace tactus::workbench {

class MainWindow;
class RuleController;

class RuleParts {
 public:
  /// Before a model is opened: a stage takes its layout when it is entered first.
  RuleParts(MainWindow& window, RuleController& rules);
};

}  // namespace tactus::workbench
