// The edited rules of one expert: the grids, the selected cell, and the strength of each rule at the reading place.
// Turns the user's actions into edits. Expert, selected rules and the selected gap are those of the Selection.
#pragma once

#include <QObject>
#include <QTimer>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/editing/rule_grid.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/scene_controller.h"
#include "app/workbench/model/selection.h"
#include "core/analysis/explain.h"

namespace tactus::workbench {

class EditController;
class SceneController;
class Selection;

// What the rules of the selected expert do at the reading place. It belongs to the open model, also while a comparison
// shows another one.

class RulesHere {
 public:
  RulesHere(const EditController& edits, const SceneController& scene, const Selection& selection);

  /// The strength of rule `rule`, in [0, 1].
  double strength(std::size_t rule) const;
  /// The membership of term `term` of an input, in [0, 1].
  double membership(const std::string& input_id, std::size_t term) const;
  /// The value of an input there.
  double value(const std::string& input_id) const;

  /// The model or the place changed.
  void forget() { own_.reset(); }

 private:
  const analysis::ExplainedExpert* expert() const;
  const analysis::Explanation& explanation() const;

  const EditController& edits_;
  const SceneController& scene_;
  const Selection& selection_;
  mutable std::optional<analysis::Explanation> own_;  ///< while another model is shown
};

// A cell of the rule grids, and the moves between cells.

/// A cell of the grids. The grids stand one above the other.
struct RuleCell {
  std::size_t grid = 0;
  std::size_t row = 0;
  std::size_t column = 0;

  bool operator==(const RuleCell&) const = default;
};

/// The numbers of cells. Every grid has at least one row, and there is at least one column.
struct RuleGridSizes {
  std::vector<std::size_t> rows;  ///< per grid
  std::size_t columns = 0;        ///< of every grid

  bool has(const RuleCell& cell) const {
    return cell.grid < rows.size() && cell.row < rows[cell.grid] && cell.column < columns;
  }
  /// The first cell; nothing if there is no grid.
  std::optional<RuleCell> first() const { return rows.empty() ? std::nullopt : std::optional(RuleCell()); }
};

// In all these functions `from` is a cell of `sizes`.

/// The next cell for an arrow key: crosses from grid to grid, stops at the ends. Only the signs of `columns` and `rows`
/// count.
RuleCell stepped(const RuleGridSizes& sizes, RuleCell from, int columns, int rows);
/// The same cell `count` grids below, or in the last grid.
RuleCell steppedGrid(const RuleGridSizes& sizes, RuleCell from, int count);
/// The next cell in the order of filling in: along the row, then the next row, then the next grid. The last cell
/// returns itself.
RuleCell nextToFill(const RuleGridSizes& sizes, RuleCell from);

class RuleController : public QObject {
  Q_OBJECT

 public:
  struct Grid {
    editing::GridId id;
    editing::RuleGrid cells;
  };

  RuleController(EditController& edits, SceneController& scene, Selection& selection, QObject* parent = nullptr);

  /// Whether a model is open. All other functions need an open model.
  bool isOpen() const { return edits_.isOpen(); }
  const fuzzy::ForceModel& model() const { return edits_.model(); }

  /// The expert whose rules are edited.
  const fuzzy::Expert& expert() const;
  /// The force words: the terms of the output as this expert defines them.
  const std::vector<fuzzy::Term>& words() const { return fuzzy::termsFor(expert(), model().output); }
  /// The index of the word with the id `term`.
  std::optional<std::size_t> wordOf(const std::string& term) const;
  const fuzzy::Variable& input(const std::string& id) const;
  const std::vector<fuzzy::Term>& terms(const std::string& input_id) const;

  /// The input of the columns.
  const std::string& region() const { return region_; }
  /// One grid for each input but the region's, in the model's order; computed on demand.
  const std::vector<Grid>& grids() const;
  const editing::GridCell& cell(const RuleCell& place) const;
  /// `IF Tube lubrication is Well AND Insertion depth is Stomach`.
  QString conditionsOf(const RuleCell& place) const;
  /// The consequents of further rules with the conditions of a cell, beside the shown rule. Only rules that count:
  /// enabled, with a weight > 0.
  QStringList otherAnswers(const RuleCell& place) const;
  std::optional<RuleCell> selected() const;
  /// The cell of a rule with exactly the two conditions of a cell; nothing for another rule.
  std::optional<RuleCell> cellOf(std::size_t rule) const;
  /// The same of a place with these conditions.
  std::optional<RuleCell> cellOf(const std::vector<fuzzy::Condition>& conditions) const;
  /// What is selected in the whole program.
  Selection& selection() { return selection_; }

  /// The strength of rule `rule` at the reading place, in [0, 1]. It belongs to the open model, also while a comparison
  /// shows another one.
  double strength(std::size_t rule) const { return here_.strength(rule); }
  /// The membership of term `term` of an input there, in [0, 1].
  double membership(const std::string& input_id, std::size_t term) const { return here_.membership(input_id, term); }
  /// The value of an input at the reading place.
  double valueHere(const std::string& input_id) const { return here_.value(input_id); }

  base::Result<void> add(fuzzy::Rule rule);
  base::Result<void> replace(std::size_t rule, fuzzy::Rule with);

 public slots:
  // Ids are passed by value, because an edit may replace the model that holds them.
  void setExpert(std::string id);
  void setRegion(std::string id);
  /// Selects a cell; a cell that does not exist clears the selection.
  void select(std::optional<tactus::workbench::RuleCell> cell);
  /// Moves the selection like the arrow keys: from grid to grid, not beyond the ends.
  void step(int columns, int rows);
  /// Selects the same cell of the next (1) or previous (-1) grid.
  void stepGrid(int grids);
  /// Selects the first or last column.
  void stepToEnd(bool last);
  /// Gives the keys a cell to begin with, without selecting its rule.
  void beginAnywhere();
  /// Selects the next cell in the order of filling in: along the row, then the next row, then the next grid.
  void goOn();

  /// Answers the selected cell with a word; nothing removes its answer. Ignores a word that does not exist.
  void answer(std::optional<std::size_t> word);
  void answerAndGoOn(std::size_t word);

  // Several rules at once are one step of undo.
  void setConsequent(const std::vector<std::size_t>& rules, std::string word);
  void setWeight(const std::vector<std::size_t>& rules, double weight);
  /// One step of a weight. Steps are one gesture until `endWeighing` or a short pause.
  void weigh(std::size_t rule, double weight);
  void endWeighing();
  void enable(const std::vector<std::size_t>& rules, bool enabled);
  void remove(const std::vector<std::size_t>& rules);
  /// The selected rules as lines of text (editing/rule_text.h); empty if none is selected.
  QString copied() const;
  /// Puts rules from such text among those of the expert, and selects them. One line that is no rule refuses all of
  /// them, with a sentence that names it.
  void paste(const QString& lines);
  /// Moves the operating point to where the first selected rule acts.
  void goWhereItActs();

 signals:
  /// The user asks where the selected rule comes from.
  void originAsked();
  /// Another model or expert.
  void expertChanged();
  /// The rules, the terms that they name, or the input of the columns changed.
  void rulesChanged();
  void selectionChanged();
  /// The strengths at the reading place changed.
  void hereChanged();

 private:
  struct Selected {
    std::string condition;
    editing::CellPlace place;
  };

  void adoptModel();
  void adoptExpert();
  void adoptRegion();
  void adoptSelection();
  void refreshState();
  void selectRuleOfCell();
  void dropGrids();
  RuleGridSizes sizes() const;
  void readAnew();
  base::Result<void> apply(base::Result<editing::Edit> edit);

  EditController& edits_;
  SceneController& scene_;
  Selection& selection_;
  RulesHere here_;
  std::string region_;
  std::optional<Selected> selected_;
  mutable std::optional<std::vector<Grid>> grids_;
  std::optional<std::size_t> weighing_;
  QTimer rest_;
};

}  // namespace tactus::workbench
