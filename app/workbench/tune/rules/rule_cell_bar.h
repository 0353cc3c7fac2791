// The bar of the selected cell: its conditions in words, the possible answers, the weight and the enabled state.
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

  /// Shows the current rules and selection.
  void showCell();

 signals:
  /// A number was typed: the keyboard focus returns to the grids.
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
