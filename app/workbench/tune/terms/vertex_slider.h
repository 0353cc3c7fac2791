// A slider that moves one vertex of a term: with the mouse, or with the arrow keys in fine and, with Shift, coarse
// steps.
#pragma once

#include <QSlider>

namespace tactus::workbench {

class VertexSlider : public QSlider {
  Q_OBJECT

 public:
  explicit VertexSlider(QWidget* parent = nullptr);

  /// The ends of the slider, in the unit of the variable; `from` < `to`.
  void setEnds(double from, double to);
  /// Where the vertex is. Announces nothing; the handle stays at the nearer end for a vertex beyond it.
  void setPlace(double place);

 signals:
  void moveBegun();
  /// The hand is `by` away from where it took hold, in the unit of the variable.
  void moved(double by);
  void moveEnded();
  void moveCancelled();
  /// A press of an arrow key: `count` is 1 to the right, -1 to the left.
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

}  // namespace tactus::workbench
