#include "core/analysis/step_line.h"

#include <algorithm>
#include <cmath>

#include "core/fuzzy/force_model.h"
#include "core/fuzzy/membership.h"

namespace tactus::analysis {
namespace {

// A narrower pair that has nearly all of the change says better where it is.
constexpr double kNearlyAll = 0.99;
// Distances are differences of rounded sums.
constexpr double kDistanceRounding = 1 + 1e-9;

// Memberships of other inputs that kinks are looked for at; where there are more, an even selection.
constexpr std::size_t kMostConstants = 16;
// Flanks whose crossings are looked for; beyond that the even places find what they miss.
constexpr std::size_t kMostFlanks = 64;

template <class T>
void sortUnique(std::vector<T>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

/// Where a Gaussian is steep, or nearly nothing.
void addGaussian(const fuzzy::MembershipFunction& f, std::vector<double>& kinks) {
  for (const double sigmas : {0.0, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0}) {
    kinks.push_back(f.mean - sigmas * f.sigma);
    kinks.push_back(f.mean + sigmas * f.sigma);
  }
}

}  // namespace

StepPlaces::StepPlaces(const fuzzy::ForceModel& model, std::size_t input)
    : model_(model), input_(input), width_(stepWidth(model.inputs[input])) {
  const fuzzy::Variable& variable = model.inputs[input];
  for (const auto& expert : model.experts) {
    for (const auto& term : termsFor(expert, variable)) {
      const auto f = fuzzy::MembershipFunction::of(term);
      if (f.gaussian) {
        addGaussian(f, fixed_);
        continue;
      }
      fixed_.insert(fixed_.end(), {f.a, f.b, f.c, f.d});
      for (const auto& rule : expert.rules) {
        const bool names = std::any_of(rule.conditions.begin(), rule.conditions.end(), [&](const auto& condition) {
          return condition.input == variable.id && condition.term == term.id;
        });
        if (!names || !fuzzy::takesPart(rule)) continue;
        if (f.a < f.b) flanks_.push_back({f.a, f.b, rule.weight});
        if (f.c < f.d) flanks_.push_back({f.d, f.c, rule.weight});
      }
    }
    sortUnique(flanks_);
    sortUnique(fixed_);
  }
  const std::size_t crossing = std::min(flanks_.size(), kMostFlanks);
  for (std::size_t i = 0; i < crossing; ++i) {
    for (std::size_t k = i + 1; k < crossing; ++k) {
      const Flank& one = flanks_[i];
      const Flank& other = flanks_[k];
      const double slope = one.top / (one.shoulder - one.foot) - other.top / (other.shoulder - other.foot);
      const double at =
          (one.top / (one.shoulder - one.foot) * one.foot - other.top / (other.shoulder - other.foot) * other.foot) /
          slope;
      const auto on = [at](const Flank& f) {
        return at >= std::min(f.foot, f.shoulder) && at <= std::max(f.foot, f.shoulder);
      };
      if (std::isfinite(at) && on(one) && on(other)) fixed_.push_back(at);
    }
  }
  fixed_.insert(fixed_.end(), {variable.min, variable.max});
  std::erase_if(fixed_, [&](double x) { return x < variable.min - width_ || x > variable.max + width_; });
  sortUnique(fixed_);
}

/// The strengths in (0, 1) that rules have by their other inputs: where a flank passes one of them there is a kink.
std::vector<double> StepPlaces::constants(std::span<const double> point) const {
  std::vector<double> out;
  std::vector<std::vector<double>> shared(model_.inputs.size());
  for (std::size_t i = 0; i < model_.inputs.size(); ++i) {
    if (i == input_) continue;
    for (const auto& expert : model_.experts) {
      const auto& terms = termsFor(expert, model_.inputs[i]);
      // Experts that share their terms have the same memberships.
      if (&expert != &model_.experts.front() && &terms == &model_.inputs[i].terms && !shared[i].empty()) continue;
      for (const auto& term : terms) {
        const double membership = fuzzy::MembershipFunction::of(term)(point[i]);
        if (membership > 0) shared[i].push_back(membership);
      }
    }
    out.insert(out.end(), shared[i].begin(), shared[i].end());
  }
  std::vector<double> weights = {1};
  for (const Flank& flank : flanks_) weights.push_back(flank.top);
  sortUnique(weights);
  sortUnique(out);
  std::vector<double> weighted;
  for (const double weight : weights) {
    for (const double membership : out) {
      if (weight * membership < 1) weighted.push_back(weight * membership);
    }
    if (weight < 1) weighted.push_back(weight);
  }
  sortUnique(weighted);
  if (weighted.size() <= kMostConstants) return weighted;
  std::vector<double> selected;
  for (std::size_t k = 0; k < kMostConstants; ++k) selected.push_back(weighted[k * weighted.size() / kMostConstants]);
  return selected;
}

std::vector<double> StepPlaces::at(std::span<const double> point, bool even) const {
  std::vector<double> kinks = fixed_;
  for (const double strength : constants(point)) {
    for (const Flank& flank : flanks_) {
      if (strength < flank.top) {
        kinks.push_back(flank.foot + strength / flank.top * (flank.shoulder - flank.foot));
      }
    }
  }
  sortUnique(kinks);
  std::vector<double> out;
  const double min = variable().min;
  const double max = variable().max;
  for (const double kink : kinks) {
    for (const double x : {kink - width_, kink - width_ / 2, std::nextafter(kink, -HUGE_VAL), kink,
                           std::nextafter(kink, HUGE_VAL), kink + width_ / 2, kink + width_}) {
      if (x >= min && x <= max) out.push_back(x);
    }
  }
  if (even) {
    const auto count = static_cast<std::size_t>(std::min(2 * (max - min) / width_, 4000.0));
    for (std::size_t k = 0; k <= count; ++k) {
      out.push_back(min + (max - min) * static_cast<double>(k) / static_cast<double>(std::max<std::size_t>(count, 1)));
    }
  }
  sortUnique(out);
  return out;
}

std::vector<LinePair> stepsOn(const LineForce& line, double width, bool in_mm, const StepLimits& limits, double least) {
  std::vector<LinePair> found;
  const std::size_t count = line.x.size();
  const auto pair = [&](std::size_t from, std::size_t to) -> LinePair {
    const double change = std::abs(line.force_n[to] - line.force_n[from]);
    if (change < limits.smallest_n) return {from, to, 0, false};
    const double smaller = std::min(std::abs(line.force_n[from]), std::abs(line.force_n[to]));
    return {from, to, change / limits.noticeable(smaller),
            in_mm && change > limits.stiffness_n_mm * (line.x[to] - line.x[from])};
  };
  for (std::size_t from = 0; from < count; ++from) {
    LinePair best{from, from, 0, false};
    for (std::size_t to = from + 1;
         to < count && line.piece[to] == line.piece[from] && line.x[to] - line.x[from] <= width * kDistanceRounding;
         ++to) {
      const LinePair here = pair(from, to);
      if (here.noticeable < least && !here.steep) continue;
      // The narrower of two that are nearly the same.
      if (here.noticeable * kNearlyAll > best.noticeable) best = here;
    }
    if (best.to != from) found.push_back(best);
  }
  // From the other end: a later start of the same change is narrower.
  for (LinePair& one : found) {
    for (std::size_t from = one.from + 1; from < one.to; ++from) {
      const LinePair here = pair(from, one.to);
      if (here.noticeable < kNearlyAll * one.noticeable) continue;
      one = here;
    }
  }
  // Pairs that overlap are one step: its largest pair stands for it.
  std::vector<LinePair> out;
  double end = -HUGE_VAL;
  for (const LinePair& one : found) {
    if (out.empty() || line.x[one.from] > end) {
      out.push_back(one);
    } else if (one.noticeable > out.back().noticeable) {
      out.back() = one;
    }
    end = std::max(end, line.x[one.to]);
  }
  return out;
}

}  // namespace tactus::analysis
