// The terms that follow from a depth measurement, as a picture and as numbers, and whether the study's model has them.
#pragma once

#include <QWidget>

class QComboBox;
class QLabel;

namespace tactus::workbench {

class DepthLab;
class DepthTermPlot;

class DepthTermPage : public QWidget {
  Q_OBJECT

 public:
  /// `lab` outlives this.
  explicit DepthTermPage(DepthLab& lab, QWidget* parent = nullptr);

  QComboBox& choice() { return *choice_; }

 private:
  void follow();
  void followChoice();

  DepthLab& lab_;
  QComboBox* choice_;
  DepthTermPlot* plot_;
  QLabel* numbers_;
};

}  // namespace tactus::workbench
