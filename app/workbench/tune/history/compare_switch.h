// The switch between A and B. One button is pressed during a comparison, none otherwise.
#pragma once

#include <QWidget>

class QToolButton;

namespace tactus::workbench {

class CompareController;
enum class CompareSide;

class CompareSwitch : public QWidget {
  Q_OBJECT

 public:
  explicit CompareSwitch(CompareController& compare, QWidget* parent = nullptr);

 private:
  void showSide();
  QToolButton* addButton(const QString& letter, CompareSide side);

  CompareController& compare_;
  QToolButton* a_;
  QToolButton* b_;
};

}  // namespace tactus::workbench
