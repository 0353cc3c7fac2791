// The rules lab without widgets: the grids of all experts, what their differences cost in newtons, how far they agree,
// and corrections of answers and given rules.
#pragma once

#include <QObject>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/workbench/labs/data/corrections.h"
#include "app/workbench/labs/data/lab_data.h"
#include "app/workbench/labs/rules/agreement_rows.h"
#include "app/workbench/labs/rules/expert_grids.h"
#include "elicitation/agreement/conflict_map.h"
#include "elicitation/model/record_influence.h"

namespace tactus::workbench {

/// Thread: gui.
class RulesLab : public QObject {
  Q_OBJECT

 public:
  /// Both outlive this.
  RulesLab(LabModel& model, Corrections& corrections, QObject* parent = nullptr);

  /// The model behind the grids; needs grids.
  const fuzzy::ForceModel& model() const { return model_.value()->model->model; }
  const ExpertGrids& grids() const { return found_.grids; }
  /// Null until it is computed.
  const elicitation::ConflictMap* conflicts() const { return found_.conflicts ? &*found_.conflicts : nullptr; }
  /// What the experts' words cost in a cell; null if no expert has a rule there, or it is not computed.
  const elicitation::CellConflict* conflictAt(const GridPlace& place) const;
  /// About the rules of each expert and of all; null until they are computed.
  const std::vector<WordedFinding>* findings() const { return found_.findings ? &*found_.findings : nullptr; }
  const std::vector<AgreementRow>& agreement() const { return found_.agreement; }
  const std::vector<UsabilityRow>& usability() const { return found_.usability; }
  /// Why there are no grids; empty if there are.
  const QString& failure() const { return model_.failure(); }
  Computation& work() { return work_; }

  /// Computes while wanted.
  void setWanted(bool wanted);

  /// How far the averaged force moves without the expert's rule in the chosen cell; nothing while it is not known.
  std::optional<elicitation::RecordInfluence> influenceOf(std::size_t expert) const;
  /// Some are still being computed.
  bool isComparing() const { return influences_.isBusy(); }

  /// The chosen cell.
  const std::optional<GridPlace>& chosen() const { return chosen_; }
  void choose(const GridPlace& place);
  /// Chooses the cell of a rule of the model; at once, or as soon as there are grids.
  void chooseRule(std::size_t expert, std::size_t rule);
  /// Chooses the cell that a finding is about. Returns whether it is about one.
  bool chooseFinding(std::size_t finding);
  /// `Poor lubrication, Esophagus`.
  QString textOf(const GridPlace& place) const;

  /// Stores another word (an index among the force's words) for what `expert` said in a cell, which has a record.
  void correctWord(std::size_t expert, const GridPlace& place, std::size_t word);
  /// Stores that the expert skipped the item or could not tell; not for a given rule.
  void correctStatus(std::size_t expert, const GridPlace& place, study::Answer::Status status);

 signals:
  /// What was computed is another.
  void changed();
  void chosenChanged();
  void influencesChanged();

 private:
  struct Found {
    std::shared_ptr<const LabStudy> study;
    ExpertGrids grids;
    std::optional<elicitation::ConflictMap> conflicts;
    std::optional<std::vector<WordedFinding>> findings;
    std::vector<const elicitation::CellConflict*> by_cell;  ///< into `conflicts`, row after row
    std::vector<AgreementRow> agreement;
    std::vector<UsabilityRow> usability;
  };
  /// What the experts' rules in the chosen cell are compared with.
  struct Asked {
    std::shared_ptr<const elicitation::BuiltModel> built;
    std::vector<std::optional<std::size_t>> rules;  ///< by expert
  };
  using Influences = std::vector<std::optional<elicitation::RecordInfluence>>;
  using FoundCell = Computed<BuiltStudy, Found>;
  static FoundCell::Answer compute(const BuiltStudy& from, const RunOf<Found>& run);
  std::optional<Asked> asked() const;
  void onResult();
  void chooseWorst();
  bool chooseWanted();
  void correct(std::size_t expert, const GridPlace& place, study::Answer::Status status, const std::string& term,
               const QString& said);

  LabModel& model_;
  Corrections& corrections_;
  Found found_;
  std::optional<GridPlace> chosen_;
  std::optional<std::pair<std::size_t, std::size_t>> wanted_;  ///< expert and rule to choose as soon as they are there
  FoundCell work_;
  Computed<Asked, Influences> influences_;  ///< by expert, of the chosen cell
};

}  // namespace tactus::workbench
