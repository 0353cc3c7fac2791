// The checks of each participant's judgements as an item model (experiments/judgement_checks.h): falling words, rising
// against falling forces, repeats, blanks, limits between words, and times.
#pragma once

#include <QAbstractTableModel>
#include <string>
#include <vector>

#include "app/session/judged_forces.h"
#include "core/fuzzy/force_model.h"
#include "experiments/judgement_checks.h"

namespace tactus::workbench {

struct ParticipantChecks {
  std::string participant;
  experiments::JudgementChecks checks;
};

/// The checks of every participant in `all`, in its order. `words`: the force with its words. Thread: any.
std::vector<ParticipantChecks> judgementChecks(const fuzzy::Variable& words,
                                               const std::vector<session::JudgedForce>& all);

class CheckTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { kWho, kReversals, kHysteresis, kRepeats, kBlanks, kThresholds, kAnswerTime, kMotion, kColumns };
  static constexpr int kNotableRole = Qt::UserRole;  ///< bool: deserves attention

  using QAbstractTableModel::QAbstractTableModel;

  void setChecks(std::vector<ParticipantChecks> checks);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override { return parent.isValid() ? 0 : kColumns; }
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  std::vector<ParticipantChecks> rows_;
};

}  // namespace tactus::workbench
