// How many nurses and questions a study takes, without widgets: simulated studies of each design, before the open study
// or for what it has so far (app/planning).
#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/planning/planned_study.h"
#include "app/workbench/base/columns.h"
#include "app/workbench/base/computed.h"
#include "app/workbench/labs/data/lab_data.h"

class QWidget;

namespace tactus::workbench {

/// What a plan is asked for.
struct PlanWish {
  std::string region;  ///< id of a term of the way; empty: all regions
  int most_nurses = 12;
  int studies = 200;

  bool operator==(const PlanWish&) const = default;
};

/// Thread: gui.
class PlanLab : public QObject {
  Q_OBJECT

 public:
  /// `model` outlives this.
  PlanLab(LabData& data, LabModel& model, QObject* parent = nullptr);

  const PlanWish& wish() const { return wish_; }
  void setWish(const PlanWish& wish);
  /// The error that is wanted, N.
  double precisionN() const { return precision_n_; }
  void setPrecisionN(double precision_n);

  /// Null: not simulated yet, or it cannot be. Its cheapest design is that for the wanted precision.
  const planning::PlannedStudy* plan() const { return plan_ ? &*plan_ : nullptr; }
  /// The regions that a plan can be about.
  const std::vector<fuzzy::Term>& regions() const { return data_.connection().procedure()->wayInput().terms; }
  Computation& work() { return simulated_; }
  const QString& failure() const { return simulated_.failure(); }
  const LabData& data() const { return data_; }
  /// Whether the lab is on the screen: nothing is simulated while it is not.
  void setWanted(bool wanted);

 signals:
  /// `plan`, `failure` or a wish changed.
  void changed();
  void regionsChanged();

 private:
  struct Order {
    session::ProcedurePtr about;
    std::optional<BuiltStudy> built;  ///< of the open study; nothing: it has no model
    elicitation::ForceTermsFrom force_terms;
    PlanWish wish;
  };
  using Simulated = Computed<Order, planning::PlannedStudy>;
  static Simulated::Answer simulate(const Order& order, const RunOf<planning::PlannedStudy>& run);
  std::optional<Order> order() const;
  void takePlan();

  LabData& data_;
  LabModel& model_;
  PlanWish wish_;
  double precision_n_ = 0.1;
  std::optional<planning::PlannedStudy> plan_;
  Simulated simulated_;
};

/// A design as the table shows it.
struct PlanRow {
  QString questions, nurses, error, interval, p95, hours;
  QString note;  ///< whether it is the cheapest, or the present one
};
std::vector<Column<PlanRow>> planColumns();
std::vector<PlanRow> planRows(const planning::PlannedStudy& planned);

/// The lab on the screen; `lab` outlives it.
QWidget* makePlanView(PlanLab& lab);

}  // namespace tactus::workbench
