#include "core/contracts/worst_case.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/random.h"

namespace tactus::contracts {
namespace {

constexpr std::size_t kStarts = 6;
constexpr std::size_t kMostPairs = 60'000;
constexpr double kSmallestStep = 1e-9;  // of a side
constexpr int kMostRounds = 200;        // of one climb

/// Keeps the `kStarts` best.
void keep(std::vector<std::pair<double, std::vector<double>>>& starts, double value, const std::vector<double>& place) {
  if (!(value > -std::numeric_limits<double>::max())) return;
  if (starts.size() == kStarts && value <= starts.back().first) return;
  starts.emplace_back(value, place);
  std::stable_sort(starts.begin(), starts.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  if (starts.size() > kStarts) starts.pop_back();
}

}  // namespace

WorstCase::WorstCase(std::vector<Side> sides, Value value)
    : sides_(std::move(sides)), value_(std::move(value)), best_value_(-std::numeric_limits<double>::infinity()) {}

double WorstCase::look(const std::vector<double>& place) {
  const double value = value_(place);
  if (value > best_value_ || best_.empty()) best_value_ = value, best_ = place;
  return value;
}

void WorstCase::tryPairs(std::vector<double> place, std::size_t along,
                         std::vector<std::pair<double, std::vector<double>>>& starts) {
  // Every ordered pair of bends and of the middles between them.
  const Side& side = sides_[along];
  std::vector<double> ticks;
  for (std::size_t p = 0; p < side.places.size(); ++p) {
    if (p > 0) ticks.push_back(side.places[p - 1] + (side.places[p] - side.places[p - 1]) / 2);
    ticks.push_back(side.places[p]);
  }
  double best = -std::numeric_limits<double>::infinity();
  std::vector<double> at = place;
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    for (std::size_t j = i + 1; j < ticks.size() && j < i + 12; ++j) {
      place[along] = ticks[i];
      place.back() = ticks[j];
      const double value = look(place);
      if (value > best) best = value, at = place;
    }
    // On both sides of a place, where it may be a step.
    place[along] = std::nextafter(ticks[i], side.low);
    place.back() = std::nextafter(ticks[i], side.high);
    const double value = look(place);
    if (value > best) best = value, at = place;
  }
  keep(starts, best, at);
}

void WorstCase::search(std::optional<std::size_t> pairs, std::size_t lines) {
  if (pairs) lines = std::clamp<std::size_t>(kMostPairs / (24 * sides_[*pairs].places.size()), 24, lines);
  base::Random random(1);
  std::vector<std::pair<double, std::vector<double>>> starts;
  for (std::size_t n = 0; n < lines; ++n) {
    std::vector<double> place;
    for (const Side& side : sides_) {
      // Bends, middles between them, and places anywhere in turn.
      const auto p = static_cast<std::size_t>(random.below(static_cast<int>(side.places.size())));
      const double other = side.places[p + 1 < side.places.size() ? p + 1 : p];
      const int kind = random.below(3);
      const double share = kind == 1 ? 0.5 : random.uniform();
      place.push_back(kind == 0 ? side.places[p] : side.places[p] + (other - side.places[p]) * share);
    }
    if (pairs) {
      tryPairs(place, *pairs, starts);
    } else {
      for (int more = 0; more < 8; ++more) {
        const auto v = static_cast<std::size_t>(random.below(static_cast<int>(sides_.size())));
        const auto& places = sides_[v].places;
        place[v] = more % 2 == 0 ? places[static_cast<std::size_t>(random.below(static_cast<int>(places.size())))]
                                 : random.uniform(sides_[v].low, sides_[v].high);
        keep(starts, look(place), place);
      }
    }
  }
  for (const auto& [value, place] : starts) climb(place);
}

void WorstCase::climb(std::vector<double> place) {
  double value = look(place);
  int rounds = kMostRounds;
  for (double step = 0.125; step > kSmallestStep && --rounds > 0;) {
    bool better = false;
    for (std::size_t v = 0; v < sides_.size(); ++v) {
      const Side& side = sides_[v];
      const double now = place[v];
      double best = now;
      const auto consider = [&](double x) {
        place[v] = std::clamp(x, side.low, side.high);
        if (place[v] == now) return;
        const double there = look(place);
        if (there > value) value = there, best = place[v], better = true;
      };
      consider(now + step * (side.high - side.low));
      consider(now - step * (side.high - side.low));
      // The next bends, where an optimum often lies.
      const auto next = std::lower_bound(side.places.begin(), side.places.end(), now);
      if (next != side.places.end()) consider(*next);
      if (next != side.places.begin()) consider(*std::prev(next));
      place[v] = best;
    }
    if (!better) step /= 2;
  }
}

}  // namespace tactus::contracts
