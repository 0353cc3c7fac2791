// Which list of terms is edited: the one that experts share, or an expert's own.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/editing/edit.h"

namespace tactus::editing {

/// A list of terms of one variable, an input or the output.
struct TermListId {
  std::string variable;
  std::string expert;  ///< id of the expert whose own list it is; empty: the list of the variable

  bool operator==(const TermListId&) const = default;
};

struct TermPlace {
  TermListId list;
  std::string term;

  bool operator==(const TermPlace&) const = default;
};

/// What becomes of rules that name a term which goes away.
enum class RulesOfTerm {
  kRefuse,  ///< the edit is refused while there are any
  kRemove,  ///< they go with it
};

/// A list inside a model that is being edited. Valid while the model stays where it is and keeps its experts.
struct OpenList {
  const fuzzy::Variable* variable = nullptr;
  fuzzy::Expert* expert = nullptr;  ///< null where the list is shared
  std::vector<fuzzy::Term>* terms = nullptr;

  std::string scope;  ///< of a list that several experts read: ` (S1, S2, S3)`, ` (5 of 12 experts)`

  /// What an edit of the list is about, and for whom: `S4, Insertion depth` for an own list, `Insertion depth (S1, S2)`
  /// for one that several experts read, `Insertion depth` where there is nobody else.
  std::string title() const;
};

/// The variable `id`, the output included, or an error that lists the variables.
base::Result<const fuzzy::Variable*> findVariable(const fuzzy::ForceModel& model, std::string_view id);
/// The expert `id`, or an error that lists the experts.
base::Result<fuzzy::Expert*> findExpert(fuzzy::ForceModel& model, std::string_view id);
base::Result<const fuzzy::Expert*> findExpert(const fuzzy::ForceModel& model, std::string_view id);

/// Refused: an unknown variable or expert, an expert without an own list for the variable.
base::Result<OpenList> openList(fuzzy::ForceModel& model, const TermListId& list);
/// Position of the term in the list, or an error that lists the terms.
base::Result<std::size_t> findTermIn(const OpenList& list, std::string_view term);

/// The list that the rules of `expert` resolve against for `variable`: its own or the shared one.
TermListId listOf(const fuzzy::Expert& expert, std::string_view variable);

/// The experts whose rules resolve against the list, as indices.
std::vector<std::size_t> readersOf(const fuzzy::ForceModel& model, const TermListId& list);
/// Their ids for a person: `S1, S2, S3`, `all 12 experts`, `5 of 12 experts`; empty for nobody.
std::string readersText(const fuzzy::ForceModel& model, const TermListId& list);

/// Whether the rules of `expert` resolve against the list.
bool reads(const fuzzy::Expert& expert, const TermListId& list);

/// Gives the expert a copy of the shared list as its own; the force stays as it is. Refused where it has one.
base::Result<Edit> makeOwn(const fuzzy::ForceModel& model, const TermListId& list);
/// Drops the own list of the expert: its rules resolve against the shared one again. `rules` says what becomes of rules
/// with a term that the shared list does not have.
base::Result<Edit> backToShared(const fuzzy::ForceModel& model, const TermListId& list, RulesOfTerm rules);

}  // namespace tactus::editing
