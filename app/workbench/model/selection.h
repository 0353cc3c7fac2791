// The one selection of the program: an expert, rules of this expert or a gap (a place where the expert has no rule),
// and a term. The rule editor, "Why here", the findings and the history all set it and show it. The operating point
// beside it is that of the SceneController. To point at something is to select it and to ask the editors to show it:
//   a click on rule 12 in "Why here" points at it: the grid and the list select rule 12 and flash it
#pragma once

#include <QObject>
#include <optional>
#include <string>
#include <vector>

#include "app/editing/term_list.h"
#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

class EditController;

/// Thread: gui.
class Selection : public QObject {
  Q_OBJECT

 public:
  /// Follows the model of `edits`, which outlives this. Create it before its users: they then find it up to date.
  explicit Selection(const EditController& edits, QObject* parent = nullptr);

  /// The id of an expert of the open model; empty while no model is open.
  const std::string& expert() const { return expert_; }
  /// The selected rules of this expert: indices in its rules, ascending. A rule stays selected where an edit moves it
  /// or changes anything but its conditions.
  const std::vector<std::size_t>& rules() const { return rules_; }
  /// The conditions of the selected gap; empty: rules are selected, or nothing. A gap that gets a rule is that rule.
  const std::vector<fuzzy::Condition>& gap() const { return gap_; }
  /// The selected rule, if it is exactly one.
  std::optional<std::size_t> rule() const;
  /// The term to which was pointed last; nothing once it is removed.
  const std::optional<editing::TermPlace>& term() const { return term_; }

 public slots:
  // Ids are passed by value, because an edit may replace the model that holds them. What the model does not have is
  // ignored: a view may be a moment older than the model.
  /// Another expert has no selected rules yet.
  void setExpert(std::string id);
  void selectRules(std::vector<std::size_t> rules);
  void selectGap(std::vector<fuzzy::Condition> conditions);
  void pointAtRules(std::string expert, std::vector<std::size_t> rules);
  void pointAtTerm(tactus::editing::TermPlace term);
  /// Asks for the editor of the selected rules, wherever it is.
  void editRules();
  /// Points at `term`, and asks for its editor, wherever it is.
  void editTerm(tactus::editing::TermPlace term);

 signals:
  /// Another expert of the same model; a model that was opened is announced by the EditController alone.
  void expertChanged();
  /// Other rules, or another gap.
  void rulesChanged();
  void rulesPointed();
  void termPointed();
  void editAsked();
  void termEditAsked();

 private:
  void adoptModel();
  void refreshState();
  bool followGap(const std::vector<fuzzy::Rule>& rules);
  void keep();
  const std::vector<fuzzy::Rule>* rulesOfExpert() const;

  const EditController& edits_;
  std::string expert_;
  std::vector<std::size_t> rules_;
  std::vector<fuzzy::Condition> gap_;
  std::vector<fuzzy::Rule> kept_;  ///< the selected rules as they are in the model
  std::optional<editing::TermPlace> term_;
};

}  // namespace tactus::workbench
