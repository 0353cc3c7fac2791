// What the averaged model is made of, and how many newtons hang on each part: depth, speed and force words, rules,
// weights.
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/workbench/base/computed.h"
#include "app/workbench/labs/data/lab_data.h"
#include "elicitation/model/method_study.h"

class QWidget;

namespace tactus::workbench {

/// One part on the way from the data to the force.
struct BuildPart {
  enum class Kind { kDepth, kSpeed, kForce, kRules, kExperts };

  Kind kind = Kind::kDepth;
  QString sentence;               ///< what it is made of
  std::optional<double> stake_n;  ///< the largest effect found, N; nothing: not computed yet, or it cannot be
  QString effect;                 ///< what has that effect
  QStringList warnings;           ///< notes of the build about it
};

/// The parts of `built`, those with the largest stake first; without `choices` in the order of the way. `choices`: the
/// method study of the same model; null: not computed yet.
std::vector<BuildPart> buildParts(const BuiltStudy& built, const elicitation::MethodStudy* choices);

/// Where the cards of the overview lead.
struct OverviewLeads {
  std::function<void(BuildPart::Kind)> lab;  ///< the lab of this part
  // What brings the answers that are missing.
  std::function<void()> sessions, tables, fill;
};

class BuildOverview;

/// The first tab of stage Build: a card for each part of the model, the one with the most newtons first; or what is
/// missing. `overview` outlives it.
QWidget* makeOverview(BuildOverview& overview, OverviewLeads leads);

/// Thread: gui. The choices are compared on a thread of their own.
class BuildOverview : public QObject {
  Q_OBJECT

 public:
  /// `model` outlives this.
  explicit BuildOverview(LabModel& model, QObject* parent = nullptr);

  /// Nothing is computed while it is hidden.
  void setSeen(bool seen);
  /// Empty: there is no model, or not yet.
  std::vector<BuildPart> parts() const;
  /// One sentence: why there is no model; empty: there is one, or it is being built.
  QString failure() const { return model_.failure(); }
  Computation& work() { return choices_; }
  /// What was compared last, the choices of the cards alone; nothing before the first time.
  std::optional<StudiedMethod> studied() const;

 signals:
  void changed();

 private:
  LabModel& model_;
  Computed<BuiltStudy, elicitation::MethodStudy> choices_;
};

}  // namespace tactus::workbench
