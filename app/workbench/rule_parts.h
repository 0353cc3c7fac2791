// Adds the rule editor to the window.
#pragma once

#include <QCoreApplication>

namespace tactus::workbench {

class MainWindow;
class Panel;
class RuleController;
class RuleEditor;

class RuleParts {
  Q_DECLARE_TR_FUNCTIONS(RuleParts)

 public:
  RuleParts(MainWindow& window, RuleController& rules);

  Panel& panel() { return panel_; }

 private:
  RuleEditor* editor_;
  Panel& panel_;
};

}  // namespace tactus::workbench
