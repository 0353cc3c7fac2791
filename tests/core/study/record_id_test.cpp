#include "core/study/record_id.h"

#include <gtest/gtest.h>
#include <set>

namespace tactus::study {
namespace {

TEST(RecordId, TextAndIdAreTheSameThing) {
  RecordIds ids(1);
  for (int i = 0; i < 100; ++i) {
    const RecordId id = ids.next();
    EXPECT_EQ(toText(id).size(), 32U);
    EXPECT_EQ(parseRecordId(toText(id)), id);
  }
}

TEST(RecordId, AnythingElseIsNoId) {
  EXPECT_FALSE(parseRecordId(""));
  EXPECT_FALSE(parseRecordId("0123456789abcdef0123456789abcde"));
  EXPECT_FALSE(parseRecordId("0123456789abcdef0123456789abcdefa"));
  EXPECT_FALSE(parseRecordId("0123456789abcdef0123456789abcdeg"));
  EXPECT_EQ(parseRecordId("0123456789ABCDEF0123456789abcdef"), parseRecordId("0123456789abcdef0123456789abcdef"));
}

TEST(RecordId, NilIsAllZero) {
  EXPECT_TRUE(RecordId{}.isNil());
  EXPECT_FALSE(RecordIds(7).next().isNil());
}

TEST(RecordId, NeverTwiceButRepeatableFromASeed) {
  RecordIds first(3);
  RecordIds again(3);
  std::set<RecordId> seen;
  for (int i = 0; i < 1000; ++i) {
    const RecordId id = first.next();
    EXPECT_EQ(id, again.next());
    EXPECT_TRUE(seen.insert(id).second);
  }
  EXPECT_NE(RecordIds().next(), RecordIds().next());
}

}  // namespace
}  // namespace tactus::study
