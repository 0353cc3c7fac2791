// Force over two inputs while the other inputs stay fixed: the numbers behind the color map and the surface, and the
// request to compute them, which any thread can serve.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/figures/force_curves.h"
#include "app/workbench/model/open_model.h"
#include "core/fuzzy/scene.h"

namespace tactus::workbench {

/// Forces on a grid over the parts of two inputs that are shown, including the ends.
struct ForceMap {
  std::size_t x_input = 0;
  std::size_t y_input = 0;
  figures::Interval x_part;  ///< of the universe
  figures::Interval y_part;
  std::size_t side = 0;             ///< points along each input
  std::vector<double> force_n;      ///< side * side values, row by row from the lowest y
  std::vector<std::uint8_t> fired;  ///< 1 if a rule fires

  double force(std::size_t x, std::size_t y) const { return force_n[y * side + x]; }
  bool isFired(std::size_t x, std::size_t y) const { return fired[y * side + x] != 0; }
};

/// What a map is computed of. Immutable; it shares the model.
class MapRequest {
 public:
  struct Axis {
    std::size_t input = 0;
    figures::Interval part;  ///< of its universe
  };

  /// `point`: one value per input; those of the axes do not matter. `expert`: nothing for the mean.
  MapRequest(std::shared_ptr<const OpenModel> model, std::vector<double> point, const Axis& x, const Axis& y,
             std::optional<std::size_t> expert);

  /// A map of `side` places along each input, at least 2, without forces.
  ForceMap begin(std::size_t side) const;
  /// Computes rows of `map` while `goes_on` says so, which is asked before each row. Returns the number of rows that
  /// are computed.
  /// Thread: any.
  std::size_t compute(ForceMap& map, const std::function<bool()>& goes_on) const;
  /// How many forces stand behind one place: that of the expert, or the mean and those of all experts.
  std::size_t forcesOfAPlace() const;

 private:
  std::shared_ptr<const OpenModel> model_;
  std::vector<double> point_;
  Axis x_;
  Axis y_;
  std::optional<std::size_t> expert_;
  std::optional<fuzzy::Scene> scene_;  ///< of the mean
};

}  // namespace tactus::workbench
