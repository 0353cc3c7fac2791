// The rule editor of one expert: grids to fill in and a list of all rules. A low panel shows one of the two at a time.
#pragma once

#include <QAbstractButton>
#include <QFrame>
#include <QRectF>
#include <QSize>
#include <QStyledItemDelegate>
#include <QWidget>
#include <optional>
#include <vector>

#include "app/workbench/kit/cards.h"
#include "app/workbench/tune/rules/rule_controller.h"
#include "core/fuzzy/force_model.h"

class QCheckBox;
class QComboBox;
class QGridLayout;
class QScrollArea;
class QSplitter;
class QTabBar;
class QKeyEvent;
class QLabel;
class QLineEdit;
class QTableView;
class QToolButton;
class QPushButton;
class QMenu;

namespace tactus::workbench {

class ElidedLabel;
class NumberBox;
class Refresh;
class RuleController;
class RuleGrids;
class Flash;
class RuleForm;
class RuleListModel;
class RuleListFilter;

// The rules as grids of force words: condition against region. The user answers with the number keys or the mouse.

/// The positions of the cells of the rule grids. The grids stand one above the other, below common column heads.
class RuleGridGeometry {
 public:
  struct Needs {
    std::vector<std::size_t> rows;  ///< per grid
    std::size_t columns = 0;
    double row_head = 0;  ///< px, width of the row heads
    double line = 0;      ///< px, height of a line of text
    double cell = 0;      ///< px, width for the longest word
  };

  RuleGridGeometry() = default;
  RuleGridGeometry(Needs needs, QSizeF room);

  /// The size below which the grids need scroll bars.
  static QSizeF smallest(const Needs& needs);

  QRectF cell(const RuleCell& cell) const;
  QRectF columnHead(std::size_t column) const;
  QRectF corner() const;
  QRectF title(std::size_t grid) const;
  QRectF rowHead(std::size_t grid, std::size_t row) const;
  std::optional<RuleCell> at(QPointF place) const;

 private:
  double rowTop(std::size_t grid, std::size_t row) const;

  Needs needs_;
  double width_ = 0;
  double cell_width_ = 0;
  double cell_height_ = 0;
};

class Flash;

class RuleGrids : public QWidget {
  Q_OBJECT

 public:
  explicit RuleGrids(RuleController& rules, QWidget* parent = nullptr);

  QSize sizeHint() const override { return minimumSizeHint(); }
  QSize minimumSizeHint() const override;
  /// The rectangle of a cell, in the coordinates of the widget.
  QRect cellRect(const RuleCell& cell) const { return places().cell(cell).toRect(); }
  /// A menu of the words for the selected cell.
  QMenu* makeMenu();

 public slots:
  /// Shows the current rules.
  void showRules();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;
  bool event(QEvent* event) override;

 private:
  void measureAnew();
  RuleGridGeometry::Needs measured() const;
  const RuleGridGeometry::Needs& needs() const;
  const RuleGridGeometry& places() const;
  bool answerKey(int key);
  bool moveKey(int key);
  void paintHeads(QPainter& painter) const;
  void paintGrid(QPainter& painter, std::size_t grid) const;
  void paintCell(QPainter& painter, const RuleCell& place) const;
  void paintSelection(QPainter& painter) const;
  QString tipOf(const RuleCell& cell) const;

  RuleController& rules_;
  Flash* flash_;
  // For the current rules; computed on demand.
  mutable std::optional<RuleGridGeometry::Needs> needs_;
  mutable std::optional<RuleGridGeometry> geometry_;
};

// All rules of the expert as a list to filter, sort and edit, with the form for any rule.

// Paints the list of rules and edits it in place: force words in their colors, weights as numbers.

class RuleListDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  /// `flash` lights up the selected rows.
  RuleListDelegate(const RuleController& rules, const Flash& flash, QObject* parent = nullptr);

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  void setEditorData(QWidget* editor, const QModelIndex& index) const override;
  void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override;

 protected:
  bool eventFilter(QObject* editor, QEvent* event) override;
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;

 private:
  void paintCell(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const;
  void paintWord(QPainter& painter, const QRectF& place, const QModelIndex& index) const;

  const RuleController& rules_;
  const Flash& flash_;
};

// The form for any rule: a term or nothing for each input, the consequent, the weight.

class RuleForm : public QFrame {
  Q_OBJECT

 public:
  explicit RuleForm(RuleController& rules, QWidget* parent = nullptr);

  /// Opens the form for a new rule.
  void openNew();
  /// Opens the form for rule `rule`, to replace it.
  void openFor(std::size_t rule);
  /// Updates the form to the current rules and terms.
  void refreshState();

 signals:
  /// Rule `rule` now has the contents of the form.
  void done(std::size_t rule);

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  struct Line {
    std::string input;
    QComboBox* terms = nullptr;
  };

  void buildLines();
  void fill();
  void show(const fuzzy::Rule& rule);
  void showTarget();
  void say(const QString& sentence, bool refused);
  fuzzy::Rule typed() const;
  void accept();

  RuleController& rules_;
  std::optional<std::size_t> target_;  ///< the rule to replace; nothing for a new one
  fuzzy::Rule before_;                 ///< that rule when the form was opened
  QLabel* title_;
  QWidget* lines_place_;
  QGridLayout* lines_grid_;
  std::vector<Line> lines_;
  QLabel* then_label_;
  QComboBox* then_;
  NumberBox* weight_;
  QPushButton* accept_;
  QLabel* message_;
};

class RuleListPane : public QWidget {
  Q_OBJECT

 public:
  explicit RuleListPane(RuleController& rules, QWidget* parent = nullptr);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void buildTable();
  void buildPlace();
  void connectAll();
  void refresh();
  void sync();
  void showSelected();
  void showPointed();
  bool answerWithKey(QKeyEvent* event);
  void copy();
  void paste();
  void showCount();
  void showActions();
  void fitRows();
  std::vector<std::size_t> chosen() const;
  void enable(bool enabled);
  void remove();
  void edit();
  void showRule(std::size_t rule);
  void openMenu(QPoint at);

  RuleController& rules_;
  RuleListModel* list_;
  RuleListFilter* sieve_;
  QLineEdit* text_;
  QComboBox* only_;
  QLabel* count_;
  QTableView* table_;
  QToolButton* add_;
  QToolButton* edit_;
  QToolButton* enable_;
  QToolButton* disable_;
  QToolButton* remove_;
  QToolButton* go_;
  Flash* flash_;
  RuleForm* form_;
  Refresh* refresh_;
  bool stale_ = true;     ///< rules changed after the list took them
  bool showing_ = false;  ///< the table takes over the selection of the program
};

// The force words as buttons with their colors and keys: a legend of the grids, and a way to answer with the mouse.

/// A button with a force word on its color, and the key for the same word.
class WordButton : public QAbstractButton {
  Q_OBJECT

 public:
  /// Without a color the button means "no answer".
  WordButton(const QString& word, const QString& key, std::optional<QColor> color, QWidget* parent);

  /// Marks the button as the current answer.
  void setMarked(bool marked);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return {24, sizeHint().height()}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString key_;
  std::optional<QColor> color_;
  bool marked_ = false;
};

class WordBar : public QWidget {
  Q_OBJECT

 public:
  explicit WordBar(QWidget* parent = nullptr);

  /// Sets the words of the output. Makes new buttons only if the words differ.
  void setWords(const std::vector<fuzzy::Term>& words);
  /// Marks the word of the current answer; nothing if there is no answer to change.
  void setAnswer(std::optional<std::size_t> word);

 signals:
  void chosen(std::size_t word);
  void cleared();

 private:
  QGridLayout* grid_;
  QStringList words_;
  std::vector<WordButton*> buttons_;
  WordButton* none_ = nullptr;
};

// The bar of the selected cell: its conditions in words, the possible answers, the weight and the enabled state.

class RuleCellBar : public QWidget {
  Q_OBJECT

 public:
  explicit RuleCellBar(RuleController& rules, QWidget* parent = nullptr);

  /// Shows the current rules and selection.
  void showCell();

 signals:
  /// A number was typed: the keyboard focus returns to the grids.
  void done();

 private:
  RuleController& rules_;
  ElidedLabel* conditions_;
  NumberBox* weight_;
  QCheckBox* enabled_;
  WordBar* words_;
  bool warns_ = false;
};

// The grids with the bar of the selected cell and a line that explains the keys.

class RuleGridPane : public QWidget {
  Q_OBJECT

 public:
  explicit RuleGridPane(RuleController& rules, QWidget* parent = nullptr);

 private:
  void showRules();
  void showSelection();

  RuleController& rules_;
  QScrollArea* area_;
  RuleGrids* grids_;
  RuleCellBar* cell_;
  ElidedLabel* hint_;
  Refresh* refresh_;
};

class RuleEditor : public Card {
  Q_OBJECT

 public:
  explicit RuleEditor(RuleController& rules, QWidget* parent = nullptr);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void showHead();
  void arrange();

  RuleController& rules_;
  QComboBox* experts_;
  QComboBox* columns_;
  QTabBar* tabs_;
  QSplitter* panes_;
  bool tall_ = false;
  Refresh* refresh_;
};

}  // namespace tactus::workbench
