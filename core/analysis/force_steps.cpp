#include "core/analysis/force_steps.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <tuple>

#include "core/analysis/step_line.h"
#include "core/fuzzy/membership.h"

namespace tactus::analysis {
namespace {

using fuzzy::Evaluation;

// A window that is a step nowhere may be one a little beside; those that come so near are looked at again.
constexpr double kNearlyStep = 0.7;
constexpr int kRefinements = 24;
// Places at most so many ulps apart enclose one place: a single place without a force is passed in no time.
constexpr double kOnePlace = 1e-12;

/// All forces along a line: of the mean at number 0, of expert e at e + 1.
class Lines {
 public:
  Lines(ForceProbe& probe, std::size_t input, std::vector<double> point)
      : probe_(probe), input_(input), point_(std::move(point)), experts_(probe.model().experts.size()) {}

  std::vector<LineForce> at(const std::vector<double>& places) {
    std::vector<LineForce> out(experts_.size() + 1);
    std::vector<std::vector<Evaluation>> forces(experts_.size() + 1);
    std::vector<std::vector<bool>> firing;
    for (const double x : places) {
      point_[input_] = x;
      forces[0].push_back(probe_.everyExpert(point_, experts_));
      std::vector<bool> fires;
      for (std::size_t e = 0; e < experts_.size(); ++e) {
        forces[e + 1].push_back(experts_[e]);
        fires.push_back(experts_[e].fired && probe_.compiled().weight(e) > 0);
      }
      firing.push_back(std::move(fires));
    }
    for (std::size_t who = 0; who < out.size(); ++who) {
      const auto same = [&](std::size_t k, std::size_t other) {
        return who == 0 ? firing[k] == firing[other] : forces[who][k].fired == forces[who][other].fired;
      };
      fill(out[who], places, forces[who], same);
    }
    return out;
  }

  /// Force of `who` at one place, or nothing.
  Evaluation at(std::size_t who, double x) {
    point_[input_] = x;
    return who == 0 ? probe_.mean(point_) : probe_.expert(who - 1, point_);
  }

  const std::vector<double>& pointAt(double x) {
    point_[input_] = x;
    return point_;
  }

 private:
  template <class Same>
  void fill(LineForce& line, const std::vector<double>& places, const std::vector<Evaluation>& forces,
            const Same& same) const {
    const auto& input = probe_.model().inputs[input_];
    const double one_place = kOnePlace * std::max({1.0, std::abs(input.min), std::abs(input.max)});
    int piece = 0;
    std::size_t last = 0;
    bool any = false;
    for (std::size_t k = 0; k < places.size(); ++k) {
      const bool lone = k > 0 && k + 1 < places.size() && places[k + 1] - places[k - 1] <= one_place &&
                        !same(k, k - 1) && same(k - 1, k + 1);
      if (lone) continue;
      if (any && !same(last, k)) ++piece;
      any = true;
      last = k;
      if (!forces[k].fired) continue;
      line.x.push_back(places[k]);
      line.force_n.push_back(forces[k].force_n);
      line.piece.push_back(piece);
    }
  }

  ForceProbe& probe_;
  std::size_t input_;
  std::vector<double> point_;
  std::vector<Evaluation> experts_;
};

ForceStep stepFrom(const LineForce& line, std::size_t who, std::size_t input, const std::vector<double>& point,
                   const LinePair& pair) {
  ForceStep out;
  if (who > 0) out.expert = who - 1;
  out.input = input;
  out.from = out.to = point;
  out.from[input] = line.x[pair.from];
  out.to[input] = line.x[pair.to];
  out.from_n = line.force_n[pair.from];
  out.to_n = line.force_n[pair.to];
  out.noticeable = pair.noticeable;
  return out;
}

ForceStep stepFrom(Lines& lines, std::size_t who, std::size_t input, double from, double to, const StepLimits& limits) {
  ForceStep out;
  if (who > 0) out.expert = who - 1;
  out.input = input;
  out.from = lines.pointAt(from);
  out.to = lines.pointAt(to);
  out.from_n = lines.at(who, from).force_n;
  out.to_n = lines.at(who, to).force_n;
  out.noticeable =
      std::abs(out.to_n - out.from_n) / limits.noticeable(std::min(std::abs(out.from_n), std::abs(out.to_n)));
  return out;
}

/// The window of the full width beside `pair` with the largest change, by golden section: between kinks the change is
/// smooth in where the window begins.
ForceStep refined(Lines& lines, std::size_t who, std::size_t input, const LineForce& line, const LinePair& pair,
                  double width, const StepLimits& limits) {
  ForceStep best = stepFrom(lines, who, input, line.x[pair.from], line.x[pair.to], limits);
  // The ends of the piece, where no rule starts or stops to fire.
  std::size_t first = pair.from;
  std::size_t last = pair.to;
  while (first > 0 && line.piece[first - 1] == line.piece[pair.from]) --first;
  while (last + 1 < line.x.size() && line.piece[last + 1] == line.piece[pair.from]) ++last;
  double low = std::max(line.x[first], line.x[pair.from] - width);
  double high = std::min(line.x[last] - width, line.x[pair.from] + width);
  if (!(low < high)) return best;
  const auto change = [&](double from) {
    const Evaluation one = lines.at(who, from);
    const Evaluation other = lines.at(who, from + width);
    if (!one.fired || !other.fired) return 0.0;
    return std::abs(other.force_n - one.force_n) /
           limits.noticeable(std::min(std::abs(one.force_n), std::abs(other.force_n)));
  };
  const double golden = (std::sqrt(5.0) - 1) / 2;
  double left = high - golden * (high - low);
  double right = low + golden * (high - low);
  double at_left = change(left);
  double at_right = change(right);
  for (int i = 0; i < kRefinements; ++i) {
    if (at_left > at_right) {
      high = right;
      right = left;
      at_right = at_left;
      left = high - golden * (high - low);
      at_left = change(left);
    } else {
      low = left;
      left = right;
      at_left = at_right;
      right = low + golden * (high - low);
      at_right = change(right);
    }
  }
  const double from = at_left > at_right ? left : right;
  // A narrow pair says better where it is, unless the whole window has clearly more.
  constexpr double kClearlyMore = 1.01;
  if (std::max(at_left, at_right) > kClearlyMore * best.noticeable) {
    best = stepFrom(lines, who, input, from, from + width, limits);
  }
  return best;
}

/// Calls `found(step)` for the steps along one line, and for what comes near to one.
template <class Found>
void look(ForceProbe& probe, const StepPlaces& places, std::size_t input, const std::vector<double>& point, bool fine,
          const StepLimits& limits, const Found& found) {
  const bool in_mm = places.variable().unit == "mm";
  Lines lines(probe, input, point);
  const auto all = lines.at(places.at(point, fine));
  for (std::size_t who = 0; who < all.size(); ++who) {
    for (const LinePair& pair : stepsOn(all[who], places.width(), in_mm, limits, kNearlyStep)) {
      ForceStep step = fine ? refined(lines, who, input, all[who], pair, places.width(), limits)
                            : stepFrom(all[who], who, input, point, pair);
      step.steep = pair.steep;
      if (!fine || step.noticeable > 1 || pair.steep) found(std::move(step));
    }
  }
}

bool overlap(const ForceStep& one, const ForceStep& other, double width) {
  return one.from[one.input] <= other.to[one.input] + width && other.from[one.input] <= one.to[one.input] + width;
}

/// The largest of the steps that lie at one place, for each of mean and experts and each input.
class Largest {
 public:
  explicit Largest(const fuzzy::ForceModel& model) : model_(model) {}

  void take(ForceStep step) {
    auto& known = steps_[{step.input, step.expert ? *step.expert + 1 : 0}];
    const double width = stepWidth(model_.inputs[step.input]);
    const auto larger = [&](const ForceStep& other) {
      return overlap(step, other, width) && other.noticeable >= step.noticeable;
    };
    if (std::any_of(known.begin(), known.end(), larger)) return;
    std::erase_if(known, [&](const ForceStep& other) { return overlap(step, other, width); });
    known.push_back(std::move(step));
  }

  std::vector<ForceStep> all() {
    std::vector<ForceStep> out;
    for (auto& [key, known] : steps_) {
      std::sort(known.begin(), known.end(),
                [](const ForceStep& a, const ForceStep& b) { return a.from[a.input] < b.from[a.input]; });
      std::move(known.begin(), known.end(), std::back_inserter(out));
    }
    return out;
  }

 private:
  const fuzzy::ForceModel& model_;
  std::map<std::pair<std::size_t, std::size_t>, std::vector<ForceStep>> steps_;
};

/// Whether some term of an expert holds at `x` by more than next to nothing.
bool isHeld(const fuzzy::ForceModel& model, const fuzzy::Variable& input, double x) {
  constexpr double kNextToNothing = 0.01;
  return std::any_of(model.experts.begin(), model.experts.end(), [&](const fuzzy::Expert& expert) {
    const auto& terms = termsFor(expert, input);
    return std::any_of(terms.begin(), terms.end(), [x](const fuzzy::Term& term) {
      return fuzzy::MembershipFunction::of(term)(x) > kNextToNothing;
    });
  });
}

/// Settings of the inputs but one: of those the first value stands for all.
SamplePoints settingsBeside(const ForceProbe& probe, std::size_t input, bool vertices_only, std::size_t most) {
  std::vector<std::vector<double>> values;
  for (std::size_t i = 0; i < probe.model().inputs.size(); ++i) {
    const auto& variable = probe.model().inputs[i];
    if (i == input) {
      values.push_back({variable.min});
      continue;
    }
    values.push_back(probe.values(i));
    // Ascending vertices come first, the middles between them after.
    if (vertices_only) values.back().resize((values.back().size() + 1) / 2);
    // Where regions only touch, each force is decided by next to nothing, and steps along any other input follow: the
    // step along this one says it.
    auto held = values.back();
    std::erase_if(held, [&](double x) { return !isHeld(probe.model(), variable, x); });
    if (!held.empty()) values.back() = std::move(held);
  }
  return {std::move(values), most};
}

}  // namespace

double stepWidth(const fuzzy::Variable& input) {
  constexpr double kCells = 250;
  return input.unit == "mm" ? 1 : (input.max - input.min) / kCells;
}

std::vector<ForceStep> forceStepsAlong(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                                       std::size_t input, std::span<const double> point, const StepLimits& limits) {
  constexpr std::size_t kNoLimit = static_cast<std::size_t>(-1);
  ForceProbe probe(model, compiled, kNoLimit);
  Largest largest(model);
  look(probe, StepPlaces(model, input), input, {point.begin(), point.end()}, true, limits,
       [&](ForceStep step) { largest.take(std::move(step)); });
  return largest.all();
}

std::vector<ForceStep> forceSteps(ForceProbe& probe, const StepLimits& limits, std::size_t evaluations,
                                  std::optional<std::size_t> only) {
  const auto& model = probe.model();
  const auto in_mm = static_cast<std::size_t>(std::count_if(
      model.inputs.begin(), model.inputs.end(), [](const fuzzy::Variable& input) { return input.unit == "mm"; }));
  const std::size_t others = model.inputs.size() - in_mm;
  std::vector<ForceStep> out;
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    if (only && i != *only) continue;
    const bool is_mm = model.inputs[i].unit == "mm";
    const std::size_t third = evaluations / 3;
    const std::size_t whole = only || in_mm == 0 || others == 0 ? evaluations : is_mm ? 2 * third : third;
    const std::size_t share = only ? whole : whole / (is_mm ? in_mm : others);
    const StepPlaces places(model, i);
    const std::size_t lines = std::max<std::size_t>(1, share / (1 + places.usualCount()));
    Largest nearly(model);
    const auto along = [&](const SamplePoints& settings) {
      for (std::size_t p = 0; p < settings.size() && probe.affords(); ++p) {
        look(probe, places, i, settings[p], false, limits, [&](ForceStep step) { nearly.take(std::move(step)); });
      }
      return settings.size();
    };
    const std::size_t looked = along(settingsBeside(probe, i, true, lines));
    if (looked < lines) along(settingsBeside(probe, i, false, lines - looked));
    // The lines with the largest of them once more, closely; those of one setting together.
    std::set<std::vector<double>> settings;
    for (const ForceStep& step : nearly.all()) {
      auto setting = step.from;
      setting[i] = model.inputs[i].min;
      settings.insert(std::move(setting));
    }
    Largest largest(model);
    for (const auto& setting : settings) {
      if (!probe.affords()) break;
      look(probe, places, i, setting, true, limits, [&](ForceStep step) { largest.take(std::move(step)); });
    }
    auto found = largest.all();
    std::move(found.begin(), found.end(), std::back_inserter(out));
  }
  return out;
}

}  // namespace tactus::analysis
