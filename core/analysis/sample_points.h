// The sample points of the analysis: vertices of the terms, midpoints between them, and their combinations.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

/// For each input: the vertices of all experts' terms inside its universe, ascending, without duplicates.
std::vector<std::vector<double>> sortedVertices(const fuzzy::ForceModel& model);

/// The `vertices` inside (low, high), both ends, and the midpoints between neighbors. If there are very many vertices,
/// an even selection of them.
std::vector<double> valuesWorthALook(std::span<const double> vertices, double low, double high);

/// The points that an analysis may evaluate if each looks at `rules` rules: 100 to 20,000, well below half a second in
/// all.
std::size_t affordablePoints(std::size_t rules);

/// Coordinate `dimension` (below kMostInputs) of point number `index` (from 1) of the Halton sequence (1960), in [0,
/// 1).
double halton(std::size_t index, std::size_t dimension);

/// All combinations of the given values of each input. If there are more than `most`: `most` points of a Halton
/// sequence over them. Deterministic.
class SamplePoints {
 public:
  /// The index of one value for each input.
  using Choice = std::vector<std::size_t>;

  SamplePoints(std::vector<std::vector<double>> values, std::size_t most);

  std::size_t size() const noexcept { return size_; }
  /// Whether these are all combinations.
  bool all() const noexcept { return all_; }
  Choice choice(std::size_t index) const;
  std::vector<double> at(const Choice& choice) const;
  /// Point number `index`, one value per input.
  std::vector<double> operator[](std::size_t index) const { return at(choice(index)); }

  /// Improves a good point: for one input after the other it chooses the best value, until nothing improves or `size()`
  /// points have been evaluated. `value`: the value of `start`. `look(choice)`: returns the value of a choice, or
  /// nothing.
  void climb(Choice start, double value, const std::function<std::optional<double>(const Choice&)>& look) const;

 private:
  std::vector<std::vector<double>> values_;
  std::size_t size_ = 1;
  bool all_ = true;
};

/// The combinations of all vertices and midpoints of the inputs; `most` as above.
SamplePoints kinkPoints(const fuzzy::ForceModel& model, std::size_t most);

/// Points spread evenly over the universes of the inputs, in 256 cells per input; `most` as above.
SamplePoints evenPoints(const fuzzy::ForceModel& model, std::size_t most);

}  // namespace tactus::analysis
