// The identity of an edited term list: the shared list of a variable, or an expert's own list. The rules of an expert
// use ("read") the own list if there is one, otherwise the shared list:
//   S4 has an own list for depth: its rules read that list.
//   S1, S2 and S3 have none: their rules read the shared list of depth.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/editing/edit.h"

namespace tactus::editing {

/// A list of terms of one variable, an input or the output.
struct TermListId {
  std::string variable;
  std::string expert;  ///< id of the owner; empty: the shared list of the variable

  bool operator==(const TermListId&) const = default;
};

struct TermPlace {
  TermListId list;
  std::string term;

  bool operator==(const TermPlace&) const = default;
};

/// The treatment of rules that name a removed term.
enum class RulesOfTerm {
  kRefuse,  ///< the edit is refused if there are any
  kRemove,  ///< they are removed, too
};

/// A list inside a model that is being edited. Valid while the model does not move and keeps its experts.
struct OpenList {
  const fuzzy::Variable* variable = nullptr;
  fuzzy::Expert* expert = nullptr;  ///< null for the shared list
  std::vector<fuzzy::Term>* terms = nullptr;

  std::string scope;  ///< for a list that several experts read: ` (S1, S2, S3)`, ` (5 of 12 experts)`

  /// The subject of an edit of the list: `S4, Insertion depth` for an own list, `Insertion depth (S1, S2)` for one that
  /// several experts read, `Insertion depth` in a model of one expert or if no expert reads it.
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

/// The terms of the list; null where the model does not have it.
const std::vector<fuzzy::Term>* termsIn(const fuzzy::ForceModel& model, const TermListId& list);

/// The list that the rules of `expert` read for `variable`: its own or the shared one.
TermListId listOf(const fuzzy::Expert& expert, std::string_view variable);

/// The experts that read the list, as indices.
std::vector<std::size_t> readersOf(const fuzzy::ForceModel& model, const TermListId& list);
/// Their ids as text: `S1, S2, S3`, `all 12 experts`, `5 of 12 experts`; empty for none.
std::string readersText(const fuzzy::ForceModel& model, const TermListId& list);

/// Whether the rules of `expert` read the list.
bool reads(const fuzzy::Expert& expert, const TermListId& list);

/// Gives the expert a copy of the shared list as its own. The force does not change. Refused if the expert has one.
base::Result<Edit> makeOwn(const fuzzy::ForceModel& model, const TermListId& list);
/// Removes the own list of the expert, whose rules read the shared one again. `rules` decides about rules with a term
/// that the shared list lacks.
base::Result<Edit> backToShared(const fuzzy::ForceModel& model, const TermListId& list, RulesOfTerm rules);

}  // namespace tactus::editing
