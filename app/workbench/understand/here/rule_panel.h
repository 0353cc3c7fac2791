// Why the force at the reading place is what it is: words, experts and moves that would be felt; below them the rules
// that fire and how they produce the force, for one expert or for the mean.
#pragma once

#include <QColor>
#include <QRectF>
#include <QStringList>
#include <QWidget>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/editing/term_list.h"
#include "app/workbench/base/computed.h"
#include "app/workbench/base/plot_table.h"
#include "app/workbench/kit/cards.h"
#include "app/workbench/model/open_model.h"
#include "app/workbench/plot/chart.h"
#include "core/analysis/explain.h"
#include "core/analysis/reasons.h"
#include "core/fuzzy/force_model.h"

class QComboBox;
class QLabel;
class QScrollArea;
class QStackedWidget;
class QToolButton;

namespace tactus::workbench {

class ElidedLabel;
class PlotMenu;
class ReadingCursor;
class Refresh;
class RuleFlow;
class SceneController;
class Selection;

// What holds the force down and what pulls it up: the numbers of `tactus why` (docs/why.md), one line each. A click on
// a word, or Enter, shows the rules that say it; on a move, the terms and rules by which it acts; on a rule, the way to
// the answer behind it.

class WhyView : public QWidget {
  Q_OBJECT

 public:
  enum class Kind { kHead, kNote, kWord, kRule, kAnswer, kExpert, kMove, kTerm };
  struct Line {
    Line(Kind is, QStringList says) : kind(is), cells(std::move(says)) {}

    Kind kind;
    QStringList cells;             ///< the name, then numbers
    std::optional<double> pull_n;  ///< a bar left or right of zero
    QColor color;                  ///< of the bar, or of the expert
    std::size_t expert = 0;        ///< kRule, kAnswer, kExpert: index in the model
    std::size_t rule = 0;          ///< kRule, kAnswer: index in the expert's rules
    std::size_t input = 0;         ///< kMove, kTerm: index in the model
    std::string term;              ///< kWord: of the output; kTerm: of the input
    QString key{};                 ///< where the keys are; no other line has it
  };

  explicit WhyView(QWidget* parent = nullptr);

  /// `reasons` are of `open` at `point`, of the mean or of one expert. What was chosen stays chosen.
  void set(std::shared_ptr<const OpenModel> open, std::vector<double> point, std::optional<std::size_t> expert,
           std::shared_ptr<const analysis::Reasons> reasons);
  void clear();
  /// Whether a rule has a line that leads to the answer behind it: a study is open.
  void setAnswersKnown(bool known);

  /// The words with the rules of the chosen one; then the experts, and the moves with what the chosen one acts by.
  const std::vector<Line>& words() const { return words_; }
  const std::vector<Line>& others() const { return others_; }
  /// The rules of `expert` that say `term` here, strongest pull first.
  std::vector<std::size_t> rulesOf(std::size_t expert, const std::string& term) const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 signals:
  void wordChosen(const std::string& term);
  void expertChosen(std::size_t expert);
  void ruleChosen(std::size_t expert, std::size_t rule);
  /// The rule was chosen once more, or double-clicked.
  void editAsked(std::size_t expert, std::size_t rule);
  void answerAsked(std::size_t expert, std::size_t rule);
  void termAsked(const tactus::editing::TermPlace& place);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;

 private:
  struct Placed {
    const Line* line;
    QRectF place;
    std::vector<double> widths;  ///< of the numbers of its section
  };

  void makeLines();
  void addWords();
  void addExperts();
  void addMoves();
  void addMoved(const analysis::Counterfactual& move);
  void addRule(std::vector<Line>& lines, const analysis::RulePull& rule) const;
  const std::vector<fuzzy::Term>& termsOf(const fuzzy::Variable& input) const;
  std::vector<Placed> placed() const;
  const Line* lineAt(const QPointF& place) const;
  const Line* current() const;
  void moveTo(const Line& line);
  void act(const Line& line);
  void fit();
  void paintLine(QPainter& painter, const Placed& placed) const;

  std::shared_ptr<const OpenModel> open_;
  std::shared_ptr<const analysis::Reasons> reasons_;
  std::vector<Line> words_;
  std::vector<Line> others_;
  std::vector<double> point_;
  std::optional<std::size_t> expert_;  ///< whose reasons; nothing: the mean's
  bool answers_known_ = false;
  std::string chosen_;                                              ///< the word whose rules are shown
  std::optional<std::size_t> chosen_move_;                          ///< the input whose move is shown
  std::optional<std::pair<std::size_t, std::size_t>> chosen_rule_;  ///< expert and rule
  std::optional<QString> current_;                                  ///< key of the line at which the keys are
};

// How the rules of one expert lead to the force: one line per firing rule, strongest first. A line goes from the
// memberships of the conditions over the firing strength to the set of the output term.

class RuleFlow : public QWidget {
  Q_OBJECT

 public:
  explicit RuleFlow(QWidget* parent = nullptr);

  /// Shows expert `expert` of an explanation of `open`.
  void set(std::shared_ptr<const OpenModel> open, const analysis::Explanation& explanation, std::size_t expert);
  /// Marks these rules of the expert.
  void setSelected(const std::vector<std::size_t>& rules);
  /// The lower end of the first selected line, px; 0 without one.
  int selectedBottom() const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 signals:
  /// A click on the line of a rule, or a key that moves there.
  void chosen(std::size_t rule);
  /// A double click on it, or Enter.
  void editAsked(std::size_t rule);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;

 private:
  struct Columns {
    std::vector<QRectF> inputs;  ///< one per entry of inputs_
    QRectF strength;
    QRectF output;
  };

  Columns columns(double top, double height) const;
  double lineTop(std::size_t line) const;
  std::optional<std::size_t> lineAt(double y) const;
  std::optional<std::size_t> selectedLine() const;
  QString sentenceOf(std::size_t line) const;
  void paintHead(QPainter& painter) const;
  void paintLine(QPainter& painter, std::size_t line) const;
  void paintCondition(QPainter& painter, const QRectF& cell, std::size_t input,
                      const analysis::ExplainedRule& rule) const;
  void paintStrength(QPainter& painter, const QRectF& cell, const analysis::ExplainedRule& rule) const;
  void paintOutput(QPainter& painter, const QRectF& cell, const analysis::ExplainedRule& rule) const;

  std::shared_ptr<const OpenModel> open_;
  std::size_t expert_ = 0;
  analysis::ExplainedExpert explained_;
  std::vector<double> values_;                   ///< values of the inputs, inside their universes
  std::vector<std::size_t> inputs_;              ///< the inputs that the expert's rules use
  std::vector<analysis::ExplainedRule> acting_;  ///< strongest first
  std::vector<std::size_t> selected_;            ///< rules of the expert
};

// How the forces of the experts lead to the mean: one line per expert with the set of its rules, the centroid of the
// set, and the expert's share in the mean.

/// Shows the explanation of the scene; it copies nothing, so that hundreds of experts cost only what is in sight.
class ExpertFlow : public QWidget {
  Q_OBJECT

 public:
  explicit ExpertFlow(const SceneController& scene, QWidget* parent = nullptr);

  /// The explanation changed.
  void refreshState();

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 signals:
  /// The user clicked the line of `expert`.
  void chosen(std::size_t expert);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;

 private:
  void paintLine(QPainter& painter, std::size_t expert) const;
  QString strongestRule(std::size_t expert) const;

  std::size_t count() const;

  const SceneController& scene_;
};

// The output sets of the rules, their aggregation, and its centroid, which is the force.

class OutputSetsPlot : public ChartView {
  Q_OBJECT

 public:
  explicit OutputSetsPlot(QWidget* parent = nullptr);

  /// Shows the sets of one expert in the colors of their terms.
  void showExpert(const fuzzy::ForceModel& model, const analysis::Explanation& explanation, std::size_t expert);
  /// Shows one set per expert in the color of the expert, and the mean.
  void showExperts(const fuzzy::ForceModel& model, const analysis::Explanation& explanation);

  /// The corners of the drawn sets: set, force, height.
  void fillTable(PlotTable& table) const;

 private:
  /// Shows the sets with the mark of the force that follows from them.
  void showSets(Chart sets, bool fired, double force_n, const QString& tag);

  ReadingCursor* cursor_;
};

class RulePanel : public Card {
  Q_OBJECT

 public:
  RulePanel(const SceneController& scene, Selection& selection, QWidget* parent = nullptr);

  /// Whether the answers behind the rules can be asked for: a study is open.
  void setAnswersKnown(bool known) { why_->setAnswersKnown(known); }

 signals:
  /// The user asks for the answer behind a rule of the expert with this id.
  void answerAsked(const std::string& expert, const tactus::fuzzy::Rule& rule);

 private:
  void adoptModel();
  void choose(int row);
  void chooseByHand(int row);
  void adoptExpert();
  void showSelected();
  void point(std::size_t rule);
  void explain();
  void askWhy();
  void showWhy();
  void showRulesOf(const std::string& term);
  void pointOf(std::size_t expert, const std::vector<std::size_t>& rules);
  QString summary() const;
  PlotTable table();

  /// Whose force, and where; `expert`: nothing for the mean.
  struct WhyPlace {
    std::shared_ptr<const OpenModel> open;
    std::vector<double> point;
    std::optional<std::size_t> expert;
    bool operator==(const WhyPlace&) const = default;
  };
  WhyPlace whyPlace() const;

  const SceneController& scene_;
  Selection& selection_;
  QComboBox* who_;
  ElidedLabel* summary_;
  QToolButton* edit_;
  QScrollArea* area_;
  QStackedWidget* flows_;
  QLabel* sentence_;
  WhyView* why_;
  RuleFlow* rules_;
  ExpertFlow* experts_;
  OutputSetsPlot* sets_;
  Refresh* refresh_;
  std::optional<WhyPlace> asked_;
  Computed<WhyPlace, analysis::Reasons>* reasons_;
};

}  // namespace tactus::workbench
