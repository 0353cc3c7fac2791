// The membership function editor: the terms of one variable, moved by mouse and keys or typed as numbers.
#pragma once

#include <QScrollArea>
#include <QSlider>
#include <QString>
#include <QWidget>
#include <optional>
#include <string>
#include <vector>

#include "app/workbench/base/messages.h"
#include "app/workbench/base/plot_table.h"
#include "app/workbench/kit/cards.h"
#include "app/workbench/plot/plot_menu.h"
#include "app/workbench/plot/plot_style.h"
#include "app/workbench/tune/terms/term_grip.h"
#include "core/fuzzy/force_model.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QTabBar;
class QTimer;
class QToolButton;
class QHBoxLayout;
class QGridLayout;
class QLineEdit;
class QMenu;
class QCustomPlot;
class QMouseEvent;

namespace tactus::workbench {

class EditController;
class ElidedLabel;
class GhostController;
class MembershipEditorPlot;
class NotesButton;
class SceneController;
class TermController;
class TermSliders;
class TermTable;
class LockButton;
class NumberBox;

// The plot of the membership functions of one variable. The user drags a vertex, an edge or a whole term; the arrow
// keys move the selected part. The plot changes no model: it only emits the user's actions.

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

// The picture in the form that splits a term: its shape, and the cuts as lines that are dragged or moved with the arrow
// keys.

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

// The edited list of terms as a table, one row each: name, shape, every point as a number with its lock, split and
// remove.

class TermTable : public QScrollArea {
  Q_OBJECT

 public:
  explicit TermTable(TermController& terms, QWidget* parent = nullptr);
  QSize sizeHint() const override;

 protected:
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Point {
    NumberBox* number = nullptr;
    LockButton* lock = nullptr;
  };
  struct Row {
    std::string term;
    fuzzy::Shape shape = fuzzy::Shape::kTrapezoid;
    QWidget* band = nullptr;  ///< behind the row; tinted if the term is selected
    QLineEdit* name = nullptr;
    QComboBox* shapes = nullptr;
    std::vector<Point> points;
    QToolButton* more = nullptr;
    QMenu* shape_menu = nullptr;  ///< in the menu of `more`; in the place of `shapes` where the table has no room
  };

  void refreshState();
  void build();
  void buildHeads(QGridLayout& grid);
  void buildRow(QGridLayout& grid, std::size_t index);
  Point buildPoint(QGridLayout& grid, std::size_t index, std::size_t point);
  void buildMore(QGridLayout& grid, std::size_t index, Row& row);
  void foldShapes(QGridLayout& grid);
  static void nameRow(const Row& row, const fuzzy::Term& term);
  bool sameRows() const;
  void showValues();
  void showLocks();
  void showSelection();

  TermController& terms_;
  std::vector<Row> rows_;
  bool building_ = false;
  bool folded_ = false;  ///< the shapes are in the menus of the rows, for want of room
};

// Sliders for the vertices of the selected term, as in the paper. They follow the plot and the numbers.

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
  void refreshState();
  void build(const fuzzy::Term& term);
  void show(const fuzzy::Term& term);

  TermController& terms_;
  QHBoxLayout* layout_;
  ElidedLabel* title_;
  std::vector<Part> parts_;
  std::size_t term_ = 0;  ///< index in the list; the first term if none is selected
  fuzzy::Shape shape_ = fuzzy::Shape::kTrapezoid;
};

class MembershipEditor : public Card {
  Q_OBJECT

 public:
  /// Draws the shapes that `ghost` has as "before" as thin outlines.
  MembershipEditor(EditController& edits, TermController& terms, SceneController& scene, const GhostController& ghost,
                   QWidget* parent = nullptr);

  /// What is odd in the data, and what the build from the answers says: shown beside the terms that it is about.
  void setNotes(BuildNotes notes);
  /// Whether there are records behind the vertices: a study is open.
  void setOriginsKnown(bool known);

 signals:
  /// The user asks where the selected vertex comes from: `point` of a term of the shown list.
  void originAsked(const std::string& variable, const std::string& term, std::size_t point);

 protected:
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void buildPlace();
  void connectAll();
  void showModel();
  void nameVariables();
  void showExperts();
  void showList();
  void showTerms();
  void showGhost();
  void showZoom();
  void showModes();
  void showScope();
  void showNotes();
  void askScope();
  void showLocks();
  void showSelection();
  void showValue();
  void showRefusal(const QString& sentence);
  void showHint();
  void askAdd();
  void askOrigin(std::size_t term, std::size_t point);
  PlotTable table();

  EditController& edits_;
  TermController& terms_;
  SceneController& scene_;
  const GhostController& ghost_;
  QTabBar* variables_;
  QComboBox* whose_;
  QCheckBox* own_;
  QLabel* scope_;
  QToolButton* for_one_;
  QToolButton* for_all_;
  QCheckBox* keeps_sum_;
  QToolButton* add_;
  NotesButton* notes_button_;
  QToolButton* origin_;
  QToolButton* zoom_;  ///< to where the corners stand close, and back
  BuildNotes notes_;
  MembershipEditorPlot* plot_;
  ElidedLabel* hint_;
  QTimer* hint_time_;
  TermSliders* sliders_;
  TermTable* table_;
  bool filling_ = false;
};

}  // namespace tactus::workbench
