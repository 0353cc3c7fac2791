#include "app/workbench/selection_parts.h"

#include <algorithm>

#include "app/editing/changed_parts.h"
#include "app/workbench/edit_parts.h"
#include "app/workbench/history_parts.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/model/selection.h"
#include "app/workbench/shell/main_window.h"
#include "app/workbench/shell/panel_area.h"
#include "app/workbench/tune/findings/findings_controller.h"
#include "app/workbench/tune/history/history_panel.h"
#include "app/workbench/tune/terms/term_controller.h"

namespace tactus::workbench {

SelectionParts::SelectionParts(MainWindow& window, Selection& selection, TermController& terms,
                               FindingsController& findings, EditController& edits, HistoryParts& history,
                               Panel& rule_editor, EditParts& edit_parts)
    : window_(window), selection_(selection), terms_(terms), edits_(edits) {
  connect(&selection_, &Selection::rulesPointed, this, [this, &rule_editor] { bringForward(rule_editor); });
  connect(&selection_, &Selection::termPointed, this, [this, &edit_parts] {
    showTerm();
    bringForward(edit_parts.panel());
  });
  connect(&selection_, &Selection::editAsked, this, [this, &rule_editor] {
    window_.enter(Stage::kTune);
    rule_editor.reveal();
    selection_.pointAtRules(selection_.expert(), selection_.rules());
    rule_editor.setFocus();
  });
  connect(&findings, &FindingsController::rulePointed, this,
          [this](const QString& expert, std::size_t rule) { selection_.pointAtRules(expert.toStdString(), {rule}); });
  connect(&findings, &FindingsController::lookedAt, this, [this, &findings] { selectChosen(findings); });
  connect(&history.view(), &HistoryPanel::visited, this, &SelectionParts::showEdit);
}

// While the model is understood, the editors are elsewhere and stay there until the user asks for them.
void SelectionParts::bringForward(Panel& editor) {
  if (window_.stage() == Stage::kTune) editor.reveal();
}

void SelectionParts::showTerm() {
  const editing::TermPlace& place = *selection_.term();
  terms_.setExpert(place.list.expert);
  terms_.setVariable(place.list.variable);
  const auto& terms = terms_.terms();
  const auto found =
      std::find_if(terms.begin(), terms.end(), [&](const fuzzy::Term& term) { return term.id == place.term; });
  if (found == terms.end()) return;
  terms_.select(Grip{static_cast<std::size_t>(found - terms.begin()), Grip::Part::kTerm});
}

// Silently: the findings stay in front while the user goes through them.
void SelectionParts::selectChosen(const FindingsController& findings) {
  if (!findings.chosen() || !findings.isCurrent()) return;
  const auto& rules = findings.findings()[*findings.chosen()].rules;
  std::vector<std::size_t> of_first;
  for (const RuleOfExpert& one : rules) {
    if (one.expert == rules.front().expert) of_first.push_back(one.rule);
  }
  if (of_first.empty()) return;
  selection_.setExpert(rules.front().expert);
  selection_.selectRules(std::move(of_first));
}

void SelectionParts::showEdit(editing::StateId state) {
  const auto before_it = edits_.history().states()[state].parent;
  if (!before_it) return;
  const auto before = edits_.readyOf(*before_it);
  const auto after = edits_.readyOf(state);
  if (!before || !after) return;
  const editing::ChangedParts parts = editing::changedParts((*before)->model, (*after)->model);
  if (!parts.rules.empty()) {
    selection_.pointAtRules(parts.expert, parts.rules);
  } else if (parts.term) {
    selection_.pointAtTerm(*parts.term);
  }
}

}  // namespace tactus::workbench
