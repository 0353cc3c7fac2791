#include "tests/stress/hard_model.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/support/random_model.h"

namespace tactus::stress {
namespace {

using base::Random;
using fuzzy::ForceModel;
using fuzzy::Shape;
using fuzzy::Term;
using fuzzy::Variable;

double powerOfTen(Random& random, double low, double high) { return std::pow(10.0, random.uniform(low, high)); }

/// Every list of output terms: the shared one and the experts' own.
template <class Change>
void forOutputTerms(ForceModel& model, Change change) {
  change(model.output.terms);
  for (auto& expert : model.experts) {
    for (auto& own : expert.overrides) {
      if (own.variable == model.output.id) change(own.terms);
    }
  }
}

/// Inside the universe, somewhere between a few ulps and a billionth of it wide.
void narrow(Random& random, const Variable& output, Term& term) {
  const double width = output.max - output.min;
  double at = output.min + width * random.uniform(0.1, 0.9);
  for (double& point : term.points) {
    point = at;
    if (random.below(3) > 0) {
      at = random.below(2) == 0 ? std::nextafter(at, std::numeric_limits<double>::infinity())
                                : at + width * powerOfTen(random, -15, -9);
    }
  }
  if (term.points.front() == term.points.back()) {
    term.points.back() = std::nextafter(at, std::numeric_limits<double>::infinity());
  }
}

/// Ramps up and down through one point at half their height, of different slopes.
void crossAt(Random& random, const Variable& output, double centre, Term& term) {
  // A power of two below the width, so that the crossing is exact where the universe allows.
  const double half = std::ldexp(output.max - output.min, -2 - random.below(4));
  const double low = centre - half, high = centre + half;
  const double end = random.below(2) == 0 ? output.max : output.max + half;
  const bool rising = random.below(2) == 0;
  if (term.shape == Shape::kTriangle) {
    term.points = rising ? std::vector<double>{low, high, std::max(high, end)}
                         : std::vector<double>{std::min(low, output.min), low, high};
  } else {
    term.points = rising ? std::vector<double>{low, high, std::max(high, end), std::max(high, end)}
                         : std::vector<double>{std::min(low, output.min), std::min(low, output.min), low, high};
  }
}

void widen(Random& random, Term& term) {
  const double far = powerOfTen(random, 8, 150);
  // The point nearest to the universe stays, so that memberships inside are minute but not 0.
  if (random.below(2) == 0) {
    for (std::size_t i = 1; i < term.points.size(); ++i) term.points[i] = far;
  } else {
    for (std::size_t i = 0; i + 1 < term.points.size(); ++i) term.points[i] = -far;
  }
  std::sort(term.points.begin(), term.points.end());
}

}  // namespace

ForceModel hardModel(Random& random) {
  ForceModel model = support::randomModel(random, {.gaussians = false, .adversarial = true});
  const Variable output = model.output;
  const double centre = output.min + (output.max - output.min) * random.uniform(0.3, 0.7);
  const int crossing = random.below(3);
  const int narrowing = random.below(3);
  forOutputTerms(model, [&](std::vector<Term>& terms) {
    for (Term& term : terms) {
      if (crossing == 0 && random.below(4) > 0) crossAt(random, output, centre, term);
      if (narrowing == 0 && random.below(2) == 0) narrow(random, output, term);
    }
    if (random.below(4) == 0 && terms.size() > 1) {
      terms.back().shape = terms.front().shape;
      terms.back().points = terms.front().points;
    }
  });
  if (random.below(4) == 0) {
    for (auto& input : model.inputs) {
      for (Term& term : input.terms) {
        if (random.below(3) == 0) widen(random, term);
      }
    }
  }
  if (random.below(4) == 0) {
    const double scale = powerOfTen(random, -300, -20);
    for (auto& expert : model.experts) {
      for (auto& rule : expert.rules) rule.weight *= scale;
    }
  }
  return model;
}

}  // namespace tactus::stress
