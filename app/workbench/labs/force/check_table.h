// The checks of each participant's judgements as an item model (experiments/judgement_checks.h): falling words, rising
// against falling forces, repeats, blanks, limits between words, and times.
#pragma once

#include <string>
#include <vector>

#include "app/session/judged_forces.h"
#include "app/workbench/labs/frame/lab_table_model.h"
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

}  // namespace tactus::workbench
