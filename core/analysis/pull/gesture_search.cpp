#include "core/analysis/pull/gesture_search.h"

#include <algorithm>

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

}  // namespace tactus::analysis
