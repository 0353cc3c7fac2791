// The membership functions of one variable, to be moved by hand: a vertex, an edge or a whole term is dragged, and the
// arrow keys move what was taken hold of last. The plot changes nothing itself: it says what the hand does.
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "app/workbench/base/plot_table.h"
#include "app/workbench/plot/plot_source.h"
#include "app/workbench/tune/terms/term_grip.h"
#include "core/fuzzy/force_model.h"

class QCustomPlot;
class QMouseEvent;

namespace tactus::workbench {

class GripMarks;
class LandmarkMarks;
class TermLabels;
class ValueMarker;
struct PlotFrame;

class MembershipEditorPlot : public QWidget, public PlotSource {
  Q_OBJECT

 public:
  explicit MembershipEditorPlot(QWidget* parent = nullptr);

  /// What is drawn. A drag keeps the axis as it was at its beginning.
  void setTerms(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms);
  /// The shapes before an edit, as thin dashed outlines where they differ from those now; empty: none.
  void setGhost(std::vector<fuzzy::Term> before);
  /// Whether the vertex `point` of each term is locked, in the order of the terms.
  void setLocked(std::vector<std::vector<bool>> locked);
  /// Vertices of neighbours that lie on each other move together.
  void setSumToOne(bool sum_to_one);
  void setSelected(std::optional<tactus::workbench::Grip> grip);
  /// The operating point, or none.
  void setValue(std::optional<double> value);
  /// Why what is held goes no further; empty: it moves freely.
  void setStopped(const QString& reason);

  bool isDragging() const { return pressed_ && dragging_; }

  /// Where a handle is, px in this widget, for whoever points at it.
  QPointF pixelOf(double x, double membership) const;

  /// The corners of the terms as they are drawn.
  void fillTable(PlotTable& table) const;
  QSize pictureSize() const override { return {1000, 420}; }
  void paintPicture(QCPPainter& painter, const QSize& size) override;

 signals:
  void selected(std::optional<tactus::workbench::Grip> grip);
  void moveBegun(const tactus::workbench::Grip& grip);
  /// The hand is `by` away from where it took hold, in the unit of the variable.
  void moved(double by);
  void moveEnded();
  void moveCancelled();
  /// A press of an arrow key: `count` is 1 to the right, -1 to the left.
  void stepped(int count, bool coarse);
  void stepsEnded();
  /// The next handle is wanted: 1, or the one before: -1.
  void nextWanted(int direction);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void leaveEvent(QEvent* event) override;
  bool event(QEvent* event) override;

 private:
  void onPress(QMouseEvent* event);
  void onMove(QMouseEvent* event);
  void onRelease(QMouseEvent* event);
  void hoverAt(QPointF place);
  void endDrag();
  void fitAxis();
  void drawTerms();
  void drawMarks();
  void drawGhost();
  bool moves(std::size_t term, double x, std::size_t point) const;
  PlotFrame frame() const;
  std::optional<Grip> shownGrip() const;

  fuzzy::Variable variable_;
  std::vector<fuzzy::Term> terms_;
  std::vector<fuzzy::Term> before_;
  std::vector<std::vector<bool>> locked_;
  std::optional<double> value_;
  std::optional<Grip> selected_;
  std::optional<Grip> hovered_;
  std::optional<Grip> pressed_;
  QPointF press_place_;
  double press_value_ = 0;
  bool dragging_ = false;
  bool stepping_ = false;
  bool sum_to_one_ = false;
  QString stopped_;

  QCustomPlot* plot_;
  TermLabels* labels_ = nullptr;
  LandmarkMarks* landmarks_;
  ValueMarker* marker_;
  GripMarks* marks_;
};

}  // namespace tactus::workbench
