// How much tube a person needs: the bedside formulas for a typed nose-ear-xiphoid length, and where the tip should lie
// (elicitation/depth/insertion_length.h). The length is stored with the measurement of depths.
#pragma once

#include <QWidget>
#include <array>
#include <vector>

#include "core/fuzzy/force_model.h"
#include "elicitation/depth/insertion_length.h"

class QLabel;

namespace tactus::workbench {

/// `Nose – ear – xiphoid`, `Hanson`, `Corrected`.
QString formulaName(elicitation::LengthFormula formula);
/// Millimeters as centimeters: `49.7 cm`.
QString centimeters(double length_mm);

class ChartView;
class DepthLab;
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
  void refreshState();

  DepthLab& lab_;
  NumberBox* length_;
  QLabel* example_;
  ChartView* plot_;  ///< how far a tube reaches by each formula, over the regions of the depth and the target
  struct Row {
    QLabel* length;
    QLabel* beyond;
    QLabel* target;
  };
  std::array<Row, 3> rows_;
  QLabel* target_;
};

}  // namespace tactus::workbench
