// The chosen finding in full, its place, and one button for each fix.
#pragma once

#include <QFrame>

class QGridLayout;
class QHBoxLayout;
class QLabel;
class QToolButton;

namespace tactus::workbench {

class FindingsController;

class FixCard : public QFrame {
  Q_OBJECT

 public:
  explicit FixCard(FindingsController& findings, QWidget* parent = nullptr);

 private:
  void showFinding();
  void showFixes();
  void showRules();

  FindingsController& findings_;
  QLabel* sentence_;
  QToolButton* here_;
  QToolButton* other_end_;
  QHBoxLayout* rules_;  ///< a button for each rule
  QLabel* note_;
  QWidget* fixes_;
  QGridLayout* grid_;
};

}  // namespace tactus::workbench
