// Bounds of parts of the input space hold what exact rational arithmetic gives there.
#include "core/contracts/force_cells.h"

#include <gtest/gtest.h>

#include "core/base/random.h"

#include "tests/reference/exact_model.h"
#include "tests/support/ordered_model.h"

namespace tactus::contracts {
namespace {

TEST(ForceCells, BoundsHoldExactForcesAndSlopes) {
  base::Random random(11);
  int bounded = 0;
  for (int m = 0; m < 120; ++m) {
    const auto model = support::randomOrderedModel(random);
    std::vector<std::size_t> variables;
    std::vector<Interval> ranges;
    for (const auto& input : model.inputs) {
      variables.push_back(variables.size());
      ranges.emplace_back(input.min, input.max);
    }
    ForceSum sum({{&model, 1, variables}}, ranges);
    for (int c = 0; c < 6; ++c) {
      std::vector<Stretch> cell;
      for (std::size_t v = 0; v < ranges.size(); ++v) {
        const auto stretches = sum.stretches(v);
        Stretch one = stretches[static_cast<std::size_t>(random.below(static_cast<int>(stretches.size())))];
        if (one.low == one.high) one = stretches[1];
        cell.push_back(one);
      }
      if (!sum.enter(cell)) continue;
      Part part = sum.whole();
      // Divided a few times at random, toward one point inside.
      std::vector<double> inside;
      for (std::size_t v = 0; v < ranges.size(); ++v)
        inside.push_back(part.box[v].low + part.box[v].width() * random.uniform(0.01, 0.99));
      for (int round = random.below(12); round > 0; --round) {
        const auto v = static_cast<std::size_t>(random.below(static_cast<int>(ranges.size())));
        const double middle = part.box[v].middle();
        (inside[v] <= middle ? part.box[v].high : part.box[v].low) = middle;
      }
      const auto bounds = sum.bounds(part);
      ASSERT_TRUE(bounds.has_value());
      bounded += bounds->bounded ? 1 : 0;
      const auto force = reference::exactForce(model, inside);
      const mpq_class value = force ? *force : mpq_class(model.default_force_n);
      EXPECT_LE(mpq_class(bounds->value.low), value) << m;
      EXPECT_GE(mpq_class(bounds->value.high), value) << m;
      // Divided by the orders of flanks: some leaf has the point in its box, and the force within its bounds.
      std::vector<Part> parts = {part};
      bool held = false;
      for (int divisions = 0; !parts.empty() && !held;) {
        Part one = std::move(parts.back());
        parts.pop_back();
        const auto leaf = sum.bounds(one);
        if (!leaf) continue;
        if (leaf->undecided && divisions < 40) {
          ++divisions;
          const auto [a, b] = *leaf->undecided;
          Part other = one;
          one.orders.emplace_back(a, b);
          other.orders.emplace_back(b, a);
          parts.push_back(std::move(one));
          parts.push_back(std::move(other));
          continue;
        }
        held = mpq_class(leaf->value.low) <= value && value <= mpq_class(leaf->value.high);
        for (std::size_t v = 0; v < ranges.size(); ++v) held = held && one.box[v].contains(inside[v]);
      }
      EXPECT_TRUE(held) << m;
      // Along each input the change is within the slopes.
      for (std::size_t v = 0; v < ranges.size(); ++v) {
        std::vector<double> other = inside;
        other[v] = part.box[v].low + part.box[v].width() * random.uniform(0.01, 0.99);
        const auto there = reference::exactForce(model, other);
        if (!force || !there) continue;
        const mpq_class by = mpq_class(other[v]) - mpq_class(inside[v]);
        const mpq_class low = by * mpq_class(by >= 0 ? bounds->slope[v].low : bounds->slope[v].high);
        const mpq_class high = by * mpq_class(by >= 0 ? bounds->slope[v].high : bounds->slope[v].low);
        EXPECT_LE(low, *there - *force) << m;
        EXPECT_GE(high, *there - *force) << m;
      }
    }
  }
  EXPECT_GT(bounded, 300);
}

}  // namespace
}  // namespace tactus::contracts
