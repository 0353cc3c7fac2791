#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/text.h"
#include "core/exchange/import/convert.h"
#include "core/exchange/import/foreign_model.h"

namespace tactus::exchange {
namespace {

using base::ErrorCode;
using base::formatNumber;
using base::quoted;
using Carrying = tl::expected<CarriedTerm, TermProblem>;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

CarriedTerm trapezoid(double a, double b, double c, double d) { return {fuzzy::Shape::kTrapezoid, {a, b, c, d}}; }

class TermCarrier {
 public:
  TermCarrier(const ForeignTerm& term, ForeignRange range, const SourceText& source)
      : term_(term), range_(range), source_(source) {}

  Carrying carry() {
    if (term_.shape == ForeignShape::kOther) {
      return lacks(term_.word.at, shapeFound(term_.word.text),
                   "a trapezoid, a triangle, a Gaussian or points that make a trapezoid");
    }
    for (const ForeignNumber& number : term_.numbers) {
      if (std::isnan(number.value)) return wrong(number.at, "nan", "a number");
    }
    if (term_.height.value != 1)
      return lacks(term_.height.at, "the height " + formatNumber(term_.height.value), "the height 1");
    if (term_.shape == ForeignShape::kPoints) return points();
    const std::size_t count = term_.shape == ForeignShape::kTrapezoid  ? 4
                              : term_.shape == ForeignShape::kTriangle ? 3
                                                                       : 2;
    if (term_.numbers.size() != count) {
      return wrong(term_.word.at,
                   quoted(term_.word.text) + " with " + std::to_string(term_.numbers.size()) + " numbers",
                   std::to_string(count));
    }
    switch (term_.shape) {
      case ForeignShape::kTriangle: return triangle();
      case ForeignShape::kGaussian: return gaussian();
      case ForeignShape::kRectangle: return inOrder({x(0), x(0), x(1), x(1)}, {0, 0, 1, 1});
      case ForeignShape::kRamp: return ramp();
      case ForeignShape::kStep: return step();
      case ForeignShape::kRising: return inOrder({x(0), x(1), high(x(1)), high(x(1))}, {0, 1, 1, 1});
      case ForeignShape::kFalling: return falling();
      default: return inOrder({x(0), x(1), x(2), x(3)}, {0, 1, 2, 3});
    }
  }

 private:
  double x(std::size_t i) const { return term_.numbers[i].value; }
  std::size_t at(std::size_t i) const { return term_.numbers[i].at; }
  double low(double place) const { return std::min(range_.min, place); }
  double high(double place) const { return std::max(range_.max, place); }

  /// A trapezoid. Shoulders that never end, `-inf -inf` and `inf inf`, end at the universe. `from`: the number of the
  /// file that each corner is.
  Carrying inOrder(std::vector<double> p, const std::vector<std::size_t>& from) const {
    for (std::size_t i = 1; i < p.size(); ++i) {
      if (p[i] < p[i - 1]) {
        return wrong(at(from[i]), formatNumber(p[i]) + " after " + formatNumber(p[i - 1]),
                     "the corners of a term in ascending order");
      }
    }
    if (p[0] == -kInfinite && p[1] == -kInfinite) p[0] = p[1] = low(std::min(p[2], range_.min));
    if (p[3] == kInfinite && p[2] == kInfinite) p[3] = p[2] = high(std::max(p[1], range_.max));
    for (std::size_t i = 0; i < p.size(); ++i) {
      if (std::isinf(p[i]))
        return wrong(at(from[i]), formatNumber(p[i]), "a finite corner, or inf for a whole shoulder");
    }
    return CarriedTerm{fuzzy::Shape::kTrapezoid, std::move(p)};
  }

  Carrying triangle() const {
    const auto corners = inOrder({x(0), x(1), x(1), x(2)}, {0, 1, 1, 2});
    if (!corners || std::isinf(x(0)) || std::isinf(x(2))) return corners;
    return CarriedTerm{fuzzy::Shape::kTriangle, {x(0), x(1), x(2)}};
  }

  Carrying gaussian() const {
    if (std::isinf(x(0))) return wrong(at(0), formatNumber(x(0)), "a finite mean");
    if (!(x(1) > 0) || std::isinf(x(1))) return wrong(at(1), "sigma " + formatNumber(x(1)), "sigma > 0");
    return CarriedTerm{fuzzy::Shape::kGaussian, {x(0), x(1)}};
  }

  Carrying ramp() const {
    for (const std::size_t i : {0, 1}) {
      if (std::isinf(x(i))) return wrong(at(i), formatNumber(x(i)), "a finite number");
    }
    if (x(0) == x(1)) return wrong(at(1), formatNumber(x(1)) + " twice", "a ramp from one place to another");
    return x(0) < x(1) ? trapezoid(x(0), x(1), high(x(1)), high(x(1))) : trapezoid(low(x(1)), low(x(1)), x(1), x(0));
  }

  /// From 1 to 0. Where both are one place, the term is 0 there.
  Carrying falling() const {
    const double end = x(0) == x(1) ? std::nextafter(x(0), -kInfinite) : x(0);
    return inOrder({low(end), low(end), end, x(0) == x(1) ? end : x(1)}, {0, 0, 0, 1});
  }

  Carrying step() const {
    if (std::isinf(x(0))) return wrong(at(0), formatNumber(x(0)), "a finite number");
    if (!std::isinf(x(1))) return lacks(at(1), formatNumber(x(1)), "inf or -inf, the side where the step is 1");
    return x(1) > 0 ? trapezoid(x(0), x(0), high(x(0)), high(x(0))) : trapezoid(low(x(0)), low(x(0)), x(0), x(0));
  }

  /// From 0 up to 1, along 1, down to 0. Without a 0 before the 1 or after it, the term continues beyond the points.
  Carrying points() const {
    const std::size_t count = term_.numbers.size() / 2;
    const auto place = [this](std::size_t i) { return x(2 * i); };
    const auto height = [this](std::size_t i) { return x(2 * i + 1); };
    if (count < 2) return lacks(term_.word.at, "one point", "two points or more");
    std::size_t first = count;
    std::size_t last = count;
    for (std::size_t i = 0; i < count; ++i) {
      if (std::isinf(place(i))) return wrong(at(2 * i), formatNumber(place(i)), "a finite number");
      if (i > 0 && place(i) < place(i - 1)) {
        return wrong(at(2 * i), formatNumber(place(i)) + " after " + formatNumber(place(i - 1)),
                     "points in ascending order");
      }
      if (height(i) < 0 || height(i) > 1)
        return wrong(at(2 * i + 1), "the height " + formatNumber(height(i)), "a height from 0 to 1");
      if (height(i) != 0 && height(i) != 1) {
        return lacks(at(2 * i + 1), "a point of the height " + formatNumber(height(i)),
                     "points that make a trapezoid, with the heights 0 and 1");
      }
      if (height(i) == 0) continue;
      if (first == count) first = i;
      if (last != count && last != i - 1)
        return lacks(at(2 * i), "points with two peaks", "points that make one trapezoid");
      last = i;
    }
    if (first == count) return lacks(at(0), "a term that is 0 everywhere", "points that make a trapezoid");
    const double b = first == 0 ? low(place(0)) : place(first);
    const double c = last == count - 1 ? high(place(last)) : place(last);
    return trapezoid(first == 0 ? b : place(first - 1), b, c, last == count - 1 ? c : place(last + 1));
  }

  tl::unexpected<TermProblem> problem(ErrorCode code, std::size_t where, std::string found, std::string wanted,
                                      bool is_wrong) const {
    base::Error error = source_.error(code, where, std::move(found), std::move(wanted));
    error.place += ", term " + quoted(term_.name.text);
    return tl::unexpected(TermProblem{std::move(error), is_wrong});
  }
  tl::unexpected<TermProblem> wrong(std::size_t where, std::string found, std::string wanted) const {
    return problem(ErrorCode::kValue, where, std::move(found), std::move(wanted), true);
  }
  tl::unexpected<TermProblem> lacks(std::size_t where, std::string found, std::string wanted) const {
    return problem(ErrorCode::kValue, where, std::move(found), std::move(wanted), false);
  }

  const ForeignTerm& term_;
  ForeignRange range_;
  const SourceText& source_;
};

/// Puts a shoulder that lies beyond the end of the universe back to it.
void foldShoulders(CarriedTerm& term, ForeignRange range) {
  std::vector<double>& p = term.points;
  if (term.shape == fuzzy::Shape::kTrapezoid) {
    if (p[1] <= range.min && p[2] >= range.min) p[0] = p[1] = range.min;
    if (p[2] >= range.max && p[1] <= range.max) p[3] = p[2] = range.max;
  } else if (term.shape == fuzzy::Shape::kTriangle) {
    if (p[1] == range.min) p[0] = p[1];
    if (p[1] == range.max) p[2] = p[1];
  }
}

}  // namespace

std::optional<ForeignRange> reachOf(const ForeignTerm& term) {
  if (term.shape == ForeignShape::kOther || term.numbers.empty()) return std::nullopt;
  if (term.shape == ForeignShape::kGaussian && term.numbers.size() == 2) {
    const double sides = 4 * std::abs(term.numbers[1].value);
    return ForeignRange{term.numbers[0].value - sides, term.numbers[0].value + sides};
  }
  ForeignRange out{kInfinite, -kInfinite};
  const std::size_t step = term.shape == ForeignShape::kPoints ? 2 : 1;
  for (std::size_t i = 0; i < term.numbers.size(); i += step) {
    const double value = term.numbers[i].value;
    if (!std::isfinite(value)) continue;
    out = {std::min(out.min, value), std::max(out.max, value)};
  }
  return out.min <= out.max ? std::optional(out) : std::nullopt;
}

tl::expected<CarriedTerm, TermProblem> carried(const ForeignTerm& term, ForeignRange range, bool fold,
                                               const SourceText& source) {
  auto out = TermCarrier(term, range, source).carry();
  if (out && fold) foldShoulders(*out, range);
  return out;
}

std::optional<std::vector<CarriedTerm>> complement(const CarriedTerm& term, ForeignRange range) {
  if (term.shape == fuzzy::Shape::kGaussian) return std::nullopt;
  const std::vector<double>& p = term.points;
  const double a = p[0];
  const double b = p[1];
  const double c = p[p.size() - 2];
  const double d = p.back();
  std::vector<CarriedTerm> out;
  // At a vertical edge the term is 1, so its complement begins beside it, at the next double.
  if (b > range.min) {
    const double end = a == b ? std::nextafter(a, -kInfinite) : a;
    const double start = std::min(range.min, end);
    out.push_back(trapezoid(start, start, end, a == b ? end : b));
  }
  if (c < range.max) {
    const double begin = c == d ? std::nextafter(d, kInfinite) : d;
    const double end = std::max(range.max, begin);
    out.push_back(trapezoid(c == d ? begin : c, begin, end, end));
  }
  return out;
}

bool meets(const CarriedTerm& term, ForeignRange range) {
  if (term.shape == fuzzy::Shape::kGaussian) return true;
  return std::min(term.points.back(), range.max) > std::max(term.points.front(), range.min);
}

namespace {

using base::ErrorCode;
using base::formatNumber;
using base::quoted;

std::string rangeText(ForeignRange range) { return formatNumber(range.min) + " to " + formatNumber(range.max); }

}  // namespace

base::Result<CarriedVariable> CarriedVariable::carry(const ForeignModel& model, const ForeignVariable& variable,
                                                     bool is_output, std::size_t number,
                                                     const std::vector<bool>& used) {
  CarriedVariable out(model, variable, is_output);
  out.variable_.id = idFrom(variable.name.text, is_output ? "output" : "input_" + std::to_string(number));
  out.variable_.label = base::oneLine(variable.name.text);
  out.variable_.unit = is_output ? "N" : "1";
  if (const auto ok = out.setRange(); !ok) return tl::unexpected(ok.error());
  for (std::size_t i = 0; i < variable.terms.size(); ++i) {
    if (const auto ok = out.addTerm(model, i, used[i]); !ok) return tl::unexpected(ok.error());
  }
  out.nots_.resize(variable.terms.size());
  return out;
}

base::Result<void> CarriedVariable::setRange() {
  if (from_->range) {
    range_ = *from_->range;
  } else {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    ForeignRange span{kFar, -kFar};
    for (const ForeignTerm& term : from_->terms) {
      if (const auto reach = reachOf(term)) span = {std::min(span.min, reach->min), std::max(span.max, reach->max)};
    }
    if (!(span.max - span.min > 0) || std::isinf(span.max - span.min)) {
      return source_->fail(ErrorCode::kSchema, from_->name.at, "no range of " + quoted(from_->name.text),
                           "a range, or terms that span one");
    }
    range_ = span;
    source_->warn(from_->name.at, "no range of " + quoted(from_->name.text) +
                                      " is stated; that of its terms is taken, " + rangeText(span));
  }
  variable_.min = range_.min;
  variable_.max = range_.max;
  return {};
}

base::Result<void> CarriedVariable::addTerm(const ForeignModel& model, std::size_t index, bool is_used) {
  const ForeignTerm& term = from_->terms[index];
  const std::string name = "term " + quoted(term.name.text) + " of " + quoted(from_->name.text);
  terms_.emplace_back();
  ids_.emplace_back();
  auto shape = carried(term, range_, model.format == ImportFormat::kFis, *source_);
  if (!shape) {
    if (shape.error().is_wrong || is_used) return tl::unexpected(shape.error().error);
    source_->warn(term.name.at, name + " is left out: found " + shape.error().error.found + ", wanted " +
                                    shape.error().error.wanted + "; no rule uses it");
    return {};
  }
  terms_.back() = *shape;
  if (!meets(*shape, range_)) {
    source_->warn(term.name.at, name + " lies outside the range of " + rangeText(range_) +
                                    (is_output_ ? " and is left out, with the rules that conclude it" : ""));
    if (is_output_) return {};
  }
  const std::string id = idFrom(term.name.text, "term_" + std::to_string(index + 1));
  if (hasId(id)) {
    return source_->fail(ErrorCode::kSchema, term.name.at, name + " with the id " + quoted(id) + " of an earlier term",
                         "names that differ in letters and digits");
  }
  ids_.back() = {addPart(*shape, id, base::oneLine(term.name.text))};
  return {};
}

base::Result<std::vector<std::string>> CarriedVariable::idsOf(std::size_t index, bool negated, std::size_t at) {
  if (!negated) return ids_[index];
  if (nots_[index]) return *nots_[index];
  const ForeignTerm& term = from_->terms[index];
  const auto parts = complement(*terms_[index], range_);
  if (!parts) {
    return source_->fail(ErrorCode::kValue, at, "NOT of the Gaussian " + quoted(term.name.text),
                         "NOT of a trapezoid or triangle, which two terms can carry");
  }
  const std::string label = "not " + base::oneLine(term.name.text);
  const std::string id = "not_" + idFrom(term.name.text, "term_" + std::to_string(index + 1));
  std::vector<std::string> ids;
  for (const CarriedTerm& part : *parts) {
    if (!meets(part, range_) && is_output_) continue;
    const bool is_below = part.points.front() <= range_.min && &part == &parts->front();
    const bool both = parts->size() == 2;
    ids.push_back(addPart(part, both ? id + (is_below ? "_below" : "_above") : id,
                          both ? label + (is_below ? ", below" : ", above") : label));
  }
  nots_[index] = ids;
  return ids;
}

const std::string& CarriedVariable::addPart(const CarriedTerm& part, const std::string& id, const std::string& label) {
  std::string own = id.substr(0, 60);
  for (int copy = 2; hasId(own); ++copy) own = id.substr(0, 56) + "_" + std::to_string(copy);
  variable_.terms.push_back({own, label, part.shape, part.points});
  return variable_.terms.back().id;
}

bool CarriedVariable::hasId(const std::string& id) const { return fuzzy::findTerm(variable_.terms, id) != nullptr; }

}  // namespace tactus::exchange
