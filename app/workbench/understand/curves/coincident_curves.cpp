#include "app/workbench/understand/curves/coincident_curves.h"

#include <cmath>
#include <numeric>

namespace tactus::workbench {
namespace {

constexpr std::size_t kMostExperts = 12;
constexpr double kLeastShare = 0.1;  // of the axis; shorter stretches are crossings

bool coincide(const std::vector<double>& x, const std::vector<fuzzy::Evaluation>& one,
              const std::vector<fuzzy::Evaluation>& other, double within_n) {
  const auto near = [&](std::size_t i) {
    return one[i].fired && other[i].fired && std::abs(one[i].force_n - other[i].force_n) <= within_n;
  };
  double together = 0;
  for (std::size_t i = 1; i < x.size(); ++i) {
    if (near(i - 1) && near(i)) together += x[i] - x[i - 1];
  }
  return together >= kLeastShare * (x.back() - x.front());
}

}  // namespace

std::vector<Coincidence> coincidences(const figures::ForceCurves& curves, double within_n) {
  const std::size_t count = curves.experts.size();
  std::vector<Coincidence> out(count);
  if (count > kMostExperts || curves.x.size() < 2) return out;
  // The first expert of each group.
  std::vector<std::size_t> first(count);
  std::iota(first.begin(), first.end(), std::size_t{0});
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) {
      if (first[j] == first[i] || !coincide(curves.x, curves.experts[i], curves.experts[j], within_n)) continue;
      const std::size_t joined = first[j];
      for (std::size_t& one : first) {
        if (one == joined) one = first[i];
      }
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    out[i] = {0, 0};
    for (std::size_t j = 0; j < count; ++j) {
      if (first[j] != first[i]) continue;
      if (j < i) ++out[i].member;
      ++out[i].of;
    }
  }
  return out;
}

}  // namespace tactus::workbench
