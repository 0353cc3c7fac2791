#include "core/analysis/pull/force_search.h"

#include <algorithm>
#include <cmath>

#include "core/analysis/directions.h"
#include "core/fuzzy/force_model.h"

namespace tactus::analysis {
namespace {

using fuzzy::MembershipFunction;
using fuzzy::Shape;
using fuzzy::Term;

constexpr double kNarrowestSigma = 1e-4;  // of the universe, as in the editor
constexpr double kWidestSigma = 10;

/// How far a vertex can go between its neighbors and the ends of the universe.
DeltaRange vertexDeltas(const fuzzy::Variable& variable, const Term& term, std::size_t vertex) {
  const double universe = variable.max - variable.min;
  const auto& points = term.points;
  double low = variable.min;
  double high = variable.max;
  if (term.shape == Shape::kGaussian) {
    if (vertex == 1) low = kNarrowestSigma * universe, high = kWidestSigma * universe;
  } else {
    if (vertex > 0) low = points[vertex - 1];
    if (vertex + 1 < points.size()) high = points[vertex + 1];
  }
  return {std::min(low - points[vertex], 0.0), std::max(high - points[vertex], 0.0)};
}

/// The force after `edit` with another delta, at the point.
class EditedForce {
 public:
  EditedForce(const PointForce& point, const PulledList& list)
      : point_(point), list_(list), terms_(termsOf(point.model(), list)), readers_(readersOf(point.model(), list)) {
    if (list.variable < point.model().inputs.size()) probe_.emplace(point, list);
    ramps_ = rampsOf(variableAt(point.model(), list.variable), terms_);
  }

  const std::optional<Ramps>& ramps() const { return ramps_; }
  const MembershipProbe& probe() const { return *probe_; }
  bool ofInput() const { return probe_.has_value(); }
  double at() const { return point_.at(list_.variable); }

  std::optional<double> operator()(const PullEdit& edit, double delta) const {
    if (probe_ && ramps_) return probe_->force(membershipsAt(moved(*ramps_, edit.gesture, edit.place, delta), at()));
    std::vector<Term> terms = terms_;
    if (edit.gesture == Gesture::kVertex) {
      terms[edit.place].points[edit.vertex] += delta;
    } else {
      writeRamps(*ramps_, moved(*ramps_, edit.gesture, edit.place, delta), terms);
    }
    if (!probe_) {
      std::vector<MembershipFunction> words;
      words.reserve(terms.size());
      for (const Term& term : terms) words.push_back(MembershipFunction::of(term));
      return point_.withWords(readers_, words);
    }
    std::vector<double> memberships;
    memberships.reserve(terms.size());
    for (const Term& term : terms) memberships.push_back(MembershipFunction::of(term)(at()));
    return probe_->force(memberships);
  }

  /// Whether the gesture changes a word that some reader has active.
  bool changesAnActiveWord(const PullEdit& edit) const {
    const auto active = [&](std::size_t term) {
      return std::any_of(readers_.begin(), readers_.end(),
                         [&](std::size_t e) { return point_.experts()[e].strengths[term] > 0; });
    };
    if (edit.gesture == Gesture::kVertex) return active(edit.place);
    const bool of_term = edit.gesture == Gesture::kMove || edit.gesture == Gesture::kWiden;
    for (std::size_t t = edit.place - (of_term ? 1 : 0); t <= edit.place + 1; ++t) {
      if (active(ramps_->order[t])) return true;
    }
    return false;
  }

 private:
  const PointForce& point_;
  PulledList list_;
  const std::vector<Term>& terms_;
  std::vector<std::size_t> readers_;
  std::optional<MembershipProbe> probe_;
  std::optional<Ramps> ramps_;
};

/// F(u) of ramp `ramp`, and what it means for each gesture.
void searchRamp(const EditedForce& edited, std::size_t ramp, std::span<const double> shares, double target_n,
                std::vector<SearchedGesture>& gestures) {
  const Ramps& ramps = *edited.ramps();
  std::vector<double> memberships(ramps.order.size(), 0);
  const ForceAt force = [&](double share) {
    memberships[ramps.order[ramp]] = share;
    memberships[ramps.order[ramp + 1]] = 1 - share;
    return edited.probe().force(memberships);
  };
  std::vector<ForcePoint> stretch;
  std::vector<double> roots;
  const auto tell = [&](double share, std::optional<double> force_n) {
    for (SearchedGesture& one : gestures) {
      const auto delta = deltaFor(ramps, {one.edit.gesture, one.edit.place}, ramp, share, edited.at());
      if (!delta || !one.range.holds(*delta)) continue;
      if (force_n) {
        one.reach.look(*delta, *force_n, target_n);
      } else {
        one.reach.meets(*delta, target_n);
      }
    }
  };
  const auto finish = [&] {
    const auto found = crossings(stretch, force, target_n);
    roots.insert(roots.end(), found.begin(), found.end());
    stretch.clear();
  };
  for (const double share : shares) {
    if (const auto there = force(share)) {
      tell(share, there);
      stretch.push_back({share, *there});
    } else {
      finish();
    }
  }
  finish();
  for (const double root : roots) tell(root, std::nullopt);
}

void searchRamps(const EditedForce& edited, double target_n, std::vector<SearchedGesture>& gestures) {
  std::vector<double> shares = edited.probe().bends();
  for (int i = 0; i <= kSteps; ++i) shares.push_back(static_cast<double>(i) / kSteps);
  std::sort(shares.begin(), shares.end());
  shares.erase(std::unique(shares.begin(), shares.end()), shares.end());
  for (std::size_t r = 0; r < edited.ramps()->p.size(); ++r) {
    const bool reached = std::any_of(gestures.begin(), gestures.end(), [&](const SearchedGesture& one) {
      const auto low = moved(*edited.ramps(), one.edit.gesture, one.edit.place, one.range.low);
      const auto high = moved(*edited.ramps(), one.edit.gesture, one.edit.place, one.range.high);
      return std::min(low.p[r], high.p[r]) < edited.at() && std::max(low.q[r], high.q[r]) > edited.at();
    });
    if (reached) searchRamp(edited, r, shares, target_n, gestures);
  }
  for (SearchedGesture& one : gestures) {
    for (const double delta : {0.0, one.range.low, one.range.high}) {
      if (const auto there = edited(one.edit, delta)) one.reach.look(delta, *there, target_n);
    }
  }
}

}  // namespace

std::vector<SearchedGesture> gesturesOfList(const fuzzy::ForceModel& model, const PulledList& list) {
  const fuzzy::Variable& variable = variableAt(model, list.variable);
  const std::vector<Term>& terms = termsOf(model, list);
  std::vector<SearchedGesture> out;
  if (const auto ramps = rampsOf(variable, terms)) {
    for (const GesturePlace& one : gesturesOf(*ramps)) {
      out.push_back({termEdit(one.gesture, list, one.place), allowedDeltas(*ramps, one.gesture, one.place), {}});
    }
    return out;
  }
  for (std::size_t t = 0; t < terms.size(); ++t) {
    for (std::size_t v = 0; v < terms[t].points.size(); ++v) {
      out.push_back({termEdit(Gesture::kVertex, list, t, v), vertexDeltas(variable, terms[t], v), {}});
    }
  }
  return out;
}

std::vector<SearchedGesture> searchList(const PointForce& point, const PulledList& list, double target_n) {
  const EditedForce edited(point, list);
  std::vector<SearchedGesture> gestures = gesturesOfList(point.model(), list);
  if (edited.ofInput() && edited.ramps()) {
    searchRamps(edited, target_n, gestures);
    return gestures;
  }
  if (!edited.ofInput())
    std::erase_if(gestures, [&](const auto& one) { return !edited.changesAnActiveWord(one.edit); });
  for (SearchedGesture& one : gestures) {
    std::vector<double> bends;
    if (edited.ofInput() && one.edit.vertex < termsOf(point.model(), list)[one.edit.place].points.size()) {
      bends.push_back(edited.at() - termsOf(point.model(), list)[one.edit.place].points[one.edit.vertex]);
    }
    one.reach = searchDeltas(
        one.range, [&](double delta) { return edited(one.edit, delta); }, target_n, bends);
  }
  return gestures;
}

std::vector<PulledList> listsOf(const fuzzy::ForceModel& model, bool shared_only) {
  std::vector<PulledList> out;
  for (std::size_t v = 0; v <= model.inputs.size(); ++v) {
    if (!readersOf(model, {v, {}}).empty()) out.push_back({v, {}});
    if (shared_only) continue;
    for (const auto& expert : model.experts) {
      for (const auto& own : expert.overrides) {
        if (own.variable == variableAt(model, v).id) out.push_back({v, expert.id});
      }
    }
  }
  return out;
}

namespace {

using fuzzy::Condition;
using fuzzy::Expert;
using fuzzy::ForceModel;
using fuzzy::Rule;

bool sameConditions(const Rule& one, const Rule& other) {
  return one.conditions.size() == other.conditions.size() &&
         std::is_permutation(one.conditions.begin(), one.conditions.end(), other.conditions.begin());
}

PullEdit wordEdit(const Expert& expert, std::size_t rule, const std::vector<fuzzy::Term>& words, const TermOrder& order,
                  std::size_t word) {
  const auto placeOf = [&](std::size_t w) {
    return static_cast<double>(std::find(order.begin(), order.end(), w) - order.begin());
  };
  const auto now = static_cast<std::size_t>(findTerm(words, expert.rules[rule].then) - words.data());
  return ruleEdit(Gesture::kWord, expert.id, rule, placeOf(word) - placeOf(now), words[word].id);
}

/// The words that rule number `rule` could have, as edits.
std::vector<PullEdit> wordEdits(const ForceModel& model, const Expert& expert, std::size_t rule) {
  const auto& words = termsFor(expert, model.output);
  const TermOrder order = byMiddleOfCore(words);
  std::vector<PullEdit> out;
  for (std::size_t word = 0; word < words.size(); ++word) {
    if (words[word].id == expert.rules[rule].then) continue;
    const bool twice = std::any_of(expert.rules.begin(), expert.rules.end(), [&](const Rule& other) {
      return other.then == words[word].id && sameConditions(other, expert.rules[rule]);
    });
    if (!twice) out.push_back(wordEdit(expert, rule, words, order, word));
  }
  return out;
}

}  // namespace

std::size_t stepsAgainstDirection(const ForceModel& model, std::size_t expert) {
  std::size_t steps = 0;
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    steps += direction(model, model.experts[expert], i).steps_against.size();
  }
  return steps;
}

std::vector<PullEdit> ruleEdits(const ForceModel& model, std::size_t expert) {
  const Expert& one = model.experts[expert];
  std::vector<PullEdit> out;
  for (std::size_t r = 0; r < one.rules.size(); ++r) {
    if (!fuzzy::takesPart(one.rules[r])) continue;
    const auto words = wordEdits(model, one, r);
    out.insert(out.end(), words.begin(), words.end());
    out.push_back(ruleEdit(Gesture::kOff, one.id, r));
  }
  return out;
}

std::vector<SearchedRule> searchRules(const PointForce& point, std::size_t expert, double target_n) {
  const ForceModel& model = point.model();
  const Expert& one = model.experts[expert];
  const auto& words = termsFor(one, model.output);
  const auto& rules = point.experts()[expert].rules;
  // What fires less than this part of the strongest word moves nothing beyond rounding, whatever becomes of it: most
  // rules where the terms are Gaussian.
  constexpr double kTooWeak = 1e-15;
  const auto& strengths = point.experts()[expert].strengths;
  const double strongest = strengths.empty() ? 0 : *std::max_element(strengths.begin(), strengths.end());
  std::vector<SearchedRule> out;
  for (std::size_t r = 0; r < rules.size(); ++r) {
    const PointRule& rule = rules[r];
    if (rule.membership <= kTooWeak * strongest) continue;
    for (PullEdit& edit : wordEdits(model, one, rule.index)) {
      const auto then = static_cast<std::size_t>(findTerm(words, edit.then) - words.data());
      const auto there = point.withRule(expert, r, then, rule.weight);
      if (there) out.push_back({std::move(edit), *there});
    }
    if (const auto there = point.withRule(expert, r, rule.then, 0)) {
      out.push_back({ruleEdit(Gesture::kOff, one.id, rule.index), *there});
    }
    std::vector<double> bends;
    for (const double strength : point.experts()[expert].strengths) {
      bends.push_back(strength / rule.membership - rule.weight);
    }
    const auto reach = searchDeltas(
        {-rule.weight, 1 - rule.weight},
        [&](double delta) { return point.withRule(expert, r, rule.then, rule.weight + delta); }, target_n, bends);
    const double weight = rule.weight + reach.exact.value_or(0);
    if (reach.exact && *reach.exact != 0 && weight > 0) {
      out.push_back({ruleEdit(Gesture::kWeight, one.id, rule.index, *reach.exact), target_n});
    }
  }
  return out;
}

namespace {

constexpr double kSameForce = 1e-13;  // relative to the size of the force and 1 N: rounding of a centroid
constexpr double kNoJump = 1e-9;      // between two neighboring numbers, where the force is steep but continuous
constexpr int kMostHalvings = 200;

bool isSame(double force_n, double target_n) {
  return std::abs(force_n - target_n) <= kSameForce * std::max(1.0, std::abs(target_n));
}

/// The root between two points on different sides of the target: false position with halved weights (Illinois; Dowell
/// and Jarratt 1971), with a halving in between. Nothing if the bracket closes on a jump or a hole.
std::optional<double> rootBetween(ForcePoint low, ForcePoint high, const ForceAt& force, double target_n) {
  double low_weight = 1;
  double high_weight = 1;
  for (int i = 0; i < kMostHalvings; ++i) {
    const double low_gap = (low.force_n - target_n) * low_weight;
    const double high_gap = (high.force_n - target_n) * high_weight;
    double x = (low.at * high_gap - high.at * low_gap) / (high_gap - low_gap);
    if (i % 4 == 3 || !(x > low.at && x < high.at)) x = low.at + (high.at - low.at) / 2;
    if (x <= low.at || x >= high.at) break;
    const auto there = force(x);
    if (!there) return std::nullopt;
    if (isSame(*there, target_n)) return x;
    if ((*there < target_n) == (low.force_n < target_n)) {
      low = {x, *there};
      low_weight = 1;
      high_weight /= 2;
    } else {
      high = {x, *there};
      high_weight = 1;
      low_weight /= 2;
    }
  }
  const ForcePoint& closer = std::abs(low.force_n - target_n) < std::abs(high.force_n - target_n) ? low : high;
  const bool meets = std::abs(closer.force_n - target_n) <= kNoJump * std::max(1.0, std::abs(target_n));
  return meets ? std::optional(closer.at) : std::nullopt;
}

}  // namespace

void Reach::look(double delta, double force_n, double target_n) {
  if (!nearest) min_n = max_n = force_n;
  min_n = std::min(min_n, force_n);
  max_n = std::max(max_n, force_n);
  const double off = std::abs(force_n - target_n);
  const double best = nearest ? std::abs(nearest->force_n - target_n) : off;
  if (!nearest || off < best || (off == best && std::abs(delta) < std::abs(nearest->at))) nearest = {delta, force_n};
  if (isSame(force_n, target_n)) meets(delta, target_n);
}

void Reach::meets(double delta, double target_n) {
  if (!nearest) min_n = max_n = target_n;
  min_n = std::min(min_n, target_n);
  max_n = std::max(max_n, target_n);
  if (exact && std::abs(*exact) <= std::abs(delta)) return;
  exact = delta;
  nearest = {delta, target_n};
}

std::vector<double> crossings(std::span<const ForcePoint> points, const ForceAt& force, double target_n) {
  std::vector<double> out;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (isSame(points[k].force_n, target_n)) {
      out.push_back(points[k].at);
    } else if (k > 0 && !isSame(points[k - 1].force_n, target_n) &&
               (points[k - 1].force_n < target_n) != (points[k].force_n < target_n)) {
      if (const auto root = rootBetween(points[k - 1], points[k], force, target_n)) out.push_back(*root);
    }
  }
  return out;
}

Reach searchDeltas(const DeltaRange& range, const ForceAt& force, double target_n, std::span<const double> bends) {
  std::vector<double> places = {0};
  for (const double end : {range.low, range.high}) {
    for (int i = 1; i <= kSteps && end != 0; ++i) places.push_back(i == kSteps ? end : end * i / kSteps);
  }
  for (const double bend : bends) {
    if (range.holds(bend)) places.push_back(bend);
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());

  Reach reach;
  std::vector<ForcePoint> stretch;  // without a hole
  const auto finish = [&] {
    for (const double root : crossings(stretch, force, target_n)) reach.meets(root, target_n);
    stretch.clear();
  };
  for (const double place : places) {
    if (const auto there = force(place)) {
      reach.look(place, *there, target_n);
      stretch.push_back({place, *there});
    } else {
      finish();
    }
  }
  finish();
  return reach;
}

}  // namespace tactus::analysis
