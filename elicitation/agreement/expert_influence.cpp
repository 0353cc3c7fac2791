#include "elicitation/agreement/expert_influence.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/analysis/sample_points.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/fuzzy/batch.h"
#include "elicitation/force/noticeable_force.h"

namespace tactus::elicitation {
namespace {

constexpr std::size_t kMostKinkPoints = 200'000;
constexpr std::size_t kSpreadPoints = 8'192;
/// Rules and pairs looked at in all, so that a study of a thousand experts ends in seconds.
constexpr std::size_t kInfluenceAllowance = 400'000'000;
constexpr std::size_t kPointsAtOnce = 1'024;

/// The forces of all experts at one point.
struct PointForces {
  std::vector<double> force_n;
  std::vector<std::uint8_t> fired;
};

/// The model of each expert alone.
base::Result<std::vector<fuzzy::CompiledModel>> compileEach(const fuzzy::ForceModel& model) {
  if (const auto whole = fuzzy::compile(model); !whole) return tl::unexpected(whole.error());
  fuzzy::ForceModel alone = model;
  alone.experts.clear();
  alone.accepted_holes.clear();
  alone.checks.clear();
  std::vector<fuzzy::CompiledModel> out;
  for (const auto& expert : model.experts) {
    alone.experts = {expert};
    alone.experts.front().weight = 1;
    TACTUS_TRY(auto compiled, fuzzy::compile(alone));
    out.push_back(std::move(compiled));
  }
  return out;
}

/// Calls `visit(point, forces)` at every one of `points`, and `go_on` with the number of points before each block;
/// false ends it. Returns whether it came to the end.
template <class Visit, class GoOn>
bool forEachPoint(const std::vector<fuzzy::CompiledModel>& experts, const analysis::SamplePoints& points,
                  std::size_t inputs, Visit visit, GoOn go_on) {
  std::vector<std::vector<double>> columns(inputs, std::vector<double>(kPointsAtOnce));
  std::vector<std::vector<double>> forces_n(experts.size(), std::vector<double>(kPointsAtOnce));
  std::vector<std::vector<std::uint8_t>> fired(experts.size(), std::vector<std::uint8_t>(kPointsAtOnce));
  std::vector<std::vector<double>> block;
  PointForces at{std::vector<double>(experts.size()), std::vector<std::uint8_t>(experts.size())};
  for (std::size_t begin = 0; begin < points.size(); begin += kPointsAtOnce) {
    if (!go_on(begin)) return false;
    const std::size_t count = std::min(kPointsAtOnce, points.size() - begin);
    block.clear();
    for (std::size_t i = 0; i < count; ++i) {
      block.push_back(points[begin + i]);
      for (std::size_t k = 0; k < inputs; ++k) columns[k][i] = block.back()[k];
    }
    std::vector<std::span<const double>> views;
    views.reserve(inputs);
    for (const auto& column : columns) views.emplace_back(column.data(), count);
    for (std::size_t e = 0; e < experts.size(); ++e) {
      fuzzy::evaluateBatch(experts[e], views, {{forces_n[e].data(), count}, {fired[e].data(), count}});
    }
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t e = 0; e < experts.size(); ++e) {
        at.force_n[e] = forces_n[e][i];
        at.fired[e] = fired[e][i];
      }
      visit(block[i], at);
    }
  }
  return true;
}

/// The averaged force, without the expert `left_out` where there is one; nothing where all others abstain.
std::optional<double> meanForce(std::span<const double> expert_weights, const PointForces& at,
                                std::optional<std::size_t> left_out) {
  double sum = 0;
  double weights = 0;
  for (std::size_t e = 0; e < expert_weights.size(); ++e) {
    if (e == left_out || at.fired[e] == 0) continue;
    sum += expert_weights[e] * at.force_n[e];
    weights += expert_weights[e];
  }
  if (!(weights > 0)) return std::nullopt;
  return sum / weights;
}

/// Sums over the points that are spread evenly.
struct SpreadSums {
  double squares = 0;
  std::size_t compared = 0;
  std::size_t alone = 0;

  double rms() const { return compared > 0 ? std::sqrt(squares / static_cast<double>(compared)) : 0; }
};

/// Takes the points one by one and keeps what is asked for.
class Comparison {
 public:
  explicit Comparison(const fuzzy::ForceModel& model)
      : model_(model), weights_(normalizedWeights(model)), expert_sums_(model.experts.size()) {
    for (const auto& expert : model.experts) out_.experts.emplace_back().expert = expert.id;
    for (std::size_t a = 0; a < model.experts.size(); ++a) {
      for (std::size_t b = a + 1; b < model.experts.size(); ++b) {
        auto& pair = out_.pairs.emplace_back();
        pair.first = model.experts[a].id;
        pair.second = model.experts[b].id;
      }
    }
    pair_sums_.resize(out_.pairs.size());
  }

  void take(const std::vector<double>& point, const PointForces& at, bool spread) {
    ++(spread ? out_.spread_points : out_.kink_points);
    takeExperts(point, at, spread);
    takePairs(point, at, spread);
  }

  ExpertInfluences result() {
    const auto share = [this](std::size_t points) {
      return static_cast<double>(points) / static_cast<double>(std::max<std::size_t>(1, out_.spread_points));
    };
    for (std::size_t e = 0; e < out_.experts.size(); ++e) {
      out_.experts[e].rms_n = expert_sums_[e].rms();
      out_.experts[e].share_alone = share(expert_sums_[e].alone);
    }
    for (std::size_t k = 0; k < out_.pairs.size(); ++k) {
      out_.pairs[k].rms_n = pair_sums_[k].rms();
      out_.pairs[k].share_both = share(pair_sums_[k].compared);
    }
    return std::move(out_);
  }

 private:
  void takeExperts(const std::vector<double>& point, const PointForces& at, bool spread) {
    const auto mean_n = meanForce(weights_, at, std::nullopt);
    if (!mean_n) return;
    for (std::size_t e = 0; e < model_.experts.size(); ++e) {
      auto& expert = out_.experts[e];
      const auto without_n = meanForce(weights_, at, e);
      if (!without_n) {
        if (expert.alone_at.empty()) expert.alone_at = point;
        if (spread) ++expert_sums_[e].alone;
        continue;
      }
      const double newtons = std::abs(*mean_n - *without_n);
      if (spread) add(expert_sums_[e], newtons);
      if (at.fired[e] == 0) continue;
      const SeenDifference seen{newtons, newtons / justNoticeableDifference(std::abs(*mean_n)), {}};
      keep(expert.largest, &SeenDifference::newtons, seen, point);
      keep(expert.most_noticeable, &SeenDifference::noticeable, seen, point);
    }
  }

  void takePairs(const std::vector<double>& point, const PointForces& at, bool spread) {
    std::size_t pair = 0;
    for (std::size_t a = 0; a < model_.experts.size(); ++a) {
      for (std::size_t b = a + 1; b < model_.experts.size(); ++b, ++pair) {
        if (at.fired[a] == 0 || at.fired[b] == 0) continue;
        const double newtons = std::abs(at.force_n[a] - at.force_n[b]);
        if (spread) add(pair_sums_[pair], newtons);
        // A study of 200 experts has 20,000 pairs: most points end here.
        auto& largest = out_.pairs[pair].largest;
        if (largest && !(largest->newtons < newtons)) continue;
        const double middle_n = std::abs(at.force_n[a] + at.force_n[b]) / 2;
        keep(largest, &SeenDifference::newtons, {newtons, newtons / justNoticeableDifference(middle_n), {}}, point);
      }
    }
  }

  /// The first of the largest stays.
  static void keep(std::optional<SeenDifference>& kept, double SeenDifference::*by, const SeenDifference& seen,
                   const std::vector<double>& point) {
    if (kept && !((*kept).*by < seen.*by)) return;
    kept = seen;
    kept->at = point;
  }

  static void add(SpreadSums& sums, double newtons) {
    sums.squares += newtons * newtons;
    ++sums.compared;
  }

  const fuzzy::ForceModel& model_;
  std::vector<double> weights_;  ///< normalizedWeights
  ExpertInfluences out_;
  std::vector<SpreadSums> expert_sums_;
  std::vector<SpreadSums> pair_sums_;
};

/// What one point costs, in rules and pairs looked at.
std::size_t costOf(const fuzzy::ForceModel& model) {
  std::size_t cost = model.experts.size() * model.experts.size();
  for (const auto& expert : model.experts) cost += expert.rules.size() + 32;
  return cost;
}

}  // namespace

base::Result<ExpertInfluences> expertInfluence(const fuzzy::ForceModel& model,
                                               const std::function<bool(double share)>& go_on) {
  TACTUS_TRY(const auto experts, compileEach(model));
  const std::size_t affordable = std::max<std::size_t>(64, kInfluenceAllowance / costOf(model));
  Comparison comparison(model);
  const std::size_t inputs = model.inputs.size();
  const auto kinks = analysis::kinkPoints(model, std::min(kMostKinkPoints, affordable));
  const auto even = analysis::evenPoints(model, std::min(kSpreadPoints, affordable));
  const auto all = static_cast<double>(kinks.size() + even.size());
  const auto goes_on = [&](std::size_t done) { return !go_on || go_on(static_cast<double>(done) / all); };
  const bool ended =
      forEachPoint(
          experts, kinks, inputs,
          [&comparison](const auto& point, const auto& at) { comparison.take(point, at, false); }, goes_on) &&
      forEachPoint(
          experts, even, inputs, [&comparison](const auto& point, const auto& at) { comparison.take(point, at, true); },
          [&](std::size_t done) { return goes_on(kinks.size() + done); });
  if (!ended)
    return base::fail(base::ErrorCode::kCancelled, "influence of experts", "a request to stop", "time to end");
  return comparison.result();
}

namespace {

/// So many digits as tell places of the universe apart: a thousandth of it, or finer.
std::string placeNumber(double value, const fuzzy::Variable& input) {
  const double digits = std::ceil(std::log10(1000 / (input.max - input.min)));
  const double unit = std::pow(10, std::max(0.0, digits));
  return base::formatNumber(std::round(value * unit) / unit);
}

bool unitTells(const fuzzy::ForceModel& model, const fuzzy::Variable& input) {
  return input.unit != "1" && std::count_if(model.inputs.begin(), model.inputs.end(),
                                            [&](const auto& other) { return other.unit == input.unit; }) == 1;
}

std::string placeText(const fuzzy::ForceModel& model, const std::vector<double>& point, bool every_name) {
  std::vector<std::string> parts;
  for (std::size_t k = 0; k < point.size(); ++k) {
    const auto& input = model.inputs[k];
    std::string name = input.id + ' ';
    std::replace(name.begin(), name.end(), '_', ' ');
    if (!every_name && unitTells(model, input)) name.clear();
    parts.push_back(name + placeNumber(point[k], input) + (input.unit == "1" ? "" : ' ' + input.unit));
  }
  return base::joined(parts, ", ");
}

}  // namespace

std::string pointText(const fuzzy::ForceModel& model, const std::vector<double>& point) {
  return placeText(model, point, true);
}

std::string shortPointText(const fuzzy::ForceModel& model, const std::vector<double>& point) {
  return placeText(model, point, false);
}

std::vector<std::string> influenceNotes(const fuzzy::ForceModel& model, const ExpertInfluences& influences) {
  std::vector<std::string> notes;
  for (const auto& expert : influences.experts) {
    const auto& most = expert.most_noticeable;
    if (!most || !(most->noticeable > kNotableDifference)) continue;
    notes.push_back("Without expert " + expert.expert + " the averaged force would change by " +
                    base::formatFixed(most->newtons, 2) + " N, " + base::formatFixed(most->noticeable, 1) +
                    " just-noticeable differences, at " + pointText(model, most->at) + ".");
  }
  return notes;
}

}  // namespace tactus::elicitation
