// The force lab without widgets: votes, words and checks of the open study, computed again when the study or a setting
// changes, and corrections of judgements.
#pragma once

#include <QObject>
#include <memory>
#include <optional>
#include <vector>

#include "app/workbench/labs/data/corrections.h"
#include "app/workbench/labs/data/lab_data.h"
#include "app/workbench/labs/data/lab_model.h"
#include "app/workbench/labs/data/lab_work.h"
#include "app/workbench/labs/force/check_table.h"
#include "app/workbench/labs/force/force_data.h"

namespace tactus::workbench {

/// Thread: gui.
class ForceLab : public QObject {
  Q_OBJECT

 public:
  /// All outlive this.
  ForceLab(LabData& data, LabModel& model, Corrections& corrections, QObject* parent = nullptr);

  const ForceVotes& votes() const { return found_.votes; }
  const std::vector<ParticipantChecks>& checks() const { return found_.checks; }
  /// Every judgement behind them.
  const std::vector<session::JudgedForce>& judgements() const;
  /// The series that can vote.
  const std::vector<std::string>& series() const { return found_.series; }
  const elicitation::BuildSettings& settings() const { return data_.settings(); }
  LabWork& work() { return work_; }
  const LabData& data() const { return data_; }

  /// Computes while wanted.
  void setWanted(bool wanted);

  void setMethod(elicitation::ForceTermsFrom from);
  /// The series that votes.
  void setSeries(const std::string& series);
  /// Asks how far the averaged force moves without `judged`; `influenceChanged` tells the answer, and again when the
  /// model has changed.
  void askInfluence(const session::JudgedForce& judged);
  /// The answer, one sentence; empty while there is none.
  const QString& influence() const { return influence_; }
  /// Stores another word for a judgement.
  void correct(const session::JudgedForce& judged, const session::JudgedWord& word);

 signals:
  /// What was computed, or a setting, is another one.
  void changed();
  void influenceChanged();

 private:
  struct Found {
    std::shared_ptr<const LabStudy> study;
    ForceVotes votes;
    std::vector<ParticipantChecks> checks;
    std::vector<std::string> series;
  };

  void compareAsked();
  void setInfluence(const QString& sentence);

  LabData& data_;
  LabModel& model_;
  Corrections& corrections_;
  Found found_;
  std::optional<session::JudgedForce> asked_;
  QString influence_;
  Background influence_work_;
  LabWork work_;  ///< last: its end waits for the work, which answers to all above
};

}  // namespace tactus::workbench
