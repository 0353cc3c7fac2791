// Points of the input space at which the analysis looks: vertices of the terms, the middles between them, and their
// combinations.
#pragma once

#include <span>
#include <vector>

#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

/// The vertices of all experts' terms of each input that lie inside its universe, ascending, each once.
std::vector<std::vector<double>> sortedVertices(const fuzzy::ForceModel& model);

/// The `vertices` inside (low, high), both ends, and the middles between neighbours; of a great many vertices an even
/// selection.
std::vector<double> valuesWorthALook(std::span<const double> vertices, double low, double high);

/// Every combination of the values given for each input, or, where these are more than `most`, `most` points of a
/// Halton sequence over them. Deterministic.
class SamplePoints {
 public:
  SamplePoints(std::vector<std::vector<double>> values, std::size_t most);

  std::size_t size() const noexcept { return size_; }
  /// Point number `index`, one value per input.
  std::vector<double> operator[](std::size_t index) const;

 private:
  std::vector<std::vector<double>> values_;
  std::size_t size_ = 1;
  bool all_ = true;
};

}  // namespace tactus::analysis
