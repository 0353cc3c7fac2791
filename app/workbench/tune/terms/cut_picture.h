// The picture in the form that splits a term: its shape, and the cuts as lines that are dragged or moved with the arrow
// keys.
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

class CutPicture : public QWidget {
  Q_OBJECT

 public:
  /// `term` is a trapezoid.
  CutPicture(fuzzy::Variable variable, fuzzy::Term term, QWidget* parent = nullptr);

  /// The cuts, in the unit of the variable. One outside the universe is not drawn.
  void setCuts(std::vector<double> cuts);
  const std::vector<double>& cuts() const { return cuts_; }
  /// Where `value` stands, px in this widget. For tests.
  double pixelOf(double value) const;

  QSize sizeHint() const override;

 signals:
  /// The user moved a cut. They ascend.
  void moved(const std::vector<double>& cuts);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  QRectF area() const;
  double valueAt(double pixel) const;
  std::optional<std::size_t> cutAt(double pixel) const;
  void move(std::size_t cut, double value);

  const fuzzy::Variable variable_;
  const fuzzy::Term term_;
  double low_;  ///< the part of the universe that is drawn
  double high_;
  std::vector<double> cuts_;
  std::size_t selected_ = 0;
  bool dragging_ = false;
};

}  // namespace tactus::workbench
