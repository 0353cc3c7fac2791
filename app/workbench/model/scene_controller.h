// The setting in which the user looks at the open model: a value for each input, the input on the x axis, the reading
// place, and the choice of terms. Curves are computed on demand, only after a change.
// The reading place is the x position under the mouse, or else the operating point (the values of all inputs):
//   operating point: depth 150 mm, speed 50 mm/s. Mouse at 92 mm on the depth axis.
//   reading place: depth 92 mm, speed 50 mm/s
#pragma once

#include <QObject>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/figures/force_curves.h"
#include "app/workbench/model/curve_family.h"
#include "app/workbench/model/model_controller.h"
#include "app/workbench/model/shown_procedure.h"
#include "app/workbench/model/shown_ranges.h"
#include "core/analysis/explain.h"

namespace tactus::workbench {

/// The forces at the reading place.
struct Reading {
  double x = 0;  ///< value of the input on the x axis, in its unit
  fuzzy::Evaluation mean;
  std::vector<fuzzy::Evaluation> experts;
};

class SceneController : public QObject {
  Q_OBJECT

 public:
  explicit SceneController(const ModelController& models, QObject* parent = nullptr);

  /// The model on the screen; null if none is open. All other functions need a model.
  const OpenModel* model() const { return model_.get(); }
  /// The same, as shared ownership.
  std::shared_ptr<const OpenModel> shared() const { return model_; }
  /// Whether it is another model in place of the open one, while versions are compared.
  bool showsAnother() const { return models_.shown() != models_.current(); }

  /// What the model is about; null: not known.
  const ProcedurePtr& procedure() const { return procedure_; }
  /// The procedure of the open study, null without a study.
  void setStudyProcedure(ProcedurePtr procedure);

  std::size_t xInput() const { return x_input_; }
  const fuzzy::Variable& xVariable() const { return model_->model.inputs[x_input_]; }
  double value(std::size_t input) const { return values_[input]; }
  /// One value per input.
  const std::vector<double>& values() const { return values_; }

  /// The parts of the inputs' universes that the plots show.
  ShownRanges& ranges() { return ranges_; }
  const ShownRanges& ranges() const { return ranges_; }

  /// The expert whose own terms are shown; nothing: the shared terms.
  std::optional<std::size_t> termsOf() const { return terms_of_; }
  /// The terms of a variable of the model, as chosen with `termsOf`.
  const std::vector<fuzzy::Term>& terms(const fuzzy::Variable& variable) const;

  /// The curves along the x axis in the current setting.
  const figures::ForceCurves& curves() const;

  /// The family of curves of the mean at several values of another input; it replaces the curves of the experts.
  const std::optional<CurveFamily>& family() const { return family_; }
  /// The curves of the family in the current setting. Needs a family.
  const FamilyCurves& familyCurves() const;

  /// The forces at the reading place.
  const Reading& reading() const;
  /// How the model derives the force there.
  const analysis::Explanation& explanation() const;
  /// The reading place as one value per input.
  std::vector<double> readingPoint() const;
  double readingX() const { return hover_.value_or(values_[x_input_]); }

  /// The number of forces computed for this scene: per place one for each expert and one for the mean. Hidden views add
  /// none.
  std::uint64_t evaluations() const { return evaluations_; }
  /// Adds forces that other objects computed for this scene.
  void countEvaluations(std::uint64_t forces) const { evaluations_ += forces; }

 public slots:
  void setXInput(std::size_t input);
  /// Sets input `input` to `value`, clamped to its universe. Ignores NaN.
  void setValue(std::size_t input, double value);
  /// Moves the operating point to `point`, one value per input, and ends the hover.
  void goTo(const std::vector<double>& point);
  /// Sets the inputs as the figure does, puts the way on the x axis if the model has one, and shows the figure's family
  /// of curves.
  void applyFigure(const tactus::procedure::Figure& figure);
  /// Shows the curves of the experts again.
  void clearFamily();
  /// Moves the reading place to `x` on the x axis until `clearHover`.
  void setHover(double x);
  void clearHover();
  void setTermsOf(std::optional<std::size_t> expert);

 signals:
  /// Another model with other variables or experts.
  void modelChanged();
  /// The same model is about another procedure than was known.
  void procedureChanged();
  /// The same variables and experts with other terms or rules. `termsChanged`, `curvesChanged` and `readingChanged`
  /// follow.
  void modelEdited();
  void xInputChanged();
  void valueChanged(std::size_t input);
  void curvesChanged();
  /// Another family with other lines, or none any more. `curvesChanged` announces new curves of the same family.
  void familyChanged();
  void figureApplied(const tactus::procedure::Figure& figure);
  void readingChanged();
  void termsChanged();

 private:
  void adoptModel();
  void adoptProcedure();
  void adoptEdit();
  void adoptFamily(const std::string& varied);
  bool storeValue(std::size_t input, double value);
  void setFamily(std::optional<CurveFamily> family);
  void dropCurves();
  void dropReading();
  void announceCurves();

  const ModelController& models_;
  ShownRanges ranges_;
  std::shared_ptr<const OpenModel> model_;
  ProcedurePtr procedure_, study_procedure_;
  std::size_t x_input_ = 0;
  std::vector<double> values_;
  std::optional<double> hover_;
  std::optional<std::size_t> terms_of_;
  std::optional<CurveFamily> family_;
  // Computed on demand.
  mutable std::optional<figures::ForceCurves> curves_;
  mutable std::optional<FamilyCurves> family_curves_;
  mutable std::optional<Reading> reading_;
  mutable std::optional<analysis::Explanation> explanation_;
  mutable std::uint64_t evaluations_ = 0;
};

}  // namespace tactus::workbench
