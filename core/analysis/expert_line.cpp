#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "core/analysis/smallest_move.h"
#include "core/fuzzy/centroid.h"
#include "core/fuzzy/force_model.h"
#include "core/fuzzy/gaussian_pieces.h"
#include "core/fuzzy/membership.h"

namespace tactus::analysis {
namespace {

using fuzzy::CurvePiece;
using fuzzy::MembershipFunction;

constexpr std::size_t kNoTerm = std::numeric_limits<std::size_t>::max();
constexpr double kStrengthScale = 0x1p512;  // keeps the digits of small memberships and products
constexpr double kLeastStrength = std::numeric_limits<double>::denorm_min();
constexpr double kLeastWidth = 1e-10;  // of the universe: bends nearer to each other are one
constexpr double kCloseEnough = 1e-8;  // of a polynomial
constexpr int kMostHalvings = 14;

constexpr double kCubicTrial = 0.2;
constexpr double kTrials[] = {-0.95, 0.3, 0.7};  // places between the nodes where a polynomial is tried

/// What `f` is between the neighboring corners `from` and `to`, times `weight`; nothing where it is 0.
std::optional<CurvePiece> pieceOf(const MembershipFunction& f, const fuzzy::Support& support, double weight,
                                  double from, double to) {
  const double middle = from + (to - from) / 2;
  if (middle <= support.low || middle >= support.high) return std::nullopt;
  if (f.gaussian) return CurvePiece{true, 0, 0, 0, f.mean, f.sigma, std::log(weight)};
  double start = 1;
  double slope = 0;
  if (middle < f.b) {
    slope = 1 / (f.b - f.a);
    start = (from - f.a) * slope;
  } else if (middle > f.c) {
    slope = -1 / (f.d - f.c);
    start = (from - f.d) * slope;
  }
  return CurvePiece{false, from, weight * start, weight * slope, 0, 1, 0};
}

/// The force and the shares of slices.
void toValues(std::span<const fuzzy::AreaAndMoment> slices, std::span<double> values) {
  fuzzy::AreaAndMoment sum;
  for (const auto& slice : slices) sum.area += slice.area, sum.moment += slice.moment;
  if (!(sum.area > 0)) sum.area = 1;  // sets narrower than any number tells: all at one place, without a share
  values[0] = sum.moment / sum.area;
  for (std::size_t t = 0; t < slices.size(); ++t) values[1 + t] = slices[t].area / sum.area;
}

}  // namespace

void sortOnce(std::vector<double>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

ExpertLine::ExpertLine(const fuzzy::ForceModel& model, std::size_t expert, std::size_t input,
                       std::span<const double> point)
    : implication_(model.implication),
      lo_(model.output.min),
      hi_(model.output.max),
      min_(model.inputs[input].min),
      max_(model.inputs[input].max) {
  const fuzzy::Expert& one = model.experts[expert];
  for (const fuzzy::Term& term : termsFor(one, model.inputs[input])) terms_.push_back(MembershipFunction::of(term));
  for (const fuzzy::Term& term : termsFor(one, model.output)) functions_.push_back(MembershipFunction::of(term));
  const auto is_trapezoid = [](const MembershipFunction& f) { return !f.gaussian; };
  cubic_slices_ = implication_ == fuzzy::Implication::kClip && std::ranges::all_of(terms_, is_trapezoid) &&
                  std::ranges::all_of(functions_, is_trapezoid);
  addRules(model, one, input, point);
  const std::vector<double> places = bends();
  for (std::size_t i = 1; i < places.size(); ++i) addPieces(places[i - 1], places[i], 0);
}

void ExpertLine::addRules(const fuzzy::ForceModel& model, const fuzzy::Expert& expert, std::size_t input,
                          std::span<const double> point) {
  // The memberships of the other inputs, once.
  std::vector<std::vector<double>> memberships(model.inputs.size());
  for (std::size_t i = 0; i < model.inputs.size(); ++i) {
    if (i == input) continue;
    for (const fuzzy::Term& term : termsFor(expert, model.inputs[i])) {
      memberships[i].push_back(MembershipFunction::of(term).scaled(point[i], kStrengthScale));
    }
  }
  const std::vector<fuzzy::Term>& output = termsFor(expert, model.output);
  for (const fuzzy::Rule& rule : expert.rules) {
    if (!fuzzy::takesPart(rule)) continue;
    LineRule line{kNoTerm, static_cast<std::size_t>(findTerm(output, rule.then) - output.data()), rule.weight,
                  kStrengthScale};
    for (const fuzzy::Condition& condition : rule.conditions) {
      std::size_t i = 0;
      while (model.inputs[i].id != condition.input) ++i;
      const std::vector<fuzzy::Term>& list = termsFor(expert, model.inputs[i]);
      const auto term = static_cast<std::size_t>(findTerm(list, condition.term) - list.data());
      if (i == input) {
        line.term = term;
      } else {
        line.ceiling = std::min(line.ceiling, memberships[i][term]);
      }
    }
    if (line.ceiling == 0) continue;
    // A rule that another one covers everywhere changes nothing.
    const auto covers = [](const LineRule& a, const LineRule& b) {
      return a.term == b.term && a.then == b.then && a.weight >= b.weight && a.ceiling >= b.ceiling;
    };
    if (std::any_of(rules_.begin(), rules_.end(), [&](const LineRule& other) { return covers(other, line); })) continue;
    std::erase_if(rules_, [&](const LineRule& other) { return covers(line, other); });
    rules_.push_back(line);
  }
}

void ExpertLine::strengthsAt(double x, std::span<double> strengths) const {
  std::array<double, fuzzy::kMostTerms> memberships;
  for (std::size_t t = 0; t < terms_.size(); ++t) memberships[t] = terms_[t].scaled(x, kStrengthScale);
  std::fill(strengths.begin(), strengths.end(), 0.0);
  for (const LineRule& rule : rules_) {
    const double membership = rule.term == kNoTerm ? rule.ceiling : std::min(rule.ceiling, memberships[rule.term]);
    if (membership == 0) continue;
    strengths[rule.then] = std::max(strengths[rule.then], std::max(rule.weight * membership, kLeastStrength));
  }
}

bool ExpertLine::at(double x, std::span<double> values) const {
  std::array<double, fuzzy::kMostTerms> room;
  const std::span<double> strengths(room.data(), functions_.size());
  strengthsAt(x, strengths);
  return valuesOf(strengths, values);
}

bool ExpertLine::valuesOf(std::span<const double> strengths, std::span<double> values) const {
  std::array<fuzzy::AreaAndMoment, fuzzy::kMostTerms> slices;
  std::fill(values.begin(), values.end(), 0.0);
  if (slicesOf(strengths, slices) == 0) return false;
  toValues(std::span(slices).first(functions_.size()), values);
  return true;
}

/// The slices relative to the largest strength, which is returned.
double ExpertLine::slicesOf(std::span<const double> strengths, std::span<fuzzy::AreaAndMoment> slices) const {
  const double largest = *std::max_element(strengths.begin(), strengths.end());
  if (largest == 0) return 0;
  std::array<fuzzy::ActiveTerm, fuzzy::kMostTerms> active;
  std::array<std::size_t, fuzzy::kMostTerms> number;
  std::array<fuzzy::AreaAndMoment, fuzzy::kMostTerms> found;
  std::size_t count = 0;
  for (std::size_t t = 0; t < strengths.size(); ++t) {
    slices[t] = {};
    if (strengths[t] == 0) continue;
    number[count] = t;
    active[count++] = {&functions_[t], std::max(strengths[t] / kStrengthScale, kLeastStrength),
                       std::max(strengths[t] / largest, kLeastStrength)};
  }
  fuzzy::sliceMoments({active.data(), count}, implication_, lo_, hi_, {found.data(), count});
  for (std::size_t i = 0; i < count; ++i) slices[number[i]] = found[i];
  return largest;
}

/// The heights at which two output terms cross, and those that one has at a vertex of another. Where a clipped strength
/// passes one of them the values bend, if only a little.
void ExpertLine::addHeights(std::vector<double>& levels) const {
  std::vector<double> corners = {lo_, hi_};
  for (const MembershipFunction& f : functions_) {
    if (!f.gaussian) corners.insert(corners.end(), {f.a, f.b, f.c, f.d});
  }
  std::erase_if(corners, [&](double x) { return x < lo_ || x > hi_; });
  sortOnce(corners);
  for (const double x : corners) {
    for (const MembershipFunction& f : functions_) levels.push_back(f(x));
  }
  for (const MembershipFunction& f : functions_) {
    if (!f.gaussian) continue;
    for (const double x : {f.mean - f.sigma, f.mean, f.mean + f.sigma}) {
      if (x > lo_ && x < hi_) corners.push_back(x);
    }
  }
  sortOnce(corners);
  std::vector<CurvePiece> curves;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    curves.clear();
    for (const MembershipFunction& f : functions_) {
      const double reach = fuzzy::kGaussianReach * f.sigma;
      const fuzzy::Support support = f.gaussian ? fuzzy::Support{f.mean - reach, f.mean + reach} : supportOf(f);
      const auto piece = pieceOf(f, support, 1, corners[i - 1], corners[i]);
      if (piece) curves.push_back(*piece);
    }
    for (std::size_t one = 0; one < curves.size(); ++one) {
      for (std::size_t other = one + 1; other < curves.size(); ++other) {
        std::array<double, 2> found;
        const double* const end =
            fuzzy::writeCrossings(curves[one], curves[other], corners[i - 1], corners[i], found.data());
        for (const double* x = found.data(); x != end; ++x) levels.push_back(curves[one].at(*x));
      }
    }
  }
}

std::vector<double> ExpertLine::bends() const {
  std::vector<double> corners = {min_, max_};
  std::vector<fuzzy::Support> supports;
  for (const MembershipFunction& f : terms_) {
    const fuzzy::Support& support = supports.emplace_back(fuzzy::supportOf(f));
    corners.insert(corners.end(), {support.low, support.high});
    if (f.gaussian) {
      corners.insert(corners.end(), {f.mean - f.sigma, f.mean, f.mean + f.sigma});  // the inflections
    } else {
      corners.insert(corners.end(), {f.b, f.c});
    }
  }
  sortOnce(corners);
  std::erase_if(corners, [&](double x) { return x < min_ || x > max_; });

  // Each weighted membership once, and each height at which another condition caps one.
  std::vector<std::pair<std::size_t, double>> flanks;
  std::vector<double> levels;
  for (const LineRule& rule : rules_) {
    if (rule.term != kNoTerm) flanks.emplace_back(rule.term, rule.weight);
    levels.push_back(rule.weight * (rule.ceiling / kStrengthScale));
  }
  std::sort(flanks.begin(), flanks.end());
  flanks.erase(std::unique(flanks.begin(), flanks.end()), flanks.end());
  if (implication_ == fuzzy::Implication::kClip) addHeights(levels);
  std::erase_if(levels, [](double level) { return level <= 0 || level >= 1; });
  sortOnce(levels);

  std::vector<double> out = corners;
  std::vector<double> strengths(functions_.size());
  std::vector<std::pair<std::size_t, CurvePiece>> curves;  // with their terms
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const double from = corners[i - 1];
    const double to = corners[i];
    curves.clear();
    for (const auto& [term, weight] : flanks) {
      const auto piece = pieceOf(terms_[term], supports[term], weight, from, to);
      if (piece) curves.emplace_back(term, *piece);
    }
    const std::size_t flank_count = curves.size();
    for (const double level : levels) curves.emplace_back(kNoTerm, CurvePiece{false, from, level, 0, 0, 1, 0});
    for (std::size_t one = 0; one < flank_count; ++one) {
      for (std::size_t other = one + 1; other < curves.size(); ++other) {
        if (curves[one].first == curves[other].first) continue;
        std::array<double, 2> found;
        const double* const end =
            fuzzy::writeCrossings(curves[one].second, curves[other].second, from, to, found.data());
        for (const double* x = found.data(); x != end; ++x) {
          // Only where a strength has this height does anything bend.
          const double height = curves[one].second.at(*x) * kStrengthScale;
          strengthsAt(*x, strengths);
          const bool bends = std::any_of(strengths.begin(), strengths.end(),
                                         [&](double strength) { return std::abs(strength - height) <= 1e-6 * height; });
          if (bends) out.push_back(*x);
        }
      }
    }
  }
  std::sort(out.begin(), out.end());
  const double least = kLeastWidth * (max_ - min_);
  std::size_t kept = 1;
  for (const double x : out) {
    if (x - out[kept - 1] > least) out[kept++] = x;
  }
  out.resize(kept);
  out.back() = max_;
  return out;
}

void ExpertLine::addPieces(double from, double to, int halvings) {
  const std::size_t count = valueCount();
  std::array<double, 1 + fuzzy::kMostTerms> room;
  const std::span<double> values(room.data(), count);
  Piece piece{from, to, false, false, {}, {}};
  if (isConstant(from, to)) {
    piece.constant = true;
    piece.fires = at(from + (to - from) / 2, values);
    if (piece.fires) piece.coefficients.assign(values.begin(), values.end());
    pieces_.push_back(std::move(piece));
    return;
  }
  const bool fits = (cubic_slices_ && fitCubics(piece)) || fit(piece);
  const double middle = from + (to - from) / 2;
  if (!fits && halvings < kMostHalvings && to - from > 2 * kLeastWidth * (max_ - min_) && middle > from &&
      middle < to) {
    addPieces(from, middle, halvings + 1);
    addPieces(middle, to, halvings + 1);
    return;
  }
  for (std::size_t v = 0; v < count; ++v) {
    double steepest = 0;
    for (std::size_t power = 1; power < kNodes; ++power) {
      steepest += static_cast<double>(power) * std::abs(piece.coefficients[v * kNodes + power]);
    }
    piece.steepest.push_back(steepest * 2 / (to - from));
  }
  pieces_.push_back(std::move(piece));
}

/// Makes the polynomials from exact values. Returns whether they fit.
bool ExpertLine::fit(Piece& piece) const {
  std::array<double, 1 + fuzzy::kMostTerms> room;
  const std::span<double> values(room.data(), valueCount());
  piece.coefficients.resize(kNodes * values.size());
  std::size_t firing = 0;
  for (std::size_t node = 0; node < kNodes; ++node) {
    if (at(nodeAt(piece.from, piece.to, node), values)) ++firing;
    for (std::size_t v = 0; v < values.size(); ++v) piece.coefficients[v * kNodes + node] = values[v];
  }
  piece.fires = firing == kNodes;
  for (std::size_t v = 0; v < values.size(); ++v) toCoefficients(piece.coefficients.data() + v * kNodes);
  bool fits = piece.fires;
  for (const double place : kTrials) {
    if (!fits) break;
    at(piece.from + (piece.to - piece.from) * (1 + place) / 2, values);
    fits = agrees(piece, place, values);
  }
  return fits;
}

/// The same from fewer values: where all terms are trapezoids and clipped, each slice's area and moment are a quadratic
/// and a cubic.
bool ExpertLine::fitCubics(Piece& piece) const {
  const std::size_t terms = functions_.size();
  std::array<double, fuzzy::kMostTerms> strengths_room;
  const std::span<double> strengths(strengths_room.data(), terms);
  std::array<std::array<fuzzy::AreaAndMoment, fuzzy::kMostTerms>, 4> known;
  double unit = 0;  // strengths may be too small or large for products
  for (std::size_t i = 0; i < known.size(); ++i) {
    strengthsAt(nodeAt(piece.from, piece.to, 2 * i), strengths);
    const double largest = slicesOf(strengths, known[i]);
    if (largest == 0) return false;
    if (i == 0) unit = largest;
    for (std::size_t t = 0; t < terms; ++t) known[i][t].area *= largest / unit, known[i][t].moment *= largest / unit;
  }
  std::array<double, 1 + fuzzy::kMostTerms> room;
  const std::span<double> values(room.data(), valueCount());
  const auto values_at = [&](double place) {
    std::array<fuzzy::AreaAndMoment, fuzzy::kMostTerms> slices{};
    const auto weights = cubicWeights(place);
    double area = 0;
    for (std::size_t t = 0; t < terms; ++t) {
      for (std::size_t i = 0; i < known.size(); ++i) {
        slices[t].area += weights[i] * known[i][t].area;
        slices[t].moment += weights[i] * known[i][t].moment;
      }
      area += slices[t].area;
    }
    if (!(area > 0)) return false;
    toValues(std::span(slices).first(terms), values);
    return true;
  };
  piece.coefficients.resize(kNodes * values.size());
  for (std::size_t node = 0; node < kNodes; ++node) {
    if (!values_at(kNodePlaces[node])) return false;
    for (std::size_t v = 0; v < values.size(); ++v) piece.coefficients[v * kNodes + node] = values[v];
  }
  for (std::size_t v = 0; v < values.size(); ++v) toCoefficients(piece.coefficients.data() + v * kNodes);
  for (const double place : kTrials) {
    if (!values_at(place) || !agrees(piece, place, values)) return false;
  }
  piece.fires = at(piece.from + (piece.to - piece.from) * (1 + kCubicTrial) / 2, values);
  return piece.fires && agrees(piece, kCubicTrial, values);
}

bool ExpertLine::agrees(const Piece& piece, double place, std::span<const double> values) const {
  for (std::size_t v = 0; v < values.size(); ++v) {
    if (!(std::abs(piece.at(v, place) - values[v]) <= kCloseEnough * (v == 0 ? hi_ - lo_ : 1))) return false;
  }
  return true;
}

/// Between two bends a strength that is the same at three places is the same everywhere.
bool ExpertLine::isConstant(double from, double to) const {
  std::array<double, fuzzy::kMostTerms> rooms[2];
  const std::span<double> first(rooms[0].data(), functions_.size());
  const std::span<double> next(rooms[1].data(), functions_.size());
  strengthsAt(nodeAt(from, to, 0), first);
  for (const std::size_t node : {kNodes / 2, kNodes - 1}) {
    strengthsAt(nodeAt(from, to, node), next);
    if (!std::equal(first.begin(), first.end(), next.begin())) return false;
  }
  return true;
}

}  // namespace tactus::analysis
