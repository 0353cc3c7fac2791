// The model with which the curves are compared: the model before the last edit, or a reference that the user chose.
// "Ghost" names the faint curves of that model.
#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <optional>
#include <vector>

#include "app/editing/edit_history.h"
#include "app/editing/edit_impact.h"
#include "app/figures/force_curves.h"
#include "app/workbench/model/open_model.h"

namespace tactus::workbench {

class EditController;
class SceneController;

/// The curves of the ghost in the current setting, and the difference of the mean force to it.
struct GhostCurves {
  std::vector<double> x;                ///< ascending, in the unit of the input on the x axis
  std::vector<fuzzy::Evaluation> mean;  ///< one per place
  std::vector<std::vector<fuzzy::Evaluation>>
      experts;  ///< per expert of the open model; empty for an expert that the ghost lacks
  /// The difference of the two means; its `points` are left empty.
  editing::GhostCurve difference;
};

/// Thread: gui.
class GhostController : public QObject {
  Q_OBJECT

 public:
  GhostController(EditController& edits, const SceneController& scene, QObject* parent = nullptr);

  /// The model "before": the reference if one is set; during a gesture the model at its beginning; otherwise the parent
  /// of the current state. Null if there is none, or while the ghost is off.
  std::shared_ptr<const OpenModel> before() const { return on_ ? shown() : nullptr; }
  /// The name of `before`: `Before the last edit`, or the name of the reference.
  QString label() const;
  /// The change since `before`, in words; empty for a reference.
  QString whatChanged() const;
  bool isOn() const { return on_; }
  bool hasReference() const { return reference_ != nullptr; }

  /// Compares with `model`, named `label`, until `clearReference` or until another model is opened. Refused: a model
  /// whose inputs or output differ from those of the open model.
  base::Result<void> setReference(std::shared_ptr<const OpenModel> model, const QString& label);
  void clearReference();

  /// The curves of `before`; null if there is none. Computed at the first call after a change. A model must be open.
  const GhostCurves* curves() const;
  /// The effect of the last edit as in the history, and the largest difference along the current curves: `max ΔF
  /// anywhere at least 0.032 N (0.4 JND) · on this curve at least 0.021 N (0.3 JND) at 215 mm`. Against a reference,
  /// and during a gesture, the curve alone: `max ΔF on this curve …`. Just-noticeable differences appear only if the
  /// unit of the force is newtons. If the largest of them is at another place, the text names both places.
  QString differenceText() const;
  /// The number of `differenceText` where room is scarce: `ΔF ≥ 0.032 N anywhere`. A hole that the edit leaves comes
  /// before any number.
  QString briefText() const;
  /// Where the last edit acts, if it changed the force and the curve on the screen does not show it.
  struct Elsewhere {
    QString where;           ///< `Tube lubrication 0.4 to 0.6`
    std::vector<double> at;  ///< the place of the largest change, one value per input
  };
  std::optional<Elsewhere> elsewhere() const;

 public slots:
  void setOn(bool on);

 signals:
  /// Another ghost, or none any more.
  void changed();

 private:
  std::shared_ptr<const OpenModel> shown() const { return reference_ ? reference_ : before_; }
  void refreshState();
  void reset();
  std::optional<editing::StateId> stateBefore() const;
  void compute() const;
  QString curveText() const;
  std::optional<editing::EditImpact> impact() const;

  EditController& edits_;
  const SceneController& scene_;
  bool on_ = true;
  std::shared_ptr<const OpenModel> before_;
  std::optional<editing::StateId> state_;  ///< the state of before_
  std::shared_ptr<const OpenModel> reference_;
  QString reference_label_;

  // Computed on demand, with the inputs of the computation.
  mutable std::optional<GhostCurves> curves_;
  mutable std::shared_ptr<const OpenModel> curves_before_;
  mutable std::shared_ptr<const OpenModel> curves_after_;
  mutable std::vector<double> curves_setting_;
  mutable std::size_t curves_input_ = 0;
};

}  // namespace tactus::workbench
