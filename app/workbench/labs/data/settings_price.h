// What a change of the settings does to the averaged force, in a sentence: at most so many newtons, felt at such a
// share of the input space.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <optional>

#include "app/workbench/base/computed.h"
#include "app/workbench/labs/data/lab_data.h"

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
  Computation& work() { return work_; }

 signals:
  void changed();

 private:
  struct Inputs {
    LabInputs from;
    elicitation::BuildSettings before;
  };

  void take(const elicitation::BuildSettings& before);
  void forget();

  LabData& data_;
  std::optional<elicitation::BuildSettings> before_;
  QElapsedTimer since_change_;
  bool seen_ = false;
  Computed<Inputs, QString> work_;
};

}  // namespace tactus::workbench
