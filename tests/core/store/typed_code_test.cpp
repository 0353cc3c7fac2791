#include <gtest/gtest.h>

#include "core/store/person_codes.h"
#include "core/store/persons.h"

#include "tests/core/store/sample_records.h"
#include "tests/support/temp_folder.h"

namespace tactus::store {
namespace {

using Codes = std::vector<std::string>;

class TypedCodes : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* code : {"calm-fox", "velvet-owl", "S1", "s-01"})
      ASSERT_TRUE(append(study_.file, records_.person(code)));
  }
  std::string found(const std::string& typed) const {
    const auto result = findTyped(study_.file, typed);
    return result && result->person ? result->person->code : "";
  }
  Codes meant(const std::string& typed) const { return findTyped(study_.file, typed)->meant; }

  support::TempFolder folder_;
  SampleRecords records_;
  OpenStudy study_ = makeStudy(folder_.file("study.tactus"), records_);  // with velvet-otter
};

TEST_F(TypedCodes, AreFoundHoweverTheyAreWritten) {
  for (const char* typed : {"velvet-otter", "Velvet Otter", " VELVETOTTER ", "velvet – otter", "velvet　otter"}) {
    EXPECT_EQ(found(typed), "velvet-otter") << typed;
    EXPECT_EQ(meant(typed), Codes{}) << typed;
  }
}

TEST_F(TypedCodes, SuggestTheClosestOnes) {
  EXPECT_EQ(found("velvet-oter"), "");
  EXPECT_EQ(meant("velvet-oter"), (Codes{"velvet-otter", "velvet-owl"}));
  EXPECT_EQ(meant("calm foxx"), Codes{"calm-fox"});
  EXPECT_EQ(meant("velvet owel"), (Codes{"velvet-owl", "velvet-otter"}));
  EXPECT_EQ(meant("something else"), Codes{});
  EXPECT_EQ(meant(" - "), Codes{});
}

TEST_F(TypedCodes, CodesThatReadAlikeNeedTheExactOne) {
  EXPECT_EQ(found("S1"), "S1");
  EXPECT_EQ(found("s-01"), "s-01");
  EXPECT_EQ(found("s 1"), "");
  EXPECT_EQ(meant("s 1").size(), 2U);
}

}  // namespace
}  // namespace tactus::store
