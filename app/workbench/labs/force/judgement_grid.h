// The judgements of one series as a table: a row for each participant, a column for each force, and in each cell
// what the participant said. A force that was judged more than once has all its words in one cell.
#pragma once

#include <string>
#include <vector>

#include "app/session/judged_forces.h"
#include "app/workbench/base/columns.h"
#include "core/fuzzy/force_model.h"
#include "experiments/judgement_checks.h"

namespace tactus::workbench {

/// The checks of each participant's judgements as an item model (experiments/judgement_checks.h): falling words, rising
/// against falling forces, repeats, blanks, limits between words, and times.
struct ParticipantChecks {
  std::string participant;
  experiments::JudgementChecks checks;
};

/// The checks of every participant in `all`, in its order. `words`: the force with its words. Thread: any.
std::vector<ParticipantChecks> judgementChecks(const fuzzy::Variable& words,
                                               const std::vector<session::JudgedForce>& all);

inline constexpr int kNotableRole = kOrderRole + 1;  ///< bool: deserves attention
std::vector<Column<ParticipantChecks>> checkColumns();

/// A participant with the judgements of each force, in their order.
struct JudgedRow {
  std::string participant;
  std::vector<std::vector<session::JudgedForce>> cells;
};

class JudgementGrid : public Columns<JudgedRow> {
 public:
  explicit JudgementGrid(QObject* parent = nullptr) : Columns(parent) {}

  /// `words`: the force with its words. Only judgements of `series` are shown; `all` has those of every series.
  void setJudgements(const fuzzy::Variable& words, const std::vector<session::JudgedForce>& all,
                     const std::string& series);

  const std::string& participant(int index) const { return row(index).participant; }
  /// The column of the force, or -1.
  int columnOf(double force_n) const;
  const fuzzy::Variable& words() const { return words_; }
  /// The judgements of a cell, in their order.
  std::vector<const session::JudgedForce*> at(const QModelIndex& index) const;

 private:
  fuzzy::Variable words_;
  std::vector<double> forces_n_;  ///< of the columns, ascending
};

/// What a judgement says: a word's label, `not felt`, `beyond practice`, `no answer`.
QString judgedText(const fuzzy::Variable& words, const session::JudgedWord& word);
session::JudgedWord judgedWord(const study::JudgementRecord& record);

/// The words that `judged` can be corrected to: each answer but its own. `Beyond practice` only where the series ends
/// there: elsewhere the steps after it would have no reason.
std::vector<session::JudgedWord> offeredWords(const fuzzy::Variable& words,
                                              const std::vector<session::JudgedForce>& all,
                                              const session::JudgedForce& judged);

}  // namespace tactus::workbench
