// The setting in which the open model is looked at: a value for each input, the input on the x axis, the place that is
// read, and whose terms are shown. Curves are computed when asked for, and only after something they depend on changed.
#pragma once

#include <QObject>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/workbench/model/curve_family.h"
#include "app/workbench/model/figure_presets.h"
#include "app/workbench/model/force_curves.h"
#include "app/workbench/model/model_controller.h"
#include "core/analysis/explain.h"

namespace tactus::workbench {

/// The forces at the place that is read.
struct Reading {
  double x = 0;  ///< value of the input on the x axis, in its unit
  fuzzy::Evaluation mean;
  std::vector<fuzzy::Evaluation> experts;
};

class SceneController : public QObject {
  Q_OBJECT

 public:
  explicit SceneController(const ModelController& models, QObject* parent = nullptr);

  /// The model that is looked at, or null. Everything below may be called with a model only.
  const OpenModel* model() const { return model_.get(); }
  /// The same, to keep.
  std::shared_ptr<const OpenModel> shared() const { return model_; }
  /// Whether that is another one in the place of the open model, while versions are compared.
  bool showsAnother() const { return models_.shown() != models_.current(); }

  std::size_t xInput() const { return x_input_; }
  const fuzzy::Variable& xVariable() const { return model_->model.inputs[x_input_]; }
  double value(std::size_t input) const { return values_[input]; }
  /// One value per input.
  const std::vector<double>& values() const { return values_; }

  /// The expert whose own terms are shown; nothing: the shared terms.
  std::optional<std::size_t> termsOf() const { return terms_of_; }
  /// The terms of a variable of the model as they are shown.
  const std::vector<fuzzy::Term>& terms(const fuzzy::Variable& variable) const;

  /// The curves along the x axis in the present setting.
  const ForceCurves& curves() const;

  /// Curves of the mean at several values of another input, shown in the place of those of the experts.
  const std::optional<CurveFamily>& family() const { return family_; }
  /// Its curves along the x axis in the present setting. There must be a family.
  const FamilyCurves& familyCurves() const;

  /// The forces at the place under the mouse, or at the value of the input on the x axis.
  const Reading& reading() const;
  /// How the force comes about there.
  const analysis::Explanation& explanation() const;
  /// The place itself: one value per input.
  std::vector<double> readingPoint() const;
  double readingX() const { return hover_.value_or(values_[x_input_]); }

  /// How many forces have been computed for this scene: one for each expert and one for the mean at each place. What
  /// nobody sees adds nothing.
  std::uint64_t evaluations() const { return evaluations_; }
  /// Adds forces that others compute for this scene.
  void countEvaluations(std::uint64_t forces) const { evaluations_ += forces; }

 public slots:
  void setXInput(std::size_t input);
  /// Sets input `input` to `value`, clamped to its universe. What is no number changes nothing.
  void setValue(std::size_t input, double value);
  /// Sets the inputs as in a figure of the paper, with the depth on the x axis where the model has one, and its family
  /// of curves.
  void applyPreset(const tactus::workbench::FigurePreset& preset);
  /// The curves of the experts again.
  void clearFamily();
  /// Reads at `x` on the x axis until `clearHover`.
  void setHover(double x);
  void clearHover();
  void setTermsOf(std::optional<std::size_t> expert);

 signals:
  /// Another model: other variables or experts.
  void modelChanged();
  /// The same variables and experts with other terms or rules; followed by `termsChanged`, `curvesChanged` and
  /// `readingChanged`.
  void modelEdited();
  void xInputChanged();
  void valueChanged(std::size_t input);
  void curvesChanged();
  /// Another family, or none any more; its lines are others. `curvesChanged` tells of new curves of the same family.
  void familyChanged();
  void presetApplied(const tactus::workbench::FigurePreset& preset);
  void readingChanged();
  void termsChanged();

 private:
  void adoptModel();
  void adoptEdit();
  void adoptFamily(const std::string& varied);
  bool storeValue(std::size_t input, double value);
  void setFamily(std::optional<CurveFamily> family);
  void dropCurves();
  void dropReading();
  void announceCurves();

  const ModelController& models_;
  std::shared_ptr<const OpenModel> model_;
  std::size_t x_input_ = 0;
  std::vector<double> values_;
  std::optional<double> hover_;
  std::optional<std::size_t> terms_of_;
  std::optional<CurveFamily> family_;
  // Computed when asked for.
  mutable std::optional<ForceCurves> curves_;
  mutable std::optional<FamilyCurves> family_curves_;
  mutable std::optional<Reading> reading_;
  mutable std::optional<analysis::Explanation> explanation_;
  mutable std::uint64_t evaluations_ = 0;
};

}  // namespace tactus::workbench
