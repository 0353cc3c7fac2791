// What one force of a model costs: measured once for each shape of a model, because an edit of a number hardly changes
// it.
#pragma once

#include <cstddef>
#include <vector>

#include "app/workbench/model/open_model.h"

namespace tactus::workbench {

class ForceCost {
 public:
  /// The cost of one force of `open`, s (haptics::measuredCostS). Measured if the shape differs from the last time.
  double of(const OpenModel& open);
  /// How often it was measured.
  int measurements() const { return measurements_; }

 private:
  /// What decides how long an evaluation takes: the numbers of experts, rules and terms with their shapes; and the
  /// terms of the output, because a force is computed faster where they have an order.
  struct Shape {
    std::vector<std::size_t> numbers;
    std::vector<double> output_points;

    bool operator==(const Shape&) const = default;
  };
  static Shape shapeOf(const fuzzy::ForceModel& model);

  Shape shape_;
  double cost_s_ = 0;
  int measurements_ = 0;
};

}  // namespace tactus::workbench
