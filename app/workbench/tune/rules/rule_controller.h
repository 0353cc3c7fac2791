// The rules of one expert as they are edited: whose, in which grids, the selected cell, and what the rules do at the
// place that is read. Turns what the hand does with rules into edits.
#pragma once

#include <QObject>
#include <QTimer>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/editing/rule_grid.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/tune/rules/rule_cell.h"

namespace tactus::workbench {

class RuleController : public QObject {
  Q_OBJECT

 public:
  struct Grid {
    editing::GridId id;
    editing::RuleGrid cells;
  };

  RuleController(EditController& edits, const SceneController& scene, QObject* parent = nullptr);

  /// Whether a model is open. Everything below may be called with a model only.
  bool isOpen() const { return edits_.isOpen(); }
  const fuzzy::ForceModel& model() const { return edits_.model(); }

  /// Whose rules are edited.
  const fuzzy::Expert& expert() const;
  /// The words of the answers: the terms of the output as the expert understands them.
  const std::vector<fuzzy::Term>& words() const { return fuzzy::termsFor(expert(), model().output); }
  /// The word with the id `term`, as an index.
  std::optional<std::size_t> wordOf(const std::string& term) const;
  const fuzzy::Variable& input(const std::string& id) const;
  const std::vector<fuzzy::Term>& terms(const std::string& input_id) const;

  /// The input of the columns.
  const std::string& region() const { return region_; }
  /// One grid for each other input, in the model's order; made when asked for.
  const std::vector<Grid>& grids() const;
  const editing::GridCell& cell(const RuleCell& place) const;
  /// `IF Tube lubrication is Well AND Insertion depth is Stomach`.
  QString conditionsOf(const RuleCell& place) const;
  /// What else the rules with the conditions of a cell say that count, beside the one that is shown.
  QStringList otherAnswers(const RuleCell& place) const;
  std::optional<RuleCell> selected() const;

  /// How much rule number `rule` acts at the place that is read, in [0, 1]; also while the comparison shows another
  /// model this is said of the open one.
  double strength(std::size_t rule) const;
  /// How much term number `term` of an input holds there, in [0, 1].
  double membership(const std::string& input_id, std::size_t term) const;
  /// The place that is read, on one input.
  double valueHere(const std::string& input_id) const;

  base::Result<void> add(fuzzy::Rule rule);
  base::Result<void> replace(std::size_t rule, fuzzy::Rule with);

 public slots:
  // Ids come by value: an edit may replace the model that they were read from.
  void setExpert(std::string id);
  void setRegion(std::string id);
  /// A cell that is not there selects nothing.
  void select(std::optional<tactus::workbench::RuleCell> cell);
  /// Moves the selection as the arrow keys do: from grid to grid, not beyond the ends.
  void step(int columns, int rows);
  /// The same cell of the next (1) or previous (-1) grid.
  void stepGrid(int grids);
  /// To the first or last column.
  void stepToEnd(bool last);
  /// To the next cell as they are filled in: along the row, then the next row, then the next grid.
  void goOn();

  /// Answers the selected cell with a word, or takes its answer away. A word that is not there does nothing.
  void answer(std::optional<std::size_t> word);
  void answerAndGoOn(std::size_t word);

  void setConsequent(std::size_t rule, std::string word);
  void setWeight(std::size_t rule, double weight);
  /// Steps of a weight, one gesture until `endWeighing` or a short rest.
  void weigh(std::size_t rule, double weight);
  void endWeighing();
  void enable(const std::vector<std::size_t>& rules, bool enabled);
  void remove(const std::vector<std::size_t>& rules);

 signals:
  /// Another model or expert.
  void expertChanged();
  /// The rules or the terms that they name, or the input of the columns.
  void rulesChanged();
  void selectionChanged();
  /// What acts at the place that is read.
  void hereChanged();

 private:
  struct Selected {
    std::string condition;
    editing::CellPlace place;
  };

  void adoptModel();
  void follow();
  void dropGrids();
  RuleGridSizes sizes() const;
  const analysis::ExplainedExpert* here() const;
  const analysis::Explanation& explanation() const;
  void readAnew();
  base::Result<void> apply(base::Result<editing::Edit> edit);

  EditController& edits_;
  const SceneController& scene_;
  std::string expert_;
  std::string region_;
  std::optional<Selected> selected_;
  mutable std::optional<std::vector<Grid>> grids_;
  mutable std::optional<analysis::Explanation> own_explanation_;  ///< while another model is shown
  std::optional<std::size_t> weighing_;
  QTimer rest_;
};

}  // namespace tactus::workbench
