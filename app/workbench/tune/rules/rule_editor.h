// The rule editor of one expert: grids to fill in and a list of all rules. A low panel shows one of the two at a time.
#pragma once

#include "app/workbench/kit/cards.h"

class QComboBox;
class QSplitter;
class QTabBar;

namespace tactus::workbench {

class Refresh;
class RuleController;

class RuleEditor : public Card {
  Q_OBJECT

 public:
  explicit RuleEditor(RuleController& rules, QWidget* parent = nullptr);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void showHead();
  void arrange();

  RuleController& rules_;
  QComboBox* experts_;
  QComboBox* columns_;
  QTabBar* tabs_;
  QSplitter* panes_;
  bool tall_ = false;
  Refresh* refresh_;
};

}  // namespace tactus::workbench
