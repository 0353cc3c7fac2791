// Sliders for the vertices of the selected term, as in the paper. They follow the plot and the numbers.
#pragma once

#include <QSlider>
#include <QString>
#include <QWidget>
#include <vector>

#include "core/fuzzy/force_model.h"

class QHBoxLayout;

namespace tactus::workbench {

/// A slider that moves one vertex of a term: with the mouse, or with the arrow keys in fine steps (with Shift: coarse
/// steps).
class VertexSlider : public QSlider {
  Q_OBJECT

 public:
  explicit VertexSlider(QWidget* parent = nullptr);

  /// The ends of the slider, in the unit of the variable; `from` < `to`.
  void setEnds(double from, double to);
  /// Moves the handle to the vertex and emits nothing. For a vertex beyond an end the handle stays at that end.
  void setPlace(double place);

 signals:
  void moveBegun();
  /// The mouse is `by` away from the start of the drag, in the unit of the variable.
  void moved(double by);
  void moveEnded();
  void moveCancelled();
  /// An arrow key was pressed: `count` is 1 to the right, -1 to the left.
  void stepped(int count, bool coarse);
  void stepsEnded();

 protected:
  bool event(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  double perPixel() const;

  double from_ = 0;
  double to_ = 1;
  double press_x_ = 0;
  bool pressed_ = false;
  bool dragging_ = false;
  bool stepping_ = false;
};

class ElidedLabel;
class TermController;
class VertexSlider;

class TermSliders : public QWidget {
  Q_OBJECT

 public:
  explicit TermSliders(TermController& terms, QWidget* parent = nullptr);
  /// Leaves its room to the plot in an editor of `height` px that is low for the size of the text: the plot, its keys
  /// and the table move a vertex too.
  void fitInto(int height);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  struct Part {
    QWidget* cell;
    ElidedLabel* name;
    VertexSlider* slider;
  };
  void follow();
  void build(const fuzzy::Term& term);
  void show(const fuzzy::Term& term);

  TermController& terms_;
  QHBoxLayout* layout_;
  ElidedLabel* title_;
  std::vector<Part> parts_;
  std::size_t term_ = 0;  ///< index in the list; the first term if none is selected
  fuzzy::Shape shape_ = fuzzy::Shape::kTrapezoid;
};

}  // namespace tactus::workbench
