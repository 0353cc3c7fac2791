#include "core/analysis/counterfactuals.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/analysis/force_balance.h"

namespace tactus::analysis {
namespace {

using fuzzy::MembershipFunction;

constexpr int kLooks = 8;              // between two places at which a slope can change
constexpr int kHalvings = 60;          // to the last digit of a double
constexpr double kSameShare = 1e-9;    // of the area: a tie
constexpr double kGaussianSigmas = 4;  // a Gaussian changes nothing beyond
constexpr double kFullMembership = 1 - 1e-12;

/// The words with the largest share at a point: one, or several that tie.
using LargestWords = std::vector<std::string>;

class Explorer {
 public:
  Explorer(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled, std::vector<double> point,
           std::optional<std::size_t> expert)
      : model_(model), compiled_(compiled), point_(std::move(point)), expert_(expert) {}

  /// The force with `input` at `value`; nothing in a hole.
  std::optional<double> force(std::size_t input, double value) {
    const double kept = std::exchange(point_[input], value);
    const auto found = expert_ ? compiled_.evaluateExpert(*expert_, point_) : compiled_.evaluate(point_);
    point_[input] = kept;
    return found.fired ? std::optional(found.force_n) : std::nullopt;
  }

  LargestWords largest(std::size_t input, double value) {
    const double kept = std::exchange(point_[input], value);
    const auto explanation = explain(model_, compiled_, point_);
    point_[input] = kept;
    LargestWords out;
    if (!explanation) return out;
    const ForceBalance balance = forceBalance(model_, *explanation, expert_);
    double most = 0;
    for (const WordPull& word : balance.words) most = std::max(most, word.share);
    for (const WordPull& word : balance.words) {
      if (word.share >= most - kSameShare) out.push_back(word.term);
    }
    return out;
  }

  /// The experts whose forces count.
  std::vector<std::size_t> experts() const {
    if (expert_) return {*expert_};
    std::vector<std::size_t> out;
    for (std::size_t e = 0; e < model_.experts.size(); ++e) {
      if (compiled_.weight(e) > 0) out.push_back(e);
    }
    return out;
  }

  /// The terms of `input` that count, each once.
  std::vector<fuzzy::Term> terms(std::size_t input) const {
    std::vector<fuzzy::Term> out;
    for (const std::size_t e : experts()) {
      for (const fuzzy::Term& term : termsFor(model_.experts[e], model_.inputs[input])) {
        if (std::find(out.begin(), out.end(), term) == out.end()) out.push_back(term);
      }
    }
    return out;
  }

  const std::vector<double>& point() const { return point_; }

 private:
  const fuzzy::ForceModel& model_;
  const fuzzy::CompiledModel& compiled_;
  std::vector<double> point_;
  std::optional<std::size_t> expert_;
};

/// The places along `input` at which a slope of the force can change: vertices of its terms, and places where one of
/// their memberships equals another one. Ascending, from one end of the universe to the other.
std::vector<double> bends(const fuzzy::ForceModel& model, const Explorer& explorer, std::size_t input) {
  const fuzzy::Variable& variable = model.inputs[input];
  const std::vector<fuzzy::Term> terms = explorer.terms(input);
  std::vector<double> places = {variable.min, variable.max};
  std::vector<MembershipFunction> functions;
  for (const fuzzy::Term& term : terms) {
    const auto& f = functions.emplace_back(MembershipFunction::of(term));
    if (f.gaussian) {
      for (double sigmas = -kGaussianSigmas; sigmas <= kGaussianSigmas; ++sigmas) {
        places.push_back(f.mean + sigmas * f.sigma);
      }
    } else {
      places.insert(places.end(), {f.a, f.b, f.c, f.d});
    }
  }
  std::vector<double> levels;  // memberships of the other inputs
  for (std::size_t other = 0; other < model.inputs.size(); ++other) {
    if (other == input) continue;
    for (const fuzzy::Term& term : explorer.terms(other)) {
      const double level = MembershipFunction::of(term)(explorer.point()[other]);
      if (level > 0 && level < 1) levels.push_back(level);
    }
  }
  std::sort(places.begin(), places.end());
  std::vector<double> crossings;
  for (std::size_t i = 1; i < places.size(); ++i) {
    const double from = places[i - 1];
    const double to = places[i];
    if (from >= to) continue;
    const auto crossing = [&](double left, double right) {  // of a line with 0
      if (left * right < 0) crossings.push_back(from + (to - from) * left / (left - right));
    };
    // Just inside the piece: edges may be vertical.
    const double inside = (to - from) * 1e-9;
    for (std::size_t one = 0; one < functions.size(); ++one) {
      const double left = functions[one](from + inside);
      const double right = functions[one](to - inside);
      for (const double level : levels) crossing(left - level, right - level);
      for (std::size_t other = one + 1; other < functions.size(); ++other) {
        crossing(left - functions[other](from + inside), right - functions[other](to - inside));
      }
    }
  }
  places.insert(places.end(), crossings.begin(), crossings.end());
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  std::erase_if(places, [&](double x) { return x < variable.min || x > variable.max; });
  return places;
}

/// The places from `now` on in one direction at which the force is looked at, nearest first.
std::vector<double> looks(const std::vector<double>& bends, double now, bool upward) {
  std::vector<double> stops = {now};
  for (const double x : bends) {
    if (upward ? x > now : x < now) stops.push_back(x);
  }
  if (upward) {
    std::sort(stops.begin(), stops.end());
  } else {
    std::sort(stops.begin(), stops.end(), std::greater<>());
  }
  std::vector<double> out;
  for (std::size_t i = 1; i < stops.size(); ++i) {
    for (int look = 1; look <= kLooks; ++look) {
      out.push_back(stops[i - 1] + (stops[i] - stops[i - 1]) * look / (kLooks + 1));
    }
    out.push_back(stops[i]);
  }
  return out;
}

/// The nearest place from `now` on at which `changed` is true; nothing if there is none. `changed` gives nothing in a
/// hole, where the search ends.
template <class Changed>
std::optional<double> nearestChange(const std::vector<double>& bends, double now, bool upward, Changed changed) {
  double before = now;
  for (const double x : looks(bends, now, upward)) {
    const std::optional<bool> is = changed(x);
    if (!is) return std::nullopt;
    if (!*is) {
      before = x;
      continue;
    }
    double after = x;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = (before + after) / 2;
      (changed(middle).value_or(true) ? after : before) = middle;
    }
    return changed(after).value_or(false) ? std::optional(after) : std::nullopt;
  }
  return std::nullopt;
}

/// The nearer of the changes upward and downward.
template <class Changed>
std::optional<double> nearestChange(const std::vector<double>& bends, double now, Changed changed) {
  const auto up = nearestChange(bends, now, true, changed);
  const auto down = nearestChange(bends, now, false, changed);
  if (up && down) return *up - now <= now - *down ? up : down;
  return up ? up : down;
}

/// The middle of the core of `term` within `variable`.
double middleOfCore(const fuzzy::Term& term, const fuzzy::Variable& variable) {
  const auto f = MembershipFunction::of(term);
  if (f.gaussian) return std::clamp(f.mean, variable.min, variable.max);
  return (std::clamp(f.b, variable.min, variable.max) + std::clamp(f.c, variable.min, variable.max)) / 2;
}

}  // namespace

base::Result<std::vector<Counterfactual>> counterfactuals(const fuzzy::ForceModel& model,
                                                          const fuzzy::CompiledModel& compiled,
                                                          std::span<const double> inputs,
                                                          const NoticeableDifference& noticeable,
                                                          std::optional<std::size_t> expert) {
  const auto explanation = explain(model, compiled, inputs);
  if (!explanation) return tl::unexpected(explanation.error());
  std::vector<double> point;
  for (const ExplainedInput& input : explanation->inputs) point.push_back(input.value);
  Explorer explorer(model, compiled, point, expert);
  std::vector<Counterfactual> out;
  const auto now_n = explorer.force(0, point[0]);
  if (!now_n) return out;
  const LargestWords largest = explorer.largest(0, point[0]);
  const double felt_n = noticeable(std::abs(*now_n));

  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    const double now = point[i];
    for (const fuzzy::Term& term : explorer.terms(i)) {
      if (MembershipFunction::of(term)(now) >= kFullMembership) continue;
      const double value = middleOfCore(term, model.inputs[i]);
      if (const auto there_n = explorer.force(i, value)) {
        out.push_back({Counterfactual::Kind::kTerm, i, value, value - now, *there_n, term.id, {}});
      }
    }
    const std::vector<double> places = bends(model, explorer, i);
    const auto felt = nearestChange(places, now, [&](double x) -> std::optional<bool> {
      const auto there_n = explorer.force(i, x);
      if (!there_n) return std::nullopt;
      return std::abs(*there_n - *now_n) >= felt_n;
    });
    if (felt)
      out.push_back({Counterfactual::Kind::kNoticeable, i, *felt, *felt - now, *explorer.force(i, *felt), {}, {}});
    if (largest.size() > 1) {
      if (i == 0) out.push_back({Counterfactual::Kind::kLargestWord, i, now, 0, *now_n, largest[0], largest[1]});
      continue;
    }
    const auto another = [&](double x) -> std::optional<std::string> {  // largest at x; empty: the same as now
      const LargestWords there = explorer.largest(i, x);
      if (there.empty()) return std::nullopt;
      const auto word = std::find_if(there.begin(), there.end(), [&](const auto& w) { return w != largest[0]; });
      return word == there.end() ? std::string() : *word;
    };
    const auto word = nearestChange(places, now, [&](double x) -> std::optional<bool> {
      const auto there = another(x);
      return there ? std::optional(!there->empty()) : std::nullopt;
    });
    if (word) {
      out.push_back({Counterfactual::Kind::kLargestWord, i, *word, *word - now, *explorer.force(i, *word), largest[0],
                     *another(*word)});
    }
  }
  return out;
}

}  // namespace tactus::analysis
