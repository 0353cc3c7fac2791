// The membership function editor: the terms of one variable, moved by mouse and keys or typed as numbers.
#pragma once

#include <QScrollArea>
#include <QSlider>
#include <QString>
#include <QWidget>
#include <string>
#include <vector>

#include "app/workbench/base/messages.h"
#include "app/workbench/base/plot_table.h"
#include "app/workbench/kit/cards.h"
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

  void follow();
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
  BuildNotes notes_;
  MembershipEditorPlot* plot_;
  ElidedLabel* hint_;
  QTimer* hint_time_;
  TermSliders* sliders_;
  TermTable* table_;
  bool filling_ = false;
};

}  // namespace tactus::workbench
