// Adds the findings to the window: their panel, and the links from a chosen finding to the other panels.
#pragma once

#include <QCoreApplication>

namespace tactus::workbench {

class FindingsController;
class MainWindow;
class RuleController;
class TermController;

class FindingParts {
  Q_DECLARE_TR_FUNCTIONS(FindingParts)

 public:
  /// Create before a model is opened: a stage gets its layout at its first use.
  /// Create before a model is opened: a stage gets its layout at its first use.
  FindingParts(MainWindow& window, FindingsController& findings, TermController& terms, RuleController& rules);
};

}  // namespace tactus::workbench
