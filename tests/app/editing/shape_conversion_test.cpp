#include <gtest/gtest.h>

#include "app/editing/term_edits.h"

#include "tests/app/editing/sample_models.h"

namespace tactus::editing {
namespace {

TEST(ShapeConversion, IsAnEditOfTheModel) {
  const auto edit = must(convertShape(support::s4AsPrinted(), {kDepth, "nasopharynx"}, fuzzy::Shape::kTriangle));
  EXPECT_EQ(edit.label, "Depth / nasopharynx: trapezoid to triangle");
  EXPECT_EQ(termIn(edit.model, "depth", "nasopharynx").shape, fuzzy::Shape::kTriangle);
}

}  // namespace
}  // namespace tactus::editing
