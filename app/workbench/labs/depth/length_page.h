// How much tube a person needs: the bedside formulas for a typed nose-ear-xiphoid length, and where the tip should lie
// (elicitation/depth/insertion_length.h). The length is stored with the measurement of depths.
#pragma once

#include <QWidget>
#include <array>
#include <vector>

#include "app/workbench/plot/plot_menu.h"
#include "core/fuzzy/force_model.h"
#include "elicitation/depth/insertion_length.h"

class QCPAxisRect;
class QCustomPlot;
class QLabel;

namespace tactus::workbench {

/// How far a tube reaches by each formula, over the regions of the depth and the target of the tip.
class LengthPlot : public QWidget, public PlotSource {
  Q_OBJECT

 public:
  explicit LengthPlot(QWidget* parent = nullptr);

  /// `depth`: with its terms, between whose middles of overlap the regions are drawn.
  void show(const fuzzy::Variable& depth, const std::vector<elicitation::InsertionLength>& lengths,
            const elicitation::DepthRange& target);

  QSize pictureSize() const override { return {900, 340}; }
  void paintPicture(QCPPainter& painter, const QSize& size) override;

 private:
  void addBar(double from_mm, double to_mm, double bottom, double top, const QColor& fill);
  void addText(double at_mm, double height, const QString& words, const QColor& ink, Qt::Alignment side);

  QCustomPlot* plot_;
};

/// `Nose – ear – xiphoid`, `Hanson`, `Corrected`.
QString formulaName(elicitation::LengthFormula formula);
/// Millimeters as centimeters: `49.7 cm`.
QString centimeters(double length_mm);

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
  void refreshState();

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
