#include "app/workbench/tune/terms/term_grip.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "app/editing/edit.h"
#include "app/workbench/base/display_text.h"
#include "core/fuzzy/membership.h"

namespace tactus::workbench {

std::vector<fuzzy::Term> termsBefore(const fuzzy::ForceModel& model, const editing::TermListId& list,
                                     const fuzzy::Variable& variable) {
  const fuzzy::Variable* found = &model.output;
  for (const fuzzy::Variable& input : model.inputs) {
    if (input.id == variable.id) found = &input;
  }
  if (found->id != variable.id) return {};
  for (const fuzzy::Expert& expert : model.experts) {
    if (!list.expert.empty() && expert.id == list.expert) return fuzzy::termsFor(expert, *found);
  }
  return found->terms;
}

double roomiestPlace(const fuzzy::Variable& variable, const std::vector<fuzzy::Term>& terms) {
  std::vector<fuzzy::MembershipFunction> shapes;
  for (const fuzzy::Term& term : terms) {
    auto shape = fuzzy::MembershipFunction::of(term);
    if (shape.gaussian)
      shape = {false, shape.mean - 3 * shape.sigma, shape.mean, shape.mean, shape.mean + 3 * shape.sigma};
    shapes.push_back(shape);
  }
  std::sort(shapes.begin(), shapes.end(), [](const auto& one, const auto& other) { return one.a < other.a; });
  double gap_end = variable.min;
  double widest_gap = 0;
  double widest_core = 0;
  double in_gap = 0;
  double in_core = (variable.min + variable.max) / 2;
  const auto offer_gap = [&](double to) {
    if (to - gap_end > widest_gap) {
      widest_gap = to - gap_end;
      in_gap = (gap_end + to) / 2;
    }
  };
  for (const auto& shape : shapes) {
    offer_gap(std::min(shape.a, variable.max));
    gap_end = std::max(gap_end, shape.d);
    const double from = std::max(shape.b, variable.min);
    const double to = std::min(shape.c, variable.max);
    if (to - from > widest_core) {
      widest_core = to - from;
      in_core = from + 0.75 * (to - from);
    }
  }
  offer_gap(variable.max);
  return widest_gap > 0 ? in_gap : in_core;
}

namespace {

using Part = Grip::Part;

double distance(QPointF a, QPointF b) { return std::hypot(a.x() - b.x(), a.y() - b.y()); }

double distanceToLine(QPointF place, QPointF from, QPointF to) {
  const QPointF along = to - from;
  const double length_squared = QPointF::dotProduct(along, along);
  if (length_squared == 0) return distance(place, from);
  const double share = std::clamp(QPointF::dotProduct(place - from, along) / length_squared, 0.0, 1.0);
  return distance(place, from + share * along);
}

struct Found {
  Grip grip;
  double distance_px = 0;
  bool preferred = false;
};

/// Keeps the best of what is within reach.
class Best {
 public:
  explicit Best(double reach) : reach_(reach) {}

  /// `later_wins`: of two at the same distance.
  void offer(const Found& found, bool later_wins) {
    constexpr double kSame = 0.5;  // px
    if (found.distance_px > reach_) return;
    if (any_) {
      const double more = found.distance_px - best_.distance_px;
      if (more > kSame) return;
      if (more > -kSame) {
        if (best_.preferred && !found.preferred) return;
        if (best_.preferred == found.preferred && !later_wins) return;
      }
    }
    best_ = found;
    any_ = true;
  }

  std::optional<Grip> grip() const { return any_ ? std::optional<Grip>(best_.grip) : std::nullopt; }

 private:
  double reach_;
  bool any_ = false;
  Found best_;
};

std::optional<Grip> vertexAt(const PlotFrame& frame, const std::vector<fuzzy::Term>& terms, QPointF place,
                             std::optional<std::size_t> preferred) {
  Best best(kVertexReach);
  for (std::size_t t = 0; t < terms.size(); ++t) {
    for (const GripHandle& handle : handlesOf(terms, t)) {
      const QPointF at = frame.pixelOf(handle.x, handle.membership);
      // Handles come from left to right: the last of some at one place is the one that is free to the right.
      best.offer({handle.grip, distance(place, at), preferred == t}, place.x() > at.x());
    }
  }
  return best.grip();
}

std::optional<Grip> edgeAt(const PlotFrame& frame, const std::vector<fuzzy::Term>& terms, QPointF place,
                           std::optional<std::size_t> preferred) {
  Best best(kEdgeReach);
  for (std::size_t t = 0; t < terms.size(); ++t) {
    const auto& p = terms[t].points;
    if (terms[t].shape == fuzzy::Shape::kGaussian) continue;
    const std::size_t count = p.size();
    const double left = distanceToLine(place, frame.pixelOf(p[0], 0), frame.pixelOf(p[1], 1));
    const double right = distanceToLine(place, frame.pixelOf(p[count - 2], 1), frame.pixelOf(p[count - 1], 0));
    best.offer({{t, Part::kLeftEdge, 0, false}, left, preferred == t}, false);
    best.offer({{t, Part::kRightEdge, 0, false}, right, preferred == t}, true);
  }
  return best.grip();
}

std::optional<Grip> termAt(const PlotFrame& frame, const std::vector<fuzzy::Term>& terms, QPointF place,
                           std::optional<std::size_t> preferred) {
  if (!frame.area.contains(place)) return std::nullopt;
  const double x = frame.valueAt(place.x());
  const double height = (frame.area.bottom() - place.y()) / frame.area.height() * frame.top;
  std::optional<Grip> found;
  double highest = 0;
  for (std::size_t t = 0; t < terms.size(); ++t) {
    const double membership = fuzzy::MembershipFunction::of(terms[t])(x);
    if (membership <= 0 || membership < height) continue;
    if (preferred == t) return Grip{t, Part::kTerm, 0, false};
    if (membership <= highest) continue;
    highest = membership;
    found = Grip{t, Part::kTerm, 0, false};
  }
  return found;
}

}  // namespace

QPointF PlotFrame::pixelOf(double x, double membership) const {
  return {area.left() + (x - low) / (high - low) * area.width(), area.bottom() - membership / top * area.height()};
}

double PlotFrame::valueAt(double x_px) const { return low + (x_px - area.left()) / area.width() * (high - low); }

std::optional<Grip> gripAt(const PlotFrame& frame, const std::vector<fuzzy::Term>& terms, QPointF place,
                           std::optional<std::size_t> preferred) {
  if (auto vertex = vertexAt(frame, terms, place, preferred)) return vertex;
  if (auto edge = edgeAt(frame, terms, place, preferred)) return edge;
  return termAt(frame, terms, place, preferred);
}

namespace {

using fuzzy::Shape;
using fuzzy::Term;
using Part = Grip::Part;

struct GripText {
  Q_DECLARE_TR_FUNCTIONS(GripText)
};

// Of a Gaussian one sigma beside its mean.
const double kAtSigma = std::exp(-0.5);

QString quantity(const fuzzy::Variable& variable, double value) { return text(editing::quantityText(variable, value)); }

QString range(const fuzzy::Variable& variable, double from, double to) {
  return GripText::tr("%1 to %2").arg(text(editing::numberText(variable, from)), quantity(variable, to));
}

}  // namespace

std::vector<GripHandle> handlesOf(const std::vector<Term>& terms, std::size_t index) {
  const Term& term = terms[index];
  const auto& p = term.points;
  const auto vertex = [index](std::size_t point, bool mirrored = false) {
    return Grip{index, Part::kVertex, point, mirrored};
  };
  switch (term.shape) {
    case Shape::kTrapezoid:
      return {{vertex(0), p[0], 0}, {vertex(1), p[1], 1}, {vertex(2), p[2], 1}, {vertex(3), p[3], 0}};
    case Shape::kTriangle: return {{vertex(0), p[0], 0}, {vertex(1), p[1], 1}, {vertex(2), p[2], 0}};
    case Shape::kGaussian:
      return {{vertex(1, true), p[0] - p[1], kAtSigma}, {vertex(0), p[0], 1}, {vertex(1), p[0] + p[1], kAtSigma}};
  }
  return {};
}

bool holds(const std::vector<Term>& terms, const Grip& grip) {
  if (grip.term >= terms.size()) return false;
  const Term& term = terms[grip.term];
  const bool gaussian = term.shape == Shape::kGaussian;
  switch (grip.part) {
    case Part::kVertex: return grip.point < term.points.size() && (!grip.mirrored || (gaussian && grip.point == 1));
    case Part::kLeftEdge:
    case Part::kRightEdge: return !gaussian;
    case Part::kTerm: return true;
  }
  return false;
}

std::vector<std::size_t> pointsOf(const std::vector<Term>& terms, const Grip& grip) {
  const Term& term = terms[grip.term];
  const std::size_t count = term.points.size();
  switch (grip.part) {
    case Part::kVertex: return {grip.point};
    case Part::kLeftEdge: return {0, 1};
    case Part::kRightEdge: return {count - 2, count - 1};
    case Part::kTerm: break;
  }
  if (term.shape == Shape::kGaussian) return {0};
  std::vector<std::size_t> all(count);
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

QString gripText(const fuzzy::Variable& variable, const std::vector<Term>& terms, const Grip& grip) {
  const Term& term = terms[grip.term];
  const auto& p = term.points;
  const auto named = [&term](const QString& part, const QString& value) {
    return QStringLiteral("%1: %2 %3").arg(labelOf(term), part, value);
  };
  switch (grip.part) {
    case Part::kVertex:
      return named(text(editing::pointName(term.shape, grip.point)), quantity(variable, p[grip.point]));
    case Part::kLeftEdge: return named(GripText::tr("left edge"), range(variable, p[0], p[1]));
    case Part::kRightEdge: return named(GripText::tr("right edge"), range(variable, p[p.size() - 2], p.back()));
    case Part::kTerm: break;
  }
  const QString whole = GripText::tr("whole term");
  return named(whole, term.shape == Shape::kGaussian ? quantity(variable, p[0]) : range(variable, p[0], p.back()));
}

}  // namespace tactus::workbench
