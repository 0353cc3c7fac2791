// The list of terms that is edited, and how: whose list of which variable, what is held, which vertices are locked, and
// whether the terms keep their sum of one. Turns what the hand does with membership functions into edits.
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

  /// Whether a model is open. Everything below may be called with a model only.
  bool isOpen() const { return edits_.isOpen(); }
  const fuzzy::ForceModel& model() const { return edits_.model(); }

  /// The list that is edited. With an expert chosen who has no list of its own for the variable, this is the shared
  /// one.
  const editing::TermListId& list() const { return list_; }
  const fuzzy::Variable& variable() const;
  const std::vector<fuzzy::Term>& terms() const;
  /// The expert that was chosen, or empty for the shared lists.
  const std::string& expert() const { return expert_; }
  /// The experts whose rules resolve against the list.
  std::vector<std::string> readers() const;
  /// Whether the list is that of an expert who was chosen, but others read it too: then edits are for all of them.
  bool isSharedWithOthers() const;
  /// Whether it was said that edits of such a list are for all its readers.
  bool editsForAll() const;

  /// How many rules name the term, of all experts that resolve against the list.
  std::size_t rulesOf(const std::string& term) const;

  /// A good place for a new term: the middle of the widest gap between terms or, where there is none, of the right half
  /// of the widest core.
  double roomiestPlace() const;

  std::optional<Grip> selected() const { return selected_; }
  bool isLocked(const std::string& term, std::size_t point) const;
  /// Whether moves keep the sum of the terms at one. Terms that already have it keep it until the mode is switched off.
  bool keepsSum() const;

 public slots:
  // Ids come by value: an edit may replace the model that they were read from.
  void setVariable(std::string id);
  /// Whose terms: an expert's id, or empty for the shared ones.
  void setExpert(std::string id);
  void select(std::optional<tactus::workbench::Grip> grip);
  /// The handle after (1) or before (-1) the selected one.
  void selectNext(int direction);
  void setLocked(std::string term, std::size_t point, bool locked);
  /// Switching it on is an edit where the terms do not sum to one.
  void setKeepsSum(bool keeps);

  // A move of the hand: begun, moved any number of times, ended or cancelled. `by` counts from the beginning, in the
  // unit of the variable, and is rounded as finely as the values are shown.
  void beginMove(const tactus::workbench::Grip& grip);
  void moveBy(double by);
  void endMove();
  void cancelMove();

  /// One press of an arrow key: `count` steps to the right. Presses until `endSteps` are one gesture.
  void step(int count, bool coarse);
  void endSteps();

  void setPoint(std::string term, std::size_t point, double value);
  void convert(std::string term, fuzzy::Shape shape);
  /// Adds a term with this label around `at`.
  void add(const QString& label, double at);
  void rename(std::string term, const QString& label);
  /// `with_rules`: rules that name it go too; otherwise a term with rules is refused.
  void remove(std::string term, bool with_rules);
  /// Splits a term into parts at `cuts`; rules are copied to the parts.
  void split(std::string term, const std::vector<double>& cuts);
  /// Edits of a list that others read too go to all of them, or to the chosen expert alone, who gets an own list. What
  /// waits for this choice is carried out. The choice stays until another model is opened.
  void chooseScope(bool for_all);
  /// Gives the chosen expert an own list, or takes it back to the shared one.
  void setOwnList(bool own);

 signals:
  /// An edit waits for `chooseScope`.
  void scopeAsked();
  /// It was chosen.
  void scopeChosen();
  /// Other terms are shown: another model, variable or list.
  void listChanged();
  /// The same list with other values, terms or modes.
  void termsChanged();
  void selectionChanged();
  void locksChanged();

 private:
  void adoptModel();
  bool waitsForScope(std::function<void()> edit);
  void follow();
  void resolveList();
  const std::vector<fuzzy::Term>& termsIn(const fuzzy::ForceModel& model) const;
  editing::MoveOptions options() const;
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
  std::vector<editing::TermListId> for_all_;  ///< experts, by variable, whose edits are for all readers
  std::function<void()> pending_;             ///< what waits for the choice
};

}  // namespace tactus::workbench
