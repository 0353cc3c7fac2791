// The judgements of one series as an item model: a row for each participant, a column for each force, and in each cell
// what the participant said. A force that was judged more than once has all its words in one cell.
#pragma once

#include <QAbstractTableModel>
#include <string>
#include <vector>

#include "app/session/judged_forces.h"
#include "app/workbench/labs/frame/lab_table_model.h"
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

class CheckTable : public LabTableModel {
  Q_OBJECT

 public:
  enum Column { kWho, kReversals, kHysteresis, kRepeats, kBlanks, kThresholds, kAnswerTime, kMotion };
  static constexpr int kNotableRole = Qt::UserRole;  ///< bool: deserves attention

  explicit CheckTable(QObject* parent = nullptr);

  void setChecks(std::vector<ParticipantChecks> checks);

 private:
  int rows() const override { return static_cast<int>(rows_.size()); }
  QVariant cell(int row, int column, int role) const override;

  std::vector<ParticipantChecks> rows_;
};

class JudgementGrid : public QAbstractTableModel {
  Q_OBJECT

 public:
  using QAbstractTableModel::QAbstractTableModel;

  /// `words`: the force with its words. Only judgements of `series` are shown; `all` has those of every series.
  void setJudgements(const fuzzy::Variable& words, const std::vector<session::JudgedForce>& all,
                     const std::string& series);

  const std::string& participant(int row) const { return rows_[static_cast<std::size_t>(row)]; }
  double forceN(int column) const { return columns_[static_cast<std::size_t>(column)]; }
  /// The column of the force, or -1.
  int columnOf(double force_n) const;
  const fuzzy::Variable& words() const { return words_; }
  /// The judgements of a cell, in their order.
  std::vector<const session::JudgedForce*> at(const QModelIndex& index) const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  fuzzy::Variable words_;
  std::vector<session::JudgedForce> judgements_;  ///< of the series
  std::vector<std::string> rows_;
  std::vector<double> columns_;                               ///< ascending
  std::vector<std::vector<std::vector<std::size_t>>> cells_;  ///< by row and column: indices of `judgements_`
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
