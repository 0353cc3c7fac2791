#include "experiments/force_series.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <set>
#include <utility>

#include "core/base/text.h"
#include "experiments/seeded_order.h"

namespace tactus::experiments {
namespace {

constexpr double kPerNewton = 1e6;
constexpr int kMostSteps = 100;
constexpr int kMostDraws = 2000;
constexpr int kFirstCatch = 2;          ///< index of the first step that a catch trial can precede
constexpr double kCatchesWithin = 0.6;  ///< share of an ascending series, which may end early
constexpr int kFarthestRepeat = 4;      ///< steps back

tl::unexpected<base::Error> refuse(std::string place, double found, std::string wanted) {
  return base::fail(base::ErrorCode::kValue, std::move(place), base::formatNumber(found), std::move(wanted));
}

base::Result<void> validateForce(double force_n, double most_n, const std::string& place) {
  if (std::isfinite(force_n) && force_n > 0 && force_n <= most_n) return {};
  return refuse(place, force_n, "above 0 and at most " + base::formatNumber(most_n) + " N");
}

base::Result<void> validateSteps(const ForceSteps& steps, double most_n, const std::string& place) {
  if (auto ok = validateForce(steps.lowest_n, most_n, place + ".lowest_n"); !ok) return ok;
  if (auto ok = validateForce(steps.highest_n, most_n, place + ".highest_n"); !ok) return ok;
  if (steps.highest_n < steps.lowest_n) {
    return refuse(place + ".highest_n", steps.highest_n,
                  "at least lowest_n (" + base::formatNumber(steps.lowest_n) + ")");
  }
  if (!std::isfinite(steps.step_n) || steps.step_n < 0.01) {
    return refuse(place + ".step_n", steps.step_n, "at least 0.01 N");
  }
  const double steps_between = (steps.highest_n - steps.lowest_n) / steps.step_n;
  if (std::abs(steps_between - std::round(steps_between)) > 1e-6 || steps_between >= kMostSteps) {
    return refuse(place + ".step_n", steps.step_n,
                  "whole steps from lowest_n to highest_n, at most " + std::to_string(kMostSteps) + " forces");
  }
  return {};
}

base::Result<void> validateTerms(const std::vector<std::string>& terms) {
  const std::set<std::string> distinct(terms.begin(), terms.end());
  if (terms.size() < 2 || distinct.size() != terms.size() || distinct.contains("")) {
    return base::fail(base::ErrorCode::kValue, "terms", base::quoted(base::joined(terms, ", ")),
                      "at least two different term ids");
  }
  return {};
}

/// Draws one order of the block's forces, in steps (0 = blank), or nothing where it came to a dead end.
std::vector<int> drawOrder(std::vector<int> left, int widest_jump, base::Random& random) {
  std::vector<int> order;
  bool jumped = false;
  while (!left.empty()) {
    std::vector<std::size_t> allowed;
    for (std::size_t i = 0; i < left.size(); ++i) {
      const bool blank_first = order.empty() && left[i] == 0;
      const bool twice = !order.empty() && left[i] == order.back();
      const bool jumps = !order.empty() && std::abs(left[i] - order.back()) > widest_jump;
      if (!blank_first && !twice && !(jumps && jumped)) allowed.push_back(i);
    }
    if (allowed.empty()) return {};
    const std::size_t drawn = allowed[static_cast<std::size_t>(random.below(static_cast<int>(allowed.size())))];
    jumped = !order.empty() && std::abs(left[drawn] - order.back()) > widest_jump;
    order.push_back(left[drawn]);
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(drawn));
  }
  return order;
}

}  // namespace

int ForceSteps::count() const { return static_cast<int>(std::lround((highest_n - lowest_n) / step_n)) + 1; }

double ForceSteps::at(int i) const { return std::round((lowest_n + i * step_n) * kPerNewton) / kPerNewton; }

base::Result<void> validate(const ForceSettings& s) {
  if (auto ok = validateTerms(s.terms); !ok) return ok;
  if (!(s.device_scale >= 1 && s.device_scale <= 20)) return refuse("device_scale", s.device_scale, "1 to 20");
  const double most_n = kHighestForceN * s.device_scale;
  for (const double force_n : s.familiarisation_n) {
    if (auto ok = validateForce(force_n, most_n, "familiarisation_n"); !ok) return ok;
  }
  if (!s.ascending && !s.random) {
    return base::fail(base::ErrorCode::kValue, "ascending", "no series", "the ascending series or the random block");
  }
  if (s.descending && !s.ascending) {
    return base::fail(base::ErrorCode::kValue, "descending", "no ascending series", "one, whose end it starts from");
  }
  if (auto ok = validateSteps(s.ladder, most_n, "ladder"); !ok) return ok;
  if (auto ok = validateSteps(s.random_steps, most_n, "random_steps"); !ok) return ok;

  struct Range {
    const char* place;
    double value;
    double least;
    double most;
    const char* unit;
  };
  const std::array<Range, 14> ranges = {{{"descending_offset_most", double(s.descending_offset_most), 0, 5, " steps"},
                                         {"ladder_catches", double(s.ladder_catches), 0, 4, ""},
                                         {"random_repeats", double(s.random_repeats), 1, 10, ""},
                                         {"random_widest_jump", double(s.random_widest_jump), 1, 100, " steps"},
                                         {"forward_least_mm", s.forward_least_mm, 1, 100, " mm"},
                                         {"forward_least_mm_s", s.forward_least_mm_s, 1, 100, " mm/s"},
                                         {"device_friction_n", s.device_friction_n.value_or(0), 0, 1, " N"},
                                         {"ramp_s", s.ramp_s, 0.05, 1, " s"},
                                         {"continuous_n", s.continuous_n, 0.01, most_n, " N"},
                                         {"hold_limit_s", s.hold_limit_s, 0.5, 60, " s"},
                                         {"pause_s", s.pause_s, 2, 60, " s"},
                                         {"rest_every", double(s.rest_every), 0, 1000, " steps"},
                                         {"attempts_most", double(s.attempts_most), 2, 20, ""},
                                         {"start_zone_mm", s.start_zone_mm, 1, 100, " mm"}}};
  for (const auto& range : ranges) {
    if (range.value >= range.least && range.value <= range.most) continue;
    return refuse(range.place, range.value,
                  base::formatNumber(range.least) + " to " + base::formatNumber(range.most) + range.unit);
  }
  if (s.catch_share != 0 && !(s.catch_share >= 0.1 && s.catch_share <= 0.15)) {
    return refuse("catch_share", s.catch_share, "0.1 to 0.15, or 0 for no catch trials");
  }
  return {};
}

std::vector<SeriesStep> familiarisationSeries(const ForceSettings& settings) {
  std::vector<SeriesStep> series;
  for (const double force_n : settings.familiarisation_n) {
    series.push_back({kFamiliarisation, static_cast<int>(series.size()) + 1, force_n});
  }
  return series;
}

std::vector<SeriesStep> ascendingSeries(const ForceSettings& settings) {
  std::vector<SeriesStep> series;
  series.reserve(static_cast<std::size_t>(settings.ladder.count()));
  for (int i = 0; i < settings.ladder.count(); ++i) series.push_back({kAscending, i + 1, settings.ladder.at(i)});
  return series;
}

std::vector<SeriesStep> descendingSeries(const ForceSettings& settings, double start_n) {
  std::vector<SeriesStep> series;
  const int top = static_cast<int>(std::lround((start_n - settings.ladder.lowest_n) / settings.ladder.step_n));
  for (int i = top; i >= 0; --i) series.push_back({kDescending, top - i + 1, settings.ladder.at(i)});
  return series;
}

std::vector<SeriesStep> withCatchTrials(std::vector<SeriesStep> series, const ForceSettings& settings,
                                        std::uint64_t seed) {
  if (settings.ladder_catches == 0 || series.empty()) return series;
  const std::string name = series.front().series;
  const auto count = static_cast<int>(series.size());
  const int last = name == kAscending ? static_cast<int>(kCatchesWithin * count) : count - 1;
  std::vector<int> places;  // a catch trial comes before the step of this index
  for (int place = kFirstCatch; place <= last; ++place) places.push_back(place);
  base::Random random(blockSeed(seed, "force/" + name + "/catches"));
  places = shuffled(std::move(places), random);
  places.resize(std::min(places.size(), static_cast<std::size_t>(settings.ladder_catches)));
  const std::size_t blanks = (places.size() + 1) / 2;

  std::vector<SeriesStep> out;
  for (int i = 0; i < count; ++i) {
    const auto drawn = std::find(places.begin(), places.end(), i);
    if (drawn != places.end()) {
      const bool blank = static_cast<std::size_t>(drawn - places.begin()) < blanks;
      const int back = 2 + random.below(std::min(kFarthestRepeat, i) - 1);
      const double force_n = blank ? 0 : series[static_cast<std::size_t>(i - back)].force_n;
      out.push_back({name, static_cast<int>(out.size()) + 1, force_n, true});
    }
    out.push_back({name, static_cast<int>(out.size()) + 1, series[static_cast<std::size_t>(i)].force_n});
  }
  return out;
}

double descendingStart(const ForceSettings& settings, double reached_n, std::uint64_t seed) {
  base::Random random(blockSeed(seed, "force/descending"));
  const int offset = random.below(settings.descending_offset_most + 1);
  const auto reached = std::lround((reached_n - settings.ladder.lowest_n) / settings.ladder.step_n);
  return settings.ladder.at(std::max(0, static_cast<int>(reached) - offset));
}

base::Result<std::vector<SeriesStep>> randomBlock(const ForceSettings& settings, std::uint64_t seed) {
  const ForceSteps& steps = settings.random_steps;
  // Places on the ladder: 0 is no force, lowest_n stands as many steps above it as it is large.
  const int lowest = std::max(1, static_cast<int>(std::lround(steps.lowest_n / steps.step_n)));
  std::vector<int> places;
  for (int i = 0; i < steps.count(); ++i) {
    places.insert(places.end(), static_cast<std::size_t>(settings.random_repeats), lowest + i);
  }
  const double catch_trials = settings.catch_share / (1 - settings.catch_share) * static_cast<double>(places.size());
  const int catches = static_cast<int>(std::lround(catch_trials));
  const int blanks = (catches + 1) / 2;

  base::Random random(blockSeed(seed, "force/random"));
  std::vector<int> levels;
  levels.reserve(static_cast<std::size_t>(steps.count()));
  for (int i = 0; i < steps.count(); ++i) levels.push_back(lowest + i);
  levels = shuffled(std::move(levels), random);
  std::set<int> repeated;
  for (int i = 0; i < std::min(catches - blanks, steps.count()); ++i)
    repeated.insert(levels[static_cast<std::size_t>(i)]);
  places.insert(places.end(), repeated.begin(), repeated.end());
  places.insert(places.end(), static_cast<std::size_t>(blanks), 0);

  std::vector<int> order;
  for (int draw = 0; draw < kMostDraws && order.empty(); ++draw) {
    order = drawOrder(places, settings.random_widest_jump, random);
  }
  if (order.empty()) {
    return base::fail(
        base::ErrorCode::kData, "random_steps",
        std::to_string(steps.count()) + " forces, " + std::to_string(settings.random_repeats) + " times each",
        "an order without a force twice running; more forces or fewer repeats");
  }
  std::vector<SeriesStep> block;
  for (const int place : order) {
    const double force_n = place == 0 ? 0 : steps.at(place - lowest);
    block.push_back({kRandom, static_cast<int>(block.size()) + 1, force_n, place == 0});
  }
  for (const int place : repeated) {
    const auto last = std::find(order.rbegin(), order.rend(), place);
    block[static_cast<std::size_t>(std::distance(last, order.rend())) - 1].catch_trial = true;
  }
  return block;
}

}  // namespace tactus::experiments
