#include "app/workbench/tune/terms/term_grip.h"

#include <QCoreApplication>
#include <cmath>
#include <numeric>

#include "app/editing/edit_text.h"
#include "app/workbench/base/display_text.h"

namespace tactus::workbench {
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
    case Shape::kTriangle:
      return {{vertex(0), p[0], 0}, {vertex(1), p[1], 1}, {vertex(2), p[2], 0}};
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
    case Part::kVertex:
      return grip.point < term.points.size() && (!grip.mirrored || (gaussian && grip.point == 1));
    case Part::kLeftEdge:
    case Part::kRightEdge:
      return !gaussian;
    case Part::kTerm:
      return true;
  }
  return false;
}

std::vector<std::size_t> pointsOf(const std::vector<Term>& terms, const Grip& grip) {
  const Term& term = terms[grip.term];
  const std::size_t count = term.points.size();
  switch (grip.part) {
    case Part::kVertex:
      return {grip.point};
    case Part::kLeftEdge:
      return {0, 1};
    case Part::kRightEdge:
      return {count - 2, count - 1};
    case Part::kTerm:
      break;
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
    case Part::kLeftEdge:
      return named(GripText::tr("left edge"), range(variable, p[0], p[1]));
    case Part::kRightEdge:
      return named(GripText::tr("right edge"), range(variable, p[p.size() - 2], p.back()));
    case Part::kTerm:
      break;
  }
  const QString whole = GripText::tr("whole term");
  return named(whole, term.shape == Shape::kGaussian ? quantity(variable, p[0]) : range(variable, p[0], p.back()));
}

}  // namespace tactus::workbench
