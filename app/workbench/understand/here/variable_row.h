// The variables of the model side by side, one card each. The row scrolls if they do not fit.
#pragma once

#include <QColor>
#include <QPen>
#include <QPolygonF>
#include <QRectF>
#include <QScrollArea>
#include <QWidget>
#include <optional>
#include <vector>

#include "app/workbench/base/plot_table.h"
#include "app/workbench/kit/cards.h"
#include "app/workbench/plot/plot_menu.h"
#include "core/analysis/polyline.h"
#include "core/fuzzy/force_model.h"

class QCustomPlot;
class QLabel;
class QMouseEvent;
class QPainter;
class QSlider;

namespace tactus::workbench {

class ElidedLabel;
class NumberBox;
class SceneController;
class TermLabels;
class ValueMarker;

// Small pictures of fuzzy sets without axes: one term, filled to a height, or any set.

/// Paints into one rectangle over the universe of a variable, heights 0 to 1.
class SetSketch {
 public:
  SetSketch(QPainter& painter, const QRectF& area, const fuzzy::Variable& variable);

  /// The line at height 0.
  void ground();
  /// The outline of `term`.
  void term(const fuzzy::Term& term, const QColor& color);
  /// The filled set of `term`, cut or scaled at `strength`.
  void implied(const fuzzy::Term& term, double strength, fuzzy::Implication implication, const QColor& color);
  /// `set`, filled.
  void set(const analysis::Polyline& set, const QColor& color);
  /// A vertical line at `x`.
  void mark(double x, const QColor& color);
  /// A dashed horizontal line at `height` from `from_x` to the right edge.
  void level(double height, double from_x, const QColor& color);

 private:
  QPointF at(double x, double height) const;
  void outline(const QPolygonF& line, const QPen& pen);
  QPolygonF polygon(const analysis::Polyline& set) const;

  QPainter& painter_;
  QRectF area_;
  double min_;
  double max_;
};

// A small plot of one variable's membership functions: filled shapes with their names, and a marker at the current
// value.

class MembershipPlot : public QWidget, public PlotSource {
  Q_OBJECT

 public:
  explicit MembershipPlot(const fuzzy::Variable& variable, QWidget* parent = nullptr);

  /// The terms to draw, over the universe of the variable.
  void setTerms(const std::vector<fuzzy::Term>& terms);
  /// The value of the marker; nothing: no marker.
  void setValue(std::optional<double> value);

  /// The corners of the terms as they are drawn.
  void fillTable(PlotTable& table) const;
  QSize pictureSize() const override { return {800, 360}; }
  void paintPicture(QCPPainter& painter, const QSize& size) override;

  // Margins to the left and right of the axis, px. Other widgets use them to align with the axis.
  static constexpr int kLeftMargin = 24;
  static constexpr int kRightMargin = 16;

 signals:
  /// The mouse was pressed or dragged at `value`, in the unit of the variable.
  void picked(double value);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void onMouse(QMouseEvent* event);
  void updateMarker();

  fuzzy::Variable variable_;
  std::vector<fuzzy::Term> terms_;
  std::optional<double> value_;
  QCustomPlot* plot_;
  TermLabels* labels_;
  ValueMarker* marker_;
};

// One input: its membership functions, its value as a marker, a slider and a number, and the terms of the value.

class InputCard : public Card {
  Q_OBJECT

 public:
  InputCard(SceneController& scene, std::size_t input, QWidget* parent = nullptr);

 private:
  void showTerms();
  PlotTable table();
  void showValue();
  void onValue(std::size_t input);
  void onReading();
  void onSlider(int position);
  void onNumber(double value);

  SceneController& scene_;
  std::size_t input_;
  fuzzy::Variable variable_;
  double step_;
  ElidedLabel* title_;
  NumberBox* number_;
  MembershipPlot* plot_;
  QSlider* slider_;
  ElidedLabel* terms_;
};

// The output: its membership functions and the mean force at the reading place.

class OutputCard : public Card {
  Q_OBJECT

 public:
  explicit OutputCard(SceneController& scene, QWidget* parent = nullptr);

 private:
  void showTerms();
  PlotTable table();
  void showReading();

  SceneController& scene_;
  fuzzy::Variable variable_;
  ElidedLabel* title_;
  QLabel* number_;
  MembershipPlot* plot_;
  ElidedLabel* terms_;
};

class VariableRow : public QScrollArea {
  Q_OBJECT

 public:
  explicit VariableRow(SceneController& scene, QWidget* parent = nullptr);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 private:
  void build();

  SceneController& scene_;
};

}  // namespace tactus::workbench
