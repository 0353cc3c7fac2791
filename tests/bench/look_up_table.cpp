// A table of forces computed beforehand: the quick answer that many simulators give.
#include <algorithm>

#include "core/base/check.h"

#include "tests/bench/contenders.h"

namespace tactus::bench {
namespace {

/// One axis of the table.
struct Axis {
  std::size_t input;
  double min;
  double per_unit;  ///< steps per unit of the input
};

class Table {
 public:
  Table(const Case& about, int size) : size_(static_cast<std::size_t>(size)), forces_n_(size_ * size_) {
    for (std::size_t i = 0; i < about.fixed.size(); ++i) {
      if (about.fixed[i]) continue;
      const fuzzy::Variable& input = about.model.inputs[i];
      axes_.push_back({i, input.min, (size - 1) / (input.max - input.min)});
    }
    TACTUS_CHECK(axes_.size() == 2);
    std::vector<double> point;
    for (const auto& value : about.fixed) point.push_back(value.value_or(0));
    for (std::size_t u = 0; u < size_; ++u) {
      for (std::size_t v = 0; v < size_; ++v) {
        point[axes_[0].input] = axes_[0].min + static_cast<double>(u) / axes_[0].per_unit;
        point[axes_[1].input] = axes_[1].min + static_cast<double>(v) / axes_[1].per_unit;
        forces_n_[u * size_ + v] = about.compiled.evaluate(point).force_n;
      }
    }
  }

  double force(std::span<const double> point) const {
    const Place u = placeOn(axes_[0], point);
    const Place v = placeOn(axes_[1], point);
    const double* const corner = forces_n_.data() + u.index * size_ + v.index;
    const double near = corner[0] + (corner[1] - corner[0]) * v.share;
    const double far = corner[size_] + (corner[size_ + 1] - corner[size_]) * v.share;
    return near + (far - near) * u.share;
  }

 private:
  struct Place {
    std::size_t index;
    double share;
  };

  Place placeOn(const Axis& axis, std::span<const double> point) const {
    const double steps =
        std::clamp((point[axis.input] - axis.min) * axis.per_unit, 0.0, static_cast<double>(size_ - 1));
    const std::size_t index = std::min(static_cast<std::size_t>(steps), size_ - 2);
    return {index, steps - static_cast<double>(index)};
  }

  std::size_t size_;
  std::vector<Axis> axes_;
  std::vector<double> forces_n_;
};

}  // namespace

Contender lookUpTable(const Case& about, int size) {
  auto run = [&about, table = Table(about, size)](std::size_t first, std::span<double> out) {
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = table.force(about.points.row(first + i));
  };
  const std::string text = std::to_string(size);
  return {"look-up table", size, &about, {about.name + ": table, " + text + " x " + text, about.points.count(), run}};
}

}  // namespace tactus::bench
