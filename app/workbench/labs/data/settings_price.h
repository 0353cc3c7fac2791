// What a change of the settings does: to the averaged force in a sentence (at most so many newtons, felt at such a
// share of the input space), and the terms of before.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/workbench/base/computed.h"
#include "app/workbench/labs/data/lab_data.h"
#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

/// Thread: gui. Both models are built on a thread of their own.
class SettingsPrice : public QObject {
  Q_OBJECT

 public:
  /// Changes that follow each other within this time, as those of a slider, are one.
  static constexpr int kTogetherMs = 1500;

  /// `data` outlives this.
  explicit SettingsPrice(LabData& data, QObject* parent = nullptr);

  /// Nothing is computed while no lab is seen.
  void setSeen(bool seen);
  /// Of the last change; while it is computed, it says so; empty: the settings were not changed.
  QString sentence() const;
  /// The terms of a variable of the model before the last change; empty: unknown yet, or the settings were not changed.
  std::vector<fuzzy::Term> formerTerms(const std::string& variable) const;
  Computation& work() { return work_; }

 signals:
  void changed();

 private:
  struct Inputs {
    LabInputs from;
    std::shared_ptr<const elicitation::BuildSettings> before;
  };
  struct Price {
    std::shared_ptr<const elicitation::BuiltModel> former;
    QString sentence{};  ///< empty: the models are not compared yet
  };
  using Work = Computed<Inputs, Price>;
  /// The last former model: it stays while a slider moves. It keeps no study alive.
  struct Kept {
    std::weak_ptr<const LabStudy> study;
    std::shared_ptr<const elicitation::BuildSettings> settings;
    std::shared_ptr<const elicitation::BuiltModel> built;
  };

  static Work::Answer compare(const Inputs& from, const RunOf<Price>& run, Kept& kept);
  /// There is a change, and it has not been taken back.
  QString change() const;

  void setBefore(const elicitation::BuildSettings& before);
  void forget();

  LabData& data_;
  std::shared_ptr<const elicitation::BuildSettings> before_;
  QElapsedTimer since_change_;
  bool seen_ = false;
  Work work_;
};

}  // namespace tactus::workbench
