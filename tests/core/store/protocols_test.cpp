#include <gtest/gtest.h>

#include "core/store/merge.h"
#include "core/store/persons.h"
#include "core/store/record_import.h"
#include "core/store/record_tables.h"
#include "core/store/sessions.h"
#include "core/store/study_info.h"
#include "core/store/study_records.h"

#include "tests/core/store/plain_sql.h"
#include "tests/core/store/sample_records.h"
#include "tests/support/temp_folder.h"

namespace tactus::store {
namespace {

class Protocols : public testing::Test {
 protected:
  study::ProtocolRecord record(int version, const std::string& text, const std::string& reason = {}) {
    return {records_.id(), version, time_ms_ += 10, "researcher", reason, text};
  }
  static std::string refusal(StudyFile& file, const study::ProtocolRecord& record) {
    const auto added = append(file, record);
    return added ? "" : added.error().message();
  }
  /// A session that follows `protocol`, of a real or a simulated person.
  void follow(StudyFile& file, const study::RecordId& protocol, bool simulated) {
    auto person = records_.person("p" + std::to_string(++persons_));
    person.simulated = simulated;
    ASSERT_TRUE(append(file, person));
    auto session = records_.session(person.id);
    session.protocol = protocol;
    ASSERT_TRUE(append(file, session));
  }

  support::TempFolder folder_;
  SampleRecords records_;
  OpenStudy study_ = makeStudy(folder_.file("study.tactus"), records_);
  std::int64_t time_ms_ = 1000;
  int persons_ = 0;
};

TEST_F(Protocols, AreDraftsUntilAParticipantFollowsOne) {
  EXPECT_EQ(protocolState(study_.file)->current, std::nullopt);
  EXPECT_EQ(protocolState(study_.file)->nextVersion(), 1);
  const auto first = record(1, R"({"strokes":4})");
  const auto second = record(1, R"({"strokes":5})");
  ASSERT_EQ(refusal(study_.file, first), "");
  ASSERT_EQ(refusal(study_.file, second), "");
  follow(study_.file, second.id, /*simulated=*/true);
  auto state = protocolState(study_.file);
  EXPECT_EQ(state->current, second);
  EXPECT_FALSE(state->locked);
  EXPECT_NE(refusal(study_.file, record(2, "{}", "why")), "");

  follow(study_.file, second.id, /*simulated=*/false);
  state = protocolState(study_.file);
  EXPECT_TRUE(state->locked);
  EXPECT_EQ(state->nextVersion(), 2);
  EXPECT_EQ(refusal(study_.file, record(1, "{}")),
            folder_.file("study.tactus") +
                ": protocol: found version 1, wanted version 2, because participants follow the one before");
  EXPECT_NE(refusal(study_.file, record(2, "{}")).find("an amendment without a reason"), std::string::npos);
  const auto amended = record(2, R"({"strokes":3})", "the sessions took too long");
  ASSERT_EQ(refusal(study_.file, amended), "");
  EXPECT_EQ(*protocols(study_.file), (std::vector{first, second, amended}));
  EXPECT_FALSE(protocolState(study_.file)->locked);
  EXPECT_EQ(studyInfo(study_.file)->protocol_version, 2);
}

TEST_F(Protocols, AreJsonObjectsThatNeverChange) {
  for (const char* text : {"", "[]", "{", "text", "{\"a\":1,\"a\":2}"})
    EXPECT_NE(refusal(study_.file, record(1, text)), "") << text;
  ASSERT_EQ(refusal(study_.file, record(1, "{}")), "");
  ASSERT_TRUE(study_.file.close());
  PlainSql sql(folder_.file("study.tactus"));
  for (const char* change :
       {"UPDATE protocol SET version = 2", "DELETE FROM protocol", "REPLACE INTO protocol SELECT * FROM protocol"}) {
    EXPECT_NE(sql.complaint(change).find("protocol: "), std::string::npos) << change;
  }
}

TEST_F(Protocols, TravelWithExportAndMerge) {
  const auto first = record(1, R"({"strokes":4})");
  ASSERT_EQ(refusal(study_.file, first), "");
  follow(study_.file, first.id, false);
  ASSERT_TRUE(writeRecords(study_.file, folder_.file("tables")));
  ASSERT_TRUE(restoreRecords(folder_.file("tables"), folder_.file("restored.tactus")));
  auto restored = StudyFile::open(folder_.file("restored.tactus"));
  ASSERT_TRUE(restored) << restored.error().message();
  EXPECT_EQ(*protocols(*restored), *protocols(study_.file));
  EXPECT_EQ(*sessions(*restored), *sessions(study_.file));
  EXPECT_TRUE(protocolState(*restored)->locked);

  // Both stations amend it: each to its own version 2.
  ASSERT_EQ(refusal(study_.file, record(2, R"({"strokes":3})", "long")), "");
  const auto theirs = record(2, R"({"strokes":2})", "longer");
  ASSERT_EQ(refusal(*restored, theirs), "");
  follow(study_.file, protocolState(study_.file)->current->id, false);
  follow(*restored, theirs.id, false);
  ASSERT_TRUE(restored->close());
  const auto merged = mergeStudy(study_.file, folder_.file("restored.tactus"), records_.id(), 5);
  ASSERT_TRUE(merged) << merged.error().message();
  EXPECT_EQ(protocolState(study_.file)->current, theirs) << "the later one";
  EXPECT_EQ(merged->conflicts,
            (std::vector<std::string>{"protocol: participants followed 2 protocols that are all version 2; the latest "
                                      "counts from now on"}));
}

}  // namespace
}  // namespace tactus::store
