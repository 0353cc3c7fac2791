#include "core/store/withdrawal.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

#include "core/store/entries.h"
#include "core/store/persons.h"
#include "core/store/recording_codec.h"
#include "core/store/sessions.h"
#include "core/store/study_info.h"

#include "tests/core/store/sample_records.h"
#include "tests/support/temp_folder.h"

namespace tactus::store {
namespace {

std::string bytesOf(const std::string& path) {
  std::ostringstream out;
  out << std::ifstream(path, std::ios::binary).rdbuf();
  return out.str();
}

class Withdrawals : public testing::Test {
 protected:
  Withdrawals() {
    // A second person whose records lie between those of the first.
    other_ = records_.person("calm-fox");
    other_session_ = records_.session(other_.id);
    EXPECT_TRUE(append(study_.file, other_));
    EXPECT_TRUE(append(study_.file, other_session_));
    for (int item = 1; item <= 30; ++item) {
      auto answer = records_.answer(study_.session.id, item);
      answer.value = "secretopinion";
      if (previous_) answer.entry.supersedes = previous_;
      previous_ = answer.entry.id;
      EXPECT_TRUE(append(study_.file, answer));
      EXPECT_TRUE(append(study_.file, records_.answer(other_session_.id, item)));
    }
    stroke_ = records_.stroke(study_.session.id, 1500);
    EXPECT_TRUE(append(study_.file, stroke_));
    EXPECT_TRUE(append(study_.file, records_.stroke(other_session_.id, 1500)));
  }

  /// The bytes of the file and of what SQLite keeps beside it.
  std::string allBytes() const {
    std::string bytes;
    for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(path_).parent_path())) {
      bytes += bytesOf(entry.path().string());
    }
    return bytes;
  }
  std::string idBytes(const study::RecordId& id) const { return {id.bytes.begin(), id.bytes.end()}; }

  support::TempFolder folder_;
  SampleRecords records_;
  std::string path_ = folder_.file("study.tactus");
  OpenStudy study_ = makeStudy(path_, records_);
  study::Person other_;
  study::SessionRecord other_session_;
  study::StrokeRecord stroke_;
  std::optional<study::RecordId> previous_;
};

TEST_F(Withdrawals, NothingOfThePersonIsLeft) {
  const std::string samples = encodeRecording(stroke_.recording)->substr(600, 200);
  const std::vector<std::string> traces = {"velvet-otter", "secretopinion", idBytes(study_.session.id),
                                           idBytes(stroke_.entry.id)};
  for (const auto& trace : traces) ASSERT_NE(allBytes().find(trace), std::string::npos);
  const auto before = std::filesystem::file_size(path_);

  const auto withdrawal = withdraw(study_.file, study_.person.id, 1'780'000'000'000);
  ASSERT_TRUE(withdrawal) << withdrawal.error().message();
  EXPECT_EQ(withdrawal->records, 30 + 1 + 1 + 1);  // answers, stroke, session, person
  EXPECT_TRUE(withdrawal->copies.empty());

  const auto at_once = allBytes();  // while it is open, its journal included
  ASSERT_TRUE(study_.file.close());
  const auto closed = allBytes();
  for (const auto& trace : traces) {
    EXPECT_EQ(at_once.find(trace), std::string::npos) << trace;
    EXPECT_EQ(closed.find(trace), std::string::npos) << trace;
  }
  // The other person made the same strokes, so only one copy of the samples is left.
  EXPECT_NE(closed.find(samples), std::string::npos);
  EXPECT_EQ(closed.find(samples, closed.find(samples) + 1), std::string::npos);
  EXPECT_GT(before, 0U);
}

TEST_F(Withdrawals, TheOthersKeepEverything) {
  const auto answers_before = *answers(study_.file, {.person = other_.id, .history = true});
  const auto strokes_before = *strokes(study_.file, {.person = other_.id});
  ASSERT_TRUE(withdraw(study_.file, study_.person.id, 5));
  EXPECT_EQ(*answers(study_.file, {.history = true}), answers_before);
  EXPECT_EQ(*strokes(study_.file), strokes_before);
  EXPECT_EQ(*persons(study_.file), std::vector{other_});
  EXPECT_EQ(*sessions(study_.file), std::vector{other_session_});
  EXPECT_TRUE(checkStudy(study_.file)->empty());
  ASSERT_TRUE(append(study_.file, records_.answer(other_session_.id)));
}

TEST_F(Withdrawals, ATombstoneKeepsThePersonOut) {
  ASSERT_TRUE(withdraw(study_.file, study_.person.id, 1'780'000'000'000));
  EXPECT_EQ(*tombstones(study_.file), (std::vector{Tombstone{study_.person.id, 1'780'000'000'000}}));
  const auto back = append(study_.file, study_.person);
  ASSERT_FALSE(back);
  EXPECT_NE(back.error().message().find("this participant withdrew"), std::string::npos);
  EXPECT_FALSE(append(study_.file, study_.session));
  EXPECT_FALSE(withdraw(study_.file, study_.person.id, 6));
  EXPECT_EQ(tombstones(study_.file)->size(), 1U);
}

TEST_F(Withdrawals, CopiesFromMigrationsAreNamed) {
  std::ofstream(path_ + ".before-v2") << "older study";
  const auto withdrawal = withdraw(study_.file, study_.person.id, 5);
  ASSERT_TRUE(withdrawal);
  EXPECT_EQ(withdrawal->copies, std::vector{path_ + ".before-v2"});
}

}  // namespace
}  // namespace tactus::store
