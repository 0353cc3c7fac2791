// The grids with the bar of the selected cell and a line that explains the keys.
#pragma once

#include <QWidget>

class QScrollArea;

namespace tactus::workbench {

class ElidedLabel;
class Refresh;
class RuleCellBar;
class RuleController;
class RuleGrids;

class RuleGridPane : public QWidget {
  Q_OBJECT

 public:
  explicit RuleGridPane(RuleController& rules, QWidget* parent = nullptr);

 private:
  void showRules();
  void showSelection();

  RuleController& rules_;
  QScrollArea* area_;
  RuleGrids* grids_;
  RuleCellBar* cell_;
  ElidedLabel* hint_;
  Refresh* refresh_;
};

}  // namespace tactus::workbench
