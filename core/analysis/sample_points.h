// Points of the input space at which the analysis looks: vertices of the terms, the middles between them, and their
// combinations.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/fuzzy/force_model.h"

namespace tactus::analysis {

/// The vertices of all experts' terms of each input that lie inside its universe, ascending, each once.
std::vector<std::vector<double>> sortedVertices(const fuzzy::ForceModel& model);

/// The `vertices` inside (low, high), both ends, and the middles between neighbours; of a great many vertices an even
/// selection.
std::vector<double> valuesWorthALook(std::span<const double> vertices, double low, double high);

/// Coordinate number `dimension` (below kMostInputs) of point number `index` (from 1) of the Halton sequence (1960), in
/// [0, 1).
double halton(std::size_t index, std::size_t dimension);

/// Every combination of the values given for each input, or, where these are more than `most`, `most` points of a
/// Halton sequence over them. Deterministic.
class SamplePoints {
 public:
  /// One of its values for each input.
  using Choice = std::vector<std::size_t>;

  SamplePoints(std::vector<std::vector<double>> values, std::size_t most);

  std::size_t size() const noexcept { return size_; }
  /// Whether these are all combinations.
  bool all() const noexcept { return all_; }
  Choice choice(std::size_t index) const;
  std::vector<double> at(const Choice& choice) const;
  /// Point number `index`, one value per input.
  std::vector<double> operator[](std::size_t index) const { return at(choice(index)); }

  /// Looks beside a good point, taking for one input after the other the value with which it gets best, until nothing
  /// gets better or `size()` points have been looked at. `value` is that of `start`; `look(choice)` gives that of a
  /// choice, or nothing.
  void climb(Choice start, double value, const std::function<std::optional<double>(const Choice&)>& look) const;

 private:
  std::vector<std::vector<double>> values_;
  std::size_t size_ = 1;
  bool all_ = true;
};

/// The combinations of all values worth a look over the universes of the inputs; `most` as above.
SamplePoints kinkPoints(const fuzzy::ForceModel& model, std::size_t most);

/// Points spread evenly over the universes of the inputs, each input in 256 cells; `most` as above.
SamplePoints evenPoints(const fuzzy::ForceModel& model, std::size_t most);

}  // namespace tactus::analysis
