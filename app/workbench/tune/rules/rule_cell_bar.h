// The selected cell of the rule grids: its conditions in words, the words to answer with, weight and whether it counts.
#pragma once

#include <QWidget>

class QCheckBox;

namespace tactus::workbench {

class ElidedLabel;
class NumberBox;
class RuleController;
class WordBar;

class RuleCellBar : public QWidget {
  Q_OBJECT

 public:
  explicit RuleCellBar(RuleController& rules, QWidget* parent = nullptr);

  /// Shows the rules and the selection as they stand now.
  void showCell();

 signals:
  /// A number was typed: the keys go back to the grids.
  void done();

 private:
  RuleController& rules_;
  ElidedLabel* conditions_;
  NumberBox* weight_;
  QCheckBox* enabled_;
  WordBar* words_;
  bool warns_ = false;
};

}  // namespace tactus::workbench
