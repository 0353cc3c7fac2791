// How much tube a person needs: the bedside formulas for a typed nose-ear-xiphoid length, and where the tip should lie
// (elicitation/depth/insertion_length.h). The length is stored with the measurement of depths.
#pragma once

#include <QWidget>
#include <array>

class QLabel;

namespace tactus::workbench {

class DepthLab;
class LengthPlot;
class NumberBox;

class LengthPage : public QWidget {
  Q_OBJECT

 public:
  /// `lab` outlives this.
  explicit LengthPage(DepthLab& lab, QWidget* parent = nullptr);

  /// The typed length, cm.
  NumberBox& lengthBox() { return *length_; }
  /// What the page says of one formula, in the order of elicitation::insertionLengths.
  QString lengthText(std::size_t formula) const;
  QString targetText() const;

 private:
  QWidget* makeTable();
  void follow();

  DepthLab& lab_;
  NumberBox* length_;
  QLabel* example_;
  LengthPlot* plot_;
  struct Row {
    QLabel* length;
    QLabel* beyond;
    QLabel* target;
  };
  std::array<Row, 3> rows_;
  QLabel* target_;
};

}  // namespace tactus::workbench
