// The edited list of terms and its state: variable, owner of the list, selected part, locked vertices, and whether the
// terms keep a sum of one. Turns the user's moves into edits.
#pragma once

#include <QObject>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/editing/membership_edits.h"
#include "app/editing/term_list.h"
#include "app/workbench/model/edit_controller.h"
#include "app/workbench/tune/terms/term_grip.h"

namespace tactus::workbench {

class TermController : public QObject {
  Q_OBJECT

 public:
  explicit TermController(EditController& edits, QObject* parent = nullptr);

  /// Whether a model is open. All other functions need an open model.
  bool isOpen() const { return edits_.isOpen(); }
  const fuzzy::ForceModel& model() const { return edits_.model(); }

  /// The edited list. If the chosen expert has no list of its own for the variable, this is the shared list.
  const editing::TermListId& list() const { return list_; }
  const fuzzy::Variable& variable() const;
  const std::vector<fuzzy::Term>& terms() const;
  /// Why a term cannot be split at `cuts`, in one sentence; empty if it can.
  QString whyNotSplit(const std::string& term, const std::vector<double>& cuts) const;
  /// The chosen expert; empty: the shared lists.
  const std::string& expert() const { return expert_; }
  /// The experts whose rules use the list.
  std::vector<std::string> readers() const;
  /// Whether an expert is chosen but other experts use the same list. An edit then changes all of them.
  bool isSharedWithOthers() const;
  /// Whether the user confirmed that edits of this shared list apply to all its experts.
  bool editsForAll() const;

  /// The number of rules that name the term, over all experts that use the list.
  std::size_t rulesOf(const std::string& term) const;

  std::optional<Grip> selected() const { return selected_; }
  bool isLocked(const std::string& term, std::size_t point) const;
  /// The locked vertices of all lists.
  const std::vector<editing::VertexPlace>& locked() const { return locked_; }
  /// Whether moves keep the sum of the terms at one. On for terms that sum to one, until the user switches it off.
  bool keepsSum() const;

 public slots:
  // Ids are passed by value, because an edit may replace the model that holds them.
  void setVariable(std::string id);
  /// Chooses the owner of the terms: an expert's id, or empty for the shared lists.
  void setExpert(std::string id);
  void select(std::optional<tactus::workbench::Grip> grip);
  /// Selects the next handle (1) or the previous one (-1).
  void selectNext(int direction);
  void setLocked(std::string term, std::size_t point, bool locked);
  /// If the terms do not sum to one, switching it on is an edit.
  void setKeepsSum(bool keeps);

  // A move: begin it, move any number of times, then end or cancel it. `by` counts from the beginning, in the unit of
  // the variable, and is rounded to the displayed precision.
  void beginMove(const tactus::workbench::Grip& grip);
  void moveBy(double by);
  void endMove();
  void cancelMove();

  /// One press of an arrow key: `count` steps to the right. All presses until `endSteps` are one gesture.
  void step(int count, bool coarse);
  void endSteps();

  void setPoint(std::string term, std::size_t point, double value);
  void convert(std::string term, fuzzy::Shape shape);
  /// Adds a term with this label around `at`.
  void add(const QString& label, double at);
  void rename(std::string term, const QString& label);
  /// Removes a term. `with_rules`: also the rules that name it; without it, a term with rules is refused.
  void remove(std::string term, bool with_rules);
  /// Splits a term into parts at `cuts`. Rules are copied to the parts.
  void split(std::string term, const std::vector<double>& cuts);
  /// Decides whether edits of a shared list apply to all its experts or only to the chosen expert, who then gets its
  /// own list. The waiting edit is then made. The decision holds until another model is opened.
  void chooseScope(bool for_all);
  /// Gives the chosen expert its own list, or returns it to the shared list.
  void setOwnList(bool own);

 signals:
  /// An edit waits for `chooseScope`.
  void scopeAsked();
  /// The user decided.
  void scopeChosen();
  /// Another list: the model, the variable or the owner changed.
  void listChanged();
  /// The same list with changed values, terms or modes.
  void termsChanged();
  void selectionChanged();
  void locksChanged();

 private:
  void adoptModel();
  bool waitsForScope(std::function<void()> edit);
  void refreshState();
  void resolveList();
  const std::vector<fuzzy::Term>& termsIn(const fuzzy::ForceModel& model) const;
  editing::MoveOptions options() const;
  void selectTerm(const std::string& id);
  editing::TermPlace placeOf(const std::string& term) const { return {list_, term}; }
  base::Result<editing::Edit> moved(const Grip& grip, double by) const;

  EditController& edits_;
  std::string expert_;
  editing::TermListId list_;
  std::optional<Grip> selected_;
  std::optional<Grip> moving_;
  double stepped_by_ = 0;
  bool stepping_ = false;
  std::vector<editing::VertexPlace> locked_;
  std::vector<editing::TermListId> sum_not_kept_;
  std::vector<editing::TermListId> for_all_;  ///< experts, by variable, whose edits apply to all users of the list
  std::function<void()> pending_;             ///< the edit that waits for the decision
};

}  // namespace tactus::workbench
