#include "elicitation/uncertainty/cast.h"

#include <cmath>

#include "core/base/check.h"

namespace tactus::elicitation {
namespace {

double factorial(std::size_t n) { return n < 2 ? 1 : static_cast<double>(n) * factorial(n - 1); }

void fill(std::size_t place, std::size_t left, WeightedCast& one, std::vector<WeightedCast>& out) {
  if (place + 1 == one.cast.size()) {
    one.cast[place] = left;
    const auto n = one.cast.size();
    one.weight = factorial(n) / std::pow(static_cast<double>(n), static_cast<double>(n));
    for (const std::size_t times : one.cast) one.weight /= factorial(times);
    out.push_back(one);
    return;
  }
  for (std::size_t times = left + 1; times-- > 0;) {
    one.cast[place] = times;
    fill(place + 1, left - times, one, out);
  }
}

}  // namespace

Cast everyPerson(std::size_t people) { return Cast(people, 1); }

Cast drawCast(std::size_t people, base::Random& random) {
  Cast cast(people, 0);
  for (std::size_t i = 0; i < people; ++i) ++cast[static_cast<std::size_t>(random.below(static_cast<int>(people)))];
  return cast;
}

std::vector<WeightedCast> everyCast(std::size_t people) {
  TACTUS_CHECK(people >= 1 && people <= kMostEnumerated);
  std::vector<WeightedCast> out;
  WeightedCast one{Cast(people, 0), 1};
  fill(0, people, one, out);
  return out;
}

}  // namespace tactus::elicitation
