// Adds the findings to the window: their panel, and the links from a chosen finding to the other panels.
#pragma once

#include <QCoreApplication>

namespace tactus::workbench {

class FindingsController;
class MainWindow;
class Panel;
class RuleController;
class TermController;

class FindingParts {
  Q_DECLARE_TR_FUNCTIONS(FindingParts)

 public:
  FindingParts(MainWindow& window, FindingsController& findings, TermController& terms, RuleController& rules);

  Panel& panel() { return panel_; }

 private:
  Panel& panel_;
};

}  // namespace tactus::workbench
