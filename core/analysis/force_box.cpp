#include "core/analysis/force_box.h"

#include "core/analysis/sample_points.h"

namespace tactus::analysis {

std::vector<std::vector<double>> boxPoints(const fuzzy::ForceModel& model, std::size_t count) {
  std::vector<std::vector<double>> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < model.inputs.size(); ++k) {
      const auto& input = model.inputs[k];
      points[i].push_back(input.min + halton(i + 1, k) * (input.max - input.min));
    }
  }
  return points;
}

std::vector<std::vector<double>> linePoints(const fuzzy::ForceModel& model, const std::vector<double>& at,
                                            std::size_t input, std::size_t count) {
  const auto& variable = model.inputs[input];
  std::vector<std::vector<double>> points(count, at);
  for (std::size_t i = 0; i < count; ++i) {
    const double share = count > 1 ? static_cast<double>(i) / static_cast<double>(count - 1) : 0;
    points[i][input] = i + 1 == count ? variable.max : variable.min + share * (variable.max - variable.min);
  }
  return points;
}

}  // namespace tactus::analysis
