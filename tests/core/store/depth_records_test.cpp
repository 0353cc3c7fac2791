#include <gtest/gtest.h>

#include "core/store/merge.h"
#include "core/store/record_import.h"
#include "core/store/record_tables.h"
#include "core/store/study_info.h"
#include "core/store/study_records.h"

#include "tests/core/store/sample_records.h"
#include "tests/support/temp_folder.h"

namespace tactus::store {
namespace {

class DepthRecords : public testing::Test {
 protected:
  study::DepthRecord record(const std::string& text) {
    return {records_.id(), time_ms_ += 10, "researcher", text, std::nullopt, {}};
  }
  static std::string refusal(StudyFile& file, const study::DepthRecord& record) {
    const auto added = append(file, record);
    return added ? "" : added.error().message();
  }

  support::TempFolder folder_;
  SampleRecords records_;
  OpenStudy study_ = makeStudy(folder_.file("study.tactus"), records_);
  std::int64_t time_ms_ = 1000;
  const std::string image_ = std::string("\x89PNG\0\r\n", 7);  // a zero byte, too
};

TEST_F(DepthRecords, TheLatestCountsAndKeepsTheImageThatCameBefore) {
  EXPECT_EQ(*depthMeasurement(study_.file), std::nullopt);
  auto first = record(R"({"mm_per_px":0.33})");
  first.image = image_;
  ASSERT_EQ(refusal(study_.file, first), "");
  EXPECT_EQ(*depthMeasurement(study_.file), first);
  auto second = record(R"({"mm_per_px":0.5})");
  second.image_of = first.id;
  ASSERT_EQ(refusal(study_.file, second), "");
  second.image = image_;
  EXPECT_EQ(*depthMeasurement(study_.file), second);
}

TEST_F(DepthRecords, WhatIsNoMeasurementIsRefused) {
  EXPECT_NE(refusal(study_.file, record("path")), "");
  EXPECT_NE(refusal(study_.file, record("{path")), "");
  auto without = record("{}");
  without.image_of = records_.id();
  EXPECT_NE(refusal(study_.file, without), "");
  auto large = record("{}");
  large.image.resize(kMostImageBytes + 1);
  EXPECT_NE(refusal(study_.file, large), "");
  EXPECT_EQ(*depthMeasurement(study_.file), std::nullopt);
}

TEST_F(DepthRecords, TravelWithExportAndMerge) {
  // The later record comes first in its id, so only the order of the rows keeps the image before its user.
  auto first = record(R"({"mm_per_px":0.33})");
  first.image = image_;
  auto second = record(R"({"mm_per_px":0.5})");
  std::swap(first.id, second.id);
  second.image_of = first.id;
  ASSERT_EQ(refusal(study_.file, first), "");
  ASSERT_EQ(refusal(study_.file, second), "");
  ASSERT_TRUE(writeRecords(study_.file, folder_.file("tables")));
  ASSERT_TRUE(restoreRecords(folder_.file("tables"), folder_.file("restored.tactus")));
  {
    auto restored = StudyFile::open(folder_.file("restored.tactus"));
    ASSERT_TRUE(restored) << restored.error().message();
    EXPECT_EQ(*depthMeasurement(*restored), *depthMeasurement(study_.file));
    auto third = record(R"({"mm_per_px":0.4})");
    third.image_of = first.id;
    ASSERT_EQ(refusal(*restored, third), "");
    ASSERT_TRUE(restored->close());
  }
  const auto merged = mergeStudy(study_.file, folder_.file("restored.tactus"), records_.id(), 5);
  ASSERT_TRUE(merged) << merged.error().message();
  EXPECT_EQ((*depthMeasurement(study_.file))->text, R"({"mm_per_px":0.4})");
  EXPECT_EQ((*depthMeasurement(study_.file))->image, image_);
  EXPECT_TRUE(checkStudy(study_.file)->empty());
}

}  // namespace
}  // namespace tactus::store
