// The force of the mean along one input at several values of another: a family of curves, as in Fig. 10 of the paper.
#pragma once

#include <QString>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/fuzzy/compiled_model.h"
#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

struct CurveFamily {
  QString figure;              ///< `Fig. 10a`
  std::size_t input = 0;       ///< the input whose value differs from curve to curve
  std::vector<double> values;  ///< values of that input, in its unit, inside its universe

  friend bool operator==(const CurveFamily&, const CurveFamily&) = default;
};

/// The family of `figure` in which the input with the id `varied` has these values in turn; nothing if `model` has no
/// such input.
std::optional<CurveFamily> familyOf(const fuzzy::ForceModel& model, const QString& figure, const std::string& varied,
                                    std::span<const double> values);

struct FamilyCurves {
  std::vector<double> x;                               ///< ascending, in the unit of the input on the x axis
  std::vector<std::vector<fuzzy::Evaluation>> curves;  ///< one curve per value of the family
};

/// The curves along `x_input`, which must not be the family's input. `values` has one value per input; the values of
/// `x_input` and of the family's input are not used.
FamilyCurves computeFamily(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled, std::size_t x_input,
                           std::span<const double> values, const CurveFamily& family);

/// The legend text of curve `index`: `Lubrication 0.25`, `Neck flexion 30 deg`.
QString familyLineText(const fuzzy::ForceModel& model, const CurveFamily& family, std::size_t index);

}  // namespace tactus::workbench
