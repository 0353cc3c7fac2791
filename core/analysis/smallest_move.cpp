#include "core/analysis/smallest_move.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/fuzzy/membership.h"

namespace tactus::analysis {
namespace {

constexpr int kHalvings = 60;  // to the last digit of a double
// A polynomial of 7 Chebyshev-Lobatto nodes leaves the range of its values there by at most this share of it.
constexpr double kOvershoot = 0.55;
constexpr double kUncertain = 1e-7;  // what lies this near below a limit is looked at exactly
constexpr double kShort = 1e-3;      // a stretch on which an excess varies less is short
constexpr double kFlat = 1e-9;       // what varies less is looked at as a whole
constexpr double kNarrow = 1e-11;    // of the universe: the same
constexpr double kOnePoint = 1e-10;  // of the universe: a hole that is passed

void addEdges(const std::vector<fuzzy::Term>& terms, std::vector<double>& edges) {
  for (const fuzzy::Term& term : terms) {
    const auto f = fuzzy::MembershipFunction::of(term);
    if (f.gaussian) continue;
    if (f.a == f.b) edges.push_back(f.a);
    if (f.c == f.d) edges.push_back(f.d);
  }
}

}  // namespace

MeanLine::MeanLine(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled, std::size_t input,
                   std::span<const double> point, std::span<const std::size_t> experts) {
  for (const fuzzy::Term& term : model.output.terms) words_.push_back(term.id);
  for (const std::size_t expert : experts) {
    Seat seat{ExpertLine(model, expert, input, point), compiled.normalizedWeight(expert), {0}, 0};
    for (const fuzzy::Term& term : termsFor(model.experts[expert], model.output)) {
      const auto word = std::find(words_.begin(), words_.end(), term.id);
      seat.place.push_back(1 + static_cast<std::size_t>(word - words_.begin()));
      if (word == words_.end()) words_.push_back(term.id);
    }
    for (const auto& piece : seat.line.pieces()) places_.insert(places_.end(), {piece.from, piece.to});
    seats_.push_back(std::move(seat));
    addEdges(termsFor(model.experts[expert], model.inputs[input]), edges_);
  }
  sortOnce(places_);
  sortOnce(edges_);
}

std::vector<double> MeanLine::at(double x) const {
  std::vector<double> sums(1 + words_.size(), 0);
  std::vector<double> own;
  double weights = 0;
  for (const Seat& seat : seats_) {
    own.resize(seat.line.valueCount());
    if (!seat.line.at(x, own)) continue;
    weights += seat.weight;
    for (std::size_t v = 0; v < own.size(); ++v) sums[seat.place[v]] += seat.weight * own[v];
  }
  if (weights == 0) return {};
  for (double& sum : sums) sum /= weights;
  return sums;
}

bool MeanLine::enter(double x) {
  double weights = 0;
  constants_.assign(1 + words_.size(), 0);
  slopes_.assign(1 + words_.size(), 0);
  moving_.clear();
  for (Seat& seat : seats_) {
    const auto& pieces = seat.line.pieces();
    while (seat.piece + 1 < pieces.size() && pieces[seat.piece].to < x) ++seat.piece;
    while (seat.piece > 0 && pieces[seat.piece].from > x) --seat.piece;
    const auto& piece = pieces[seat.piece];
    if (!piece.fires) continue;
    weights += seat.weight;
    if (!piece.constant) {
      moving_.push_back({&piece, &seat});
      for (std::size_t v = 0; v < seat.place.size(); ++v) slopes_[seat.place[v]] += seat.weight * piece.steepest[v];
      continue;
    }
    for (std::size_t v = 0; v < seat.place.size(); ++v) {
      constants_[seat.place[v]] += seat.weight * piece.coefficients[v];
    }
  }
  weights_ = weights;
  if (weights == 0) return false;
  for (double& slope : slopes_) slope /= weights;
  return true;
}
void MeanLine::polynomialsAt(double x, bool force_only, std::span<double> sums) const {
  std::copy_n(constants_.begin(), force_only ? 1 : sums.size(), sums.begin());
  for (const auto& [piece, seat] : moving_) {
    const double place = piece->place(x);
    const std::size_t count = force_only ? 1 : seat->place.size();
    for (std::size_t v = 0; v < count; ++v) sums[seat->place[v]] += seat->weight * piece->at(v, place);
  }
  for (double& sum : sums) sum /= weights_;
}

std::optional<double> MoveSearch::nearest(double now) {
  const double all = std::numeric_limits<double>::infinity();
  const auto up = along(now, true, all);
  const auto down = along(now, false, up ? *up - now : all);
  if (up && down) return *up - now <= now - *down ? up : down;
  return up ? up : down;
}

/// In one direction up to a hole, or to the distance `most`.
std::optional<double> MoveSearch::along(double now, bool upward, double most) {
  std::vector<double> stops = {now};
  for (const double x : line_.places()) {
    if (upward ? x > now : x < now) stops.push_back(x);
  }
  if (!upward) std::reverse(stops.begin() + 1, stops.end());
  before_ = now;
  for (std::size_t i = 1; i < stops.size() && std::abs(stops[i - 1] - now) <= most; ++i) {
    if (!line_.enter(stops[i - 1] + (stops[i] - stops[i - 1]) / 2)) {
      if (std::abs(stops[i] - stops[i - 1]) > kOnePoint * line_.width()) return std::nullopt;
      continue;
    }
    if (isWithinReach(stops[i - 1], stops[i])) {
      if (const auto found = firstWithin(stops[i - 1], stops[i])) return found;
    }
    const auto& edges = line_.edges();
    if (std::binary_search(edges.begin(), edges.end(), stops[i])) {
      if (change_.happened(stops[i])) return halved(stops[i]);
    }
  }
  return std::nullopt;
}

std::optional<double> MoveSearch::firstWithin(double near, double far) {
  if (!comesNear(near, far)) return std::nullopt;
  if (const auto found = onlyCrossing(near, far)) return found;
  const double middle = near + (far - near) / 2;
  const bool leaf =
      varies_ <= kFlat || std::abs(far - near) <= kNarrow * line_.width() || middle == near || middle == far;
  const std::size_t looks = leaf ? kNodes : nearest_ >= -kUncertain ? 1 : 0;
  for (std::size_t node = 0; node < looks; ++node) {
    const double x = nodeAt(near, far, node);
    if (change_.happened(x)) return node == 0 ? halvedFrom(near, x) : halved(x);
    before_ = x;
  }
  if (leaf) return std::nullopt;
  if (const auto found = firstWithin(near, middle)) return found;
  return firstWithin(middle, far);
}

/// Where one excess alone rises through 0 in a short stretch: the place, without more branches. Else nothing.
std::optional<double> MoveSearch::onlyCrossing(double near, double far) {
  if (candidates_ != 1 || varies_ > kShort) return std::nullopt;
  std::size_t below = 0;
  std::size_t above = kNodes;
  double last = -std::numeric_limits<double>::infinity();
  for (std::size_t node = 0; node < kNodes; ++node) {
    const double excess = at_nodes_[node * excesses_.size() + candidate_];
    if (excess <= last) return std::nullopt;
    if (excess < -kUncertain) below = node;
    if (excess > kUncertain && above == kNodes) above = node;
    last = excess;
  }
  if (at_nodes_[candidate_] >= -kUncertain || above == kNodes) return std::nullopt;
  const double after = nodeAt(near, far, above);
  const double before = nodeAt(near, far, below);
  if (!change_.happened(after) || change_.happened(before)) return std::nullopt;
  before_ = before;
  return halved(after);
}

/// False where the slopes are too small for an excess to reach 0: so most of the short pieces of many experts end.
bool MoveSearch::isWithinReach(double near, double far) {
  prepare();
  line_.polynomialsAt(near + (far - near) / 2, change_.forceOnly(), values_);
  change_.excesses(values_, excesses_);
  change_.excessSlopes(line_.slopes(), highest_);
  const double most = std::abs(far - near) / 2;
  for (std::size_t e = 0; e < excesses_.size(); ++e) {
    if (excesses_[e] + most * highest_[e] >= -kUncertain) return true;
  }
  return false;
}

void MoveSearch::prepare() {
  const std::size_t count = change_.excessCount();
  values_.resize(1 + line_.words().size());
  excesses_.resize(count);
  highest_.assign(count, -std::numeric_limits<double>::infinity());
  lowest_.assign(count, std::numeric_limits<double>::infinity());
}

/// Whether an excess may reach 0; then `varies_` says how much those vary.
bool MoveSearch::comesNear(double near, double far) {
  prepare();
  const std::size_t count = excesses_.size();
  at_nodes_.resize(kNodes * count);
  for (std::size_t node = 0; node < kNodes; ++node) {
    line_.polynomialsAt(nodeAt(near, far, node), change_.forceOnly(), values_);
    change_.excesses(values_, excesses_);
    if (node == 0) nearest_ = *std::max_element(excesses_.begin(), excesses_.end());
    std::copy(excesses_.begin(), excesses_.end(), at_nodes_.begin() + static_cast<std::ptrdiff_t>(node * count));
    for (std::size_t e = 0; e < count; ++e) {
      highest_[e] = std::max(highest_[e], excesses_[e]);
      lowest_[e] = std::min(lowest_[e], excesses_[e]);
    }
  }
  candidates_ = 0;
  varies_ = 0;
  for (std::size_t e = 0; e < count; ++e) {
    const double spread = highest_[e] - lowest_[e];
    if (highest_[e] + kOvershoot * spread < -kUncertain) continue;
    ++candidates_;
    candidate_ = e;
    varies_ = std::max(varies_, spread);
  }
  return candidates_ > 0;
}

/// The same as `halved`, where it is likely that nothing has happened at `near` or just before it.
double MoveSearch::halvedFrom(double near, double after) {
  for (const double place : {near, near - (after - near)}) {
    if (std::abs(after - place) >= std::abs(after - before_)) break;
    if (!change_.happened(place)) {
      before_ = place;
      break;
    }
    after = place;
  }
  return halved(after);
}

/// The first place after `before_` at which the change has happened; at `after` it has.
double MoveSearch::halved(double after) const {
  double before = before_;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = before + (after - before) / 2;
    if (middle == before || middle == after) break;
    (change_.happened(middle) ? after : before) = middle;
  }
  return after;
}

}  // namespace tactus::analysis
