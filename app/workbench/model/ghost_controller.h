// What the curves are compared with: the model before the last edit, or another one that somebody chose.
#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <optional>
#include <vector>

#include "app/editing/edit_history.h"
#include "app/editing/model_ghost.h"
#include "app/workbench/model/force_curves.h"
#include "app/workbench/model/open_model.h"

namespace tactus::workbench {

class EditController;
class SceneController;

/// The curves before, in the present setting, and how far the mean is from them now.
struct GhostCurves {
  std::vector<double> x;                ///< ascending, in the unit of the input on the x axis
  std::vector<fuzzy::Evaluation> mean;  ///< one per place
  std::vector<std::vector<fuzzy::Evaluation>>
      experts;  ///< per expert of the open model; empty for one not there before
  /// How far the means are apart; its `points` are left out.
  editing::GhostCurve difference;
};

/// Thread: gui.
class GhostController : public QObject {
  Q_OBJECT

 public:
  GhostController(EditController& edits, const SceneController& scene, QObject* parent = nullptr);

  /// The model that stands for "before": the reference where one was set; in a gesture the model at its beginning;
  /// otherwise the one that the present state was made from. Null where there is none, or while this is off.
  std::shared_ptr<const OpenModel> before() const { return on_ ? shown() : nullptr; }
  /// What `before` is: `Before the last edit`, or the name of the reference.
  QString label() const;
  /// What was changed since, in words; empty for a reference.
  QString whatChanged() const;
  bool isOn() const { return on_; }
  bool hasReference() const { return reference_ != nullptr; }

  /// Compares with `model`, called `label`, until `clearReference` or until another model is opened. Refused: other
  /// inputs or another output than the open model has.
  base::Result<void> setReference(std::shared_ptr<const OpenModel> model, const QString& label);
  void clearReference();

  /// The curves of `before`, computed when asked for and only after something they depend on changed; null where there
  /// is none. A model must be open.
  const GhostCurves* curves() const;
  /// What the last edit did, as the history says it, and where along the present curves it is largest: `max ΔF at least
  /// 0.032 N (0.4 JND) · on this curve 0.021 N (0.3 JND) at 215 mm`. Against a reference, and while a gesture goes on,
  /// that of the curve alone: `max ΔF on this curve …`. Just-noticeable differences only where the unit of the force is
  /// newtons; where the largest of them is at another place, both places.
  QString differenceText() const;

 public slots:
  void setOn(bool on);

 signals:
  /// Another model before, or none any more.
  void changed();

 private:
  std::shared_ptr<const OpenModel> shown() const { return reference_ ? reference_ : before_; }
  void follow();
  void reset();
  std::optional<editing::StateId> stateBefore() const;
  void compute() const;
  QString curveText() const;

  EditController& edits_;
  const SceneController& scene_;
  bool on_ = true;
  std::shared_ptr<const OpenModel> before_;
  std::optional<editing::StateId> state_;  ///< of before_
  std::shared_ptr<const OpenModel> reference_;
  QString reference_label_;

  // Computed when asked for, and what they were computed from.
  mutable std::optional<GhostCurves> curves_;
  mutable std::shared_ptr<const OpenModel> curves_before_;
  mutable std::shared_ptr<const OpenModel> curves_after_;
  mutable std::vector<double> curves_setting_;
  mutable std::size_t curves_input_ = 0;
};

}  // namespace tactus::workbench
