#include "elicitation/depth/depth_measurement.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "tests/support/default_procedure.h"

namespace tactus::elicitation {
namespace {

TEST(DepthMeasurement, IsTheSameAfterReadingItsText) {
  const DepthMeasurement measurement = {"sagittal.png",          true, 0.1,  {{1, 2.5}, {-3, 1.0 / 3}},
                                        {{70, 10}, {115.25, 0}}, 0.93, 512.5};
  const std::string text = toText(measurement);
  EXPECT_EQ(text.find('\n'), std::string::npos);
  const auto read = readMeasurement(text);
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(*read, measurement);
}

TEST(DepthMeasurement, BeginsWithTheBoundariesOfTheModel) {
  const auto inputs = support::ngtInputs();
  const auto depth = std::find_if(inputs.begin(), inputs.end(), [](const auto& one) { return one.id == "depth"; });
  const DepthMeasurement empty = emptyMeasurement(*depth);
  ASSERT_EQ(empty.boundaries.size(), 5U);
  EXPECT_EQ(empty.boundaries[3], (DepthBoundary{200, 15}));
  EXPECT_EQ(*depthTerms(*depth, empty.boundaries, empty.scale), depth->terms);
}

TEST(DepthMeasurement, WhatIsNoneIsRefusedWithItsPlace) {
  for (const char* text : {"", "[]", "{}", R"({"mm_per_px":0})", R"({"mm_per_px":1,"path_px":[[1]]})",
                           R"({"mm_per_px":1,"path_px":[[1,1e9]]})", R"({"mm_per_px":1,"path_px":["a"]})",
                           R"({"mm_per_px":1,"boundaries":[{"depth_mm":70}]})", R"({"mm_per_px":1,"boundaries":[7]})",
                           R"({"mm_per_px":1,"scale":9})"}) {
    EXPECT_FALSE(readMeasurement(text)) << text;
  }
  EXPECT_TRUE(readMeasurement(R"({"mm_per_px":1,"later":true})"));
}

}  // namespace
}  // namespace tactus::elicitation
