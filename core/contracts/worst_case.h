// Searches the largest value of a function with kinks over a box: what a proof needs before it starts, and the stroke
// that tells two models apart. Deterministic.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace tactus::contracts {

class WorstCase {
 public:
  using Value = std::function<double(std::span<const double>)>;

  /// A side of the box, and places on it that are worth a look: both ends, and where the function bends.
  struct Side {
    double low = 0;
    double high = 0;
    std::vector<double> places;
  };

  /// `value`: of a place; minus infinity where it means nothing.
  WorstCase(std::vector<Side> sides, Value value);

  /// Looks at places spread over the box and at bends, and climbs from the best of them. `pairs`: the last side is of
  /// the same variable as this one, and pairs of places along it are compared.
  void search(std::optional<std::size_t> pairs, std::size_t lines = 320);
  /// Climbs from `place`.
  void climb(std::vector<double> place);

  /// The best so far; its value is minus infinity before the first look.
  const std::vector<double>& place() const noexcept { return best_; }
  double value() const noexcept { return best_value_; }

 private:
  double look(const std::vector<double>& place);
  void tryPairs(std::vector<double> place, std::size_t along,
                std::vector<std::pair<double, std::vector<double>>>& starts);

  std::vector<Side> sides_;
  Value value_;
  std::vector<double> best_;
  double best_value_;
};

}  // namespace tactus::contracts
