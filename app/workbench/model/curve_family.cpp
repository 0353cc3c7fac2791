#include "app/workbench/model/curve_family.h"

#include <algorithm>

#include "app/figures/force_curves.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/model/open_model.h"
#include "core/base/check.h"

namespace tactus::workbench {

std::optional<CurveFamily> familyOf(const fuzzy::ForceModel& model, const QString& figure, const std::string& varied,
                                    std::span<const double> values) {
  const auto input = inputNamed(model, varied);
  if (!input) return std::nullopt;
  CurveFamily family{figure, *input, {}};
  for (const double value : values) {
    family.values.push_back(std::clamp(value, model.inputs[*input].min, model.inputs[*input].max));
  }
  family.values.erase(std::unique(family.values.begin(), family.values.end()), family.values.end());
  return family;
}

FamilyCurves computeFamily(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled, std::size_t x_input,
                           std::span<const double> values, const CurveFamily& family) {
  TACTUS_CHECK(values.size() == compiled.inputCount() && x_input < values.size() && family.input < values.size() &&
               family.input != x_input);
  FamilyCurves out{figures::samplePositions(model, x_input), {}};
  std::vector<double> point(values.begin(), values.end());
  for (const double value : family.values) {
    point[family.input] = value;
    std::vector<fuzzy::Evaluation>& curve = out.curves.emplace_back();
    curve.reserve(out.x.size());
    for (const double x : out.x) {
      point[x_input] = x;
      curve.push_back(compiled.evaluate(point));
    }
  }
  return out;
}

QString familyLineText(const fuzzy::ForceModel& model, const CurveFamily& family, std::size_t index) {
  const fuzzy::Variable& input = model.inputs[family.input];
  return shortLabelOf(input) + QLatin1Char(' ') + quantityText(family.values[index], input.unit);
}

}  // namespace tactus::workbench
