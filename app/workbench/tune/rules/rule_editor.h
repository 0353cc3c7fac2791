// The rule editor of one expert: grids to fill in and a list of all rules. A low panel shows one of the two at a time.
#pragma once

#include <QAbstractButton>
#include <QWidget>
#include <optional>
#include <vector>

#include "app/workbench/kit/cards.h"
#include "core/fuzzy/force_model.h"

class QCheckBox;
class QComboBox;
class QGridLayout;
class QScrollArea;
class QSplitter;
class QTabBar;

namespace tactus::workbench {

class ElidedLabel;
class NumberBox;
class Refresh;
class RuleController;
class RuleGrids;

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
