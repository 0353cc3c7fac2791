// The plot of the membership functions of one variable. The user drags a vertex, an edge or a whole term; the arrow
// keys move the selected part. The plot changes no model: it only emits the user's actions.
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "app/workbench/base/plot_table.h"
#include "app/workbench/plot/plot_menu.h"
#include "app/workbench/plot/plot_style.h"
#include "app/workbench/tune/terms/term_grip.h"
#include "core/fuzzy/force_model.h"

class QCustomPlot;
class QMenu;
class QMouseEvent;

namespace tactus::workbench {

/// The handles of the membership function editor: dots to drag, bold lines for the moving part, and a tag that names
/// it. Needs QCustomPlot: only plotting code includes this.
class GripMarks : public QCPLayerable {
  Q_OBJECT

 public:
  /// A dot of the editor.
  struct Handle {
    double x = 0;
    double membership = 0;
    QColor color;
    bool large = false;  ///< of the selected term
    bool locked = false;
    bool moves = false;  ///< moves with the dragged part or the part under the mouse
  };
  /// A line along the moving part of a shape, between two places.
  struct Line {
    double from_x = 0, from_membership = 0;
    double to_x = 0, to_membership = 0;
  };

  /// `layer` must have its own buffer, so that the handles follow the mouse without drawing the shapes again.
  GripMarks(QCustomPlot& plot, const QString& layer);

  void setHandles(std::vector<Handle> handles);
  void setLines(std::vector<Line> lines);
  /// Shows `text` beside the place (x, membership); empty: no tag. `warns`: the tag gives the reason why a part cannot
  /// move.
  void setTag(const QString& text, double x, double membership, bool warns);
  /// The universe on the x axis. The plot area beyond it is shaded.
  void setUniverse(double min, double max);

 protected:
  void applyDefaultAntialiasingHint(QCPPainter* painter) const override;
  void draw(QCPPainter* painter) override;
  /// The plot area and room for a handle at its edge: of a part of the universe, what lies beside it is hidden.
  QRect clipRect() const override;

 private:
  QPointF pixelOf(double x, double membership) const;
  void drawHandle(QCPPainter& painter, const Handle& handle) const;
  void drawTag(QCPPainter& painter) const;

  std::vector<Handle> handles_;
  std::vector<Line> lines_;
  QString tag_;
  double tag_x_ = 0;
  double tag_membership_ = 0;
  bool tag_warns_ = false;
  double min_ = 0;
  double max_ = 1;
  QFont font_;
};

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
