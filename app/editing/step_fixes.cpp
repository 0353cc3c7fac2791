#include "app/editing/step_fixes.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "app/editing/edit.h"
#include "app/editing/term_edits.h"
#include "app/editing/term_list.h"
#include "core/analysis/coverage.h"
#include "core/analysis/force_steps.h"
#include "core/base/text.h"
#include "core/fuzzy/force_model.h"
#include "core/fuzzy/membership.h"
#include "elicitation/force/noticeable_force.h"

namespace tactus::editing {
namespace {

using base::ErrorCode;
using base::fail;
using base::Result;
using fuzzy::ForceModel;
using Names = std::vector<std::string>;

bool contains(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

void drop(Names& names, const Names& away) {
  std::erase_if(names, [&](const std::string& name) { return contains(away, name); });
}

}  // namespace

std::optional<Names> holeNames(const ForceModel& model) {
  std::set<std::string> names;
  bool complete = true;
  const auto look = [&](std::span<const std::size_t> experts) {
    if (experts.empty()) return;
    const auto found = analysis::coverage(model, experts);
    complete = complete && found.complete;
    for (const auto& hole : found.holes) names.insert(analysis::describe(hole, model));
  };
  std::vector<std::size_t> weighty;
  for (std::size_t e = 0; e < model.experts.size(); ++e) {
    if (model.experts[e].weight > 0) weighty.push_back(e);
    look(std::span(&e, 1));
  }
  look(weighty);
  if (!complete) return std::nullopt;
  return Names(names.begin(), names.end());
}

Names lapsedAcceptances(const ForceModel& model) {
  if (model.accepted_holes.empty()) return {};
  const auto names = holeNames(model);
  if (!names) return {};
  Names out = model.accepted_holes;
  drop(out, *names);
  return out;
}

Result<Edit> acceptHole(const ForceModel& model, const std::string& name) {
  if (contains(model.accepted_holes, name)) {
    return fail(ErrorCode::kValue, "accepted holes", name + " already", "a hole that is not accepted yet");
  }
  const Names lapsed = lapsedAcceptances(model);
  ForceModel out = model;
  drop(out.accepted_holes, lapsed);
  out.accepted_holes.push_back(name);
  std::string label = "Hole accepted: " + name;
  if (!lapsed.empty()) label += ", in the place of " + base::joined(lapsed, " and ");
  return finished(std::move(out), std::move(label));
}

Result<Edit> withdrawAcceptance(const ForceModel& model, const std::string& name) {
  if (!contains(model.accepted_holes, name)) {
    return fail(ErrorCode::kValue, "accepted holes", "no " + name, "a hole that is accepted");
  }
  ForceModel out = model;
  drop(out.accepted_holes, {name});
  return finished(std::move(out), "Acceptance withdrawn: " + name);
}

Result<Edit> forgetLapsed(const ForceModel& model) {
  const Names lapsed = lapsedAcceptances(model);
  if (lapsed.empty()) {
    return fail(ErrorCode::kValue, "accepted holes", "no lapsed acceptance", "an acceptance whose hole is gone");
  }
  ForceModel out = model;
  drop(out.accepted_holes, lapsed);
  return finished(std::move(out), "Lapsed acceptance removed: " + base::joined(lapsed, " and "));
}

namespace {

using base::Result;
using fuzzy::ForceModel;
using fuzzy::Term;

// In step widths, so in mm of a depth.
constexpr double kWidths[] = {5, 10, 20, 40};
// Rules looked at for each width: some hundredths of a second.
constexpr std::size_t kStepAllowance = 20'000'000;

/// One flank of a term: between a foot and a shoulder.
struct Flank {
  TermListId list;
  std::size_t term = 0;
  bool rises = false;
  double low = 0;
  double high = 0;

  double foot() const { return rises ? low : high; }
};

/// Finds the flanks at a step and moves them.
class Widening {
 public:
  Widening(const ForceModel& model, std::span<const std::size_t> experts, const StepBetween& step)
      : model_(model),
        input_(model.inputs[step.input]),
        step_width_(analysis::stepWidth(input_)),
        low_(std::min(step.from[step.input], step.to[step.input])),
        high_(std::max(step.from[step.input], step.to[step.input])) {
    // The step may begin a little beside the foot that makes it.
    low_ -= step_width_ / 2;
    high_ += step_width_ / 2;
    for (const std::size_t e : experts) collect(model.experts[e]);
  }

  /// The model with all flanks at the step `width` wide, or nothing where no flank is narrower.
  std::optional<Result<Edit>> to(double width) const {
    const auto middle = middleOfStep(width);
    if (!middle) return std::nullopt;
    ForceModel out = model_;
    // By list: whose terms move is said for each.
    std::vector<std::pair<std::string, std::vector<std::string>>> moved;
    for (const Flank& flank : flanks_) {
      auto open = openList(out, flank.list);
      if (!open) return std::nullopt;
      Term& term = (*open->terms)[flank.term];
      if (!widen(term, flank, *middle, width)) continue;
      const std::string title = open->title();
      if (moved.empty() || moved.back().first != title) moved.push_back({title, {}});
      auto& names = moved.back().second;
      if (std::find(names.begin(), names.end(), labelOf(term)) == names.end()) names.push_back(labelOf(term));
    }
    if (moved.empty()) return std::nullopt;
    std::string label;
    for (const auto& [title, names] : moved) {
      label += (label.empty() ? "" : "; ") + title + " / " + base::joined(names, ", ");
    }
    label += ": step widened to " + quantityText(input_, width) + " around " + quantityText(input_, *middle);
    return finished(std::move(out), std::move(label));
  }

 private:
  void collect(const fuzzy::Expert& expert) {
    const TermListId list = listOf(expert, input_.id);
    const auto& terms = termsFor(expert, input_);
    for (std::size_t t = 0; t < terms.size(); ++t) {
      if (terms[t].shape == fuzzy::Shape::kGaussian || !isUsed(expert, terms[t].id)) continue;
      const auto f = fuzzy::MembershipFunction::of(terms[t]);
      for (const Flank& flank : {Flank{list, t, true, f.a, f.b}, Flank{list, t, false, f.c, f.d}}) {
        const bool known = std::any_of(flanks_.begin(), flanks_.end(), [&](const Flank& other) {
          return other.list == list && other.term == t && other.rises == flank.rises;
        });
        if (!known && flank.low <= high_ && flank.high >= low_) flanks_.push_back(flank);
      }
    }
  }

  bool isUsed(const fuzzy::Expert& expert, const std::string& term) const {
    return std::any_of(expert.rules.begin(), expert.rules.end(), [&](const fuzzy::Rule& rule) {
      return fuzzy::takesPart(rule) && names(rule, model_, input_, term);
    });
  }

  bool footIsHere(const Flank& flank) const { return flank.foot() >= low_ && flank.foot() <= high_; }

  /// The middle of the narrow flanks; where there is none, of the feet that meet at the step.
  std::optional<double> middleOfStep(double width) const {
    double sum = 0;
    double weights = 0;
    for (const bool narrow : {true, false}) {
      for (const Flank& flank : flanks_) {
        if (narrow != (flank.high - flank.low < width) || (!narrow && !footIsHere(flank))) continue;
        sum += narrow ? flank.low / 2 + flank.high / 2 : flank.foot();
        weights += 1;
      }
      if (weights > 0) return sum / weights;
    }
    return std::nullopt;
  }

  /// Moves the flank of `term`; returns whether it moved.
  bool widen(Term& term, const Flank& flank, double middle, double width) const {
    const bool narrow = flank.high - flank.low < width;
    if (!narrow && !footIsHere(flank)) return false;
    if (term.shape == fuzzy::Shape::kTriangle) {
      term.shape = fuzzy::Shape::kTrapezoid;
      term.points.insert(term.points.begin() + 1, term.points[1]);
    }
    auto& p = term.points;
    const double low = middle - width / 2;
    const double high = middle + width / 2;
    if (flank.rises) {
      // The other shoulder stays where it is.
      if (narrow) p[1] = std::min(high, p[2]);
      p[0] = std::min({narrow ? low : std::min(p[0], low), p[1]});
    } else {
      if (narrow) p[2] = std::max(low, p[1]);
      p[3] = std::max({narrow ? high : std::max(p[3], high), p[2]});
    }
    return true;
  }

  const ForceModel& model_;
  const fuzzy::Variable& input_;
  double step_width_;
  double low_;
  double high_;
  std::vector<Flank> flanks_;
};

}  // namespace

std::vector<std::pair<std::string, Result<Edit>>> widenStep(const ForceModel& model,
                                                            std::span<const std::size_t> experts, bool of_mean,
                                                            const StepBetween& step, const std::stop_token& stop) {
  std::vector<std::pair<std::string, Result<Edit>>> out;
  const fuzzy::Variable& input = model.inputs[step.input];
  const double unit_width = analysis::stepWidth(input);
  const auto limits = elicitation::forceStepLimits(model);
  /// Whether these experts still have a step around the old one, at some setting of the other inputs.
  const auto is_left = [&](const Edit& edit, double around) {
    auto all = analysis::forceStepsAlong(edit.model, edit.compiled, step.input, step.from, limits);
    analysis::ForceProbe probe(edit.model, edit.compiled, kStepAllowance, stop);
    const auto further = analysis::forceSteps(probe, limits, kStepAllowance / (2 * probe.costOfMean()), step.input);
    all.insert(all.end(), further.begin(), further.end());
    return std::any_of(all.begin(), all.end(), [&](const analysis::ForceStep& one) {
      const bool theirs =
          of_mean ? !one.expert : one.expert && std::find(experts.begin(), experts.end(), *one.expert) != experts.end();
      return theirs && one.to[step.input] >= step.from[step.input] - around &&
             one.from[step.input] <= step.to[step.input] + around;
    });
  };
  const Widening widening(model, experts, step);
  for (const double times : kWidths) {
    const double width = times * unit_width;
    if (stop.stop_requested()) break;
    auto edit = widening.to(width);
    if (!edit || !*edit) continue;
    const bool settles = !is_left(**edit, width);
    if (!settles && times != kWidths[0]) continue;
    out.emplace_back("Widen to " + quantityText(input, width), std::move(*edit));
    if (settles) break;
  }
  return out;
}

}  // namespace tactus::editing
