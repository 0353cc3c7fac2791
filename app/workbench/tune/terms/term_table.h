// The edited list of terms as a table, one row each: name, shape, every point as a number with its lock, split and
// remove.
#pragma once

#include <QScrollArea>
#include <string>
#include <vector>

#include "core/fuzzy/force_model.h"

class QComboBox;
class QGridLayout;
class QLineEdit;
class QMenu;
class QToolButton;

namespace tactus::workbench {

class LockButton;
class NumberBox;
class TermController;

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

}  // namespace tactus::workbench
