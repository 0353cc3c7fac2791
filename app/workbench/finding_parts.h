// Puts the findings into the window: their panel, and what else shows the finding that is chosen.
#pragma once

namespace tactus::workbench {

class FindingsController;
class MainWindow;
class RuleController;
class TermController;

struct FindingParts {
  /// Before a model is opened: a stage takes its layout when it is entered first.
  FindingParts(MainWindow& window, FindingsController& findings, TermController& terms, RuleController& rules);
};

}  // namespace tactus::workbench
