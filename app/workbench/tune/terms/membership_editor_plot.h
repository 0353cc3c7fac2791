// The plot of the membership functions of one variable. The user drags a vertex, an edge or a whole term; the arrow
// keys move the selected part. The plot changes no model: it only emits the user's actions.
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "app/workbench/base/plot_table.h"
#include "app/workbench/plot/plot_menu.h"
#include "app/workbench/tune/terms/term_grip.h"
#include "core/fuzzy/force_model.h"

class QCustomPlot;
class QMenu;
class QMouseEvent;

namespace tactus::workbench {

class AxisZoom;
class GripMarks;
class LandmarkMarks;
class ShownRanges;
class TermLabels;
class ValueMarker;
struct PlotFrame;

class MembershipEditorPlot : public QWidget, public PlotSource {
  Q_OBJECT

 public:
  explicit MembershipEditorPlot(ShownRanges& ranges, QWidget* parent = nullptr);

  /// The terms to draw. During a drag the axis stays as it was at the beginning.
  void setTerms(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms);
  /// The shapes before an edit: thin dashed outlines where they differ from the current ones; empty: none.
  void setGhost(std::vector<fuzzy::Term> before);
  /// Whether the vertex `point` of each term is locked, in the order of the terms.
  void setLocked(std::vector<std::vector<bool>> locked);
  /// If true, vertices of neighbors at one place move together.
  void setSumToOne(bool sum_to_one);
  void setSelected(std::optional<tactus::workbench::Grip> grip);
  /// The operating point, or none.
  void setValue(std::optional<double> value);
  /// Why the dragged part cannot move further; empty if it moves freely.
  void setStopped(const QString& reason);

  bool isDragging() const { return pressed_ && dragging_; }

  /// The position of a handle, px in this widget. For tests.
  QPointF pixelOf(double x, double membership) const;

  /// The corners of the terms as they are drawn.
  void fillTable(PlotTable& table) const;
  QSize pictureSize() const override { return {1000, 420}; }
  void paintPicture(QCPPainter& painter, const QSize& size) override;

 signals:
  void selected(std::optional<tactus::workbench::Grip> grip);
  void moveBegun(const tactus::workbench::Grip& grip);
  /// The mouse is `by` away from the start of the drag, in the unit of the variable.
  void moved(double by);
  void moveEnded();
  void moveCancelled();
  /// An arrow key was pressed: `count` is 1 to the right, -1 to the left.
  void stepped(int count, bool coarse);
  void stepsEnded();
  /// The user asks where the value of a vertex comes from.
  void originAsked(std::size_t term, std::size_t point);
  /// The user asks for the next handle (1) or the previous one (-1).
  void nextWanted(int direction);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void leaveEvent(QEvent* event) override;
  bool event(QEvent* event) override;

 private:
  void addToMenu(QMenu& menu, QPointF place);
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

  ShownRanges& ranges_;
  QCustomPlot* plot_;
  AxisZoom* zoom_;
  TermLabels* labels_ = nullptr;
  LandmarkMarks* landmarks_;
  ValueMarker* marker_;
  GripMarks* marks_;
};

}  // namespace tactus::workbench
