#include "core/store/duel_records.h"

#include <gtest/gtest.h>
#include <limits>

#include "core/store/entries.h"
#include "core/store/merge.h"
#include "core/store/sessions.h"
#include "core/store/study_info.h"
#include "core/store/withdrawal.h"

#include "tests/core/store/sample_records.h"
#include "tests/support/temp_folder.h"

namespace tactus::store {
namespace {

class DuelRecords : public testing::Test {
 protected:
  void SetUp() override {
    felt_ = records_.session(study_.person.id);
    felt_.kind = study::SessionKind::kUsability;
    ASSERT_TRUE(append(study_.file, felt_));
  }
  study::DuelStart start() {
    study::DuelStart out;
    out.entry = records_.entry(felt_.id);
    out.setting = {"Touch 1", false, "NGT averaged", records_.id(), {{"lubrication", 0.25}, {"neck_flexion", 45}}};
    out.a = {"NGT averaged", records_.id(), ""};
    out.b = {"S4 alone", std::nullopt, "S4"};
    out.question = study::DuelQuestion::kMoreReal;
    out.rule = study::DuelRule::kSequential;
    out.expects_b = false;
    out.from_mm = 150;
    out.to_mm = 210.5;
    out.speed_mm_s = 60;
    out.seed = std::numeric_limits<std::uint64_t>::max() - 1;  // beyond what a double holds
    out.trials = 40;
    out.sought_jnd = 1.25;
    out.power = 0.9;
    out.predicted_jnd = 1.7;
    out.gives_force = false;
    return out;
  }
  study::DuelAnswer answer(const study::DuelStart& duel) {
    study::DuelAnswer out;
    out.entry = records_.entry(felt_.id);
    out.duel = duel.entry.id;
    out.trial = 3;
    out.attempt = 2;
    out.kind = study::DuelTrialKind::kLarge;
    out.second_first = true;
    out.difference_jnd = 3;
    out.choice = study::DuelChoice::kCantTell;
    out.first_mm_s = 61.5;
    out.second_mm_s = 58;
    out.response_s = 1.25;
    return out;
  }
  study::DuelAnswer repeated(const study::DuelStart& duel) {
    study::DuelAnswer out = answer(duel);
    out.choice.reset();
    out.repeated = "too_fast";
    out.second_mm_s = 0;
    return out;
  }
  study::DuelEnd end(const study::DuelStart& duel) {
    return {records_.entry(felt_.id), duel.entry.id, "differ", 17, 12.5};
  }
  template <class Record>
  std::string refusal(const Record& record) {
    const auto written = append(study_.file, record);
    return written ? "" : written.error().message();
  }

  support::TempFolder folder_;
  SampleRecords records_;
  std::string path_ = folder_.file("study.tactus");
  OpenStudy study_ = makeStudy(path_, records_);
  study::SessionRecord felt_;
};

TEST_F(DuelRecords, AreReadAsWritten) {
  StoredDuel wanted{start(), study_.person.code, {}, {}};
  ASSERT_EQ(refusal(wanted.start), "");
  wanted.answers = {repeated(wanted.start), answer(wanted.start)};
  for (const auto& one : wanted.answers) ASSERT_EQ(refusal(one), "");
  StoredDuel other{start(), study_.person.code, {}, {}};
  other.start.predicted_jnd.reset();
  ASSERT_EQ(refusal(other.start), "");
  wanted.end = end(wanted.start);
  ASSERT_EQ(refusal(*wanted.end), "");
  EXPECT_EQ(duels(study_.file).value(), (std::vector{wanted, other})) << "the second one was interrupted";
  EXPECT_TRUE(checkStudy(study_.file)->empty());
}

TEST_F(DuelRecords, RefusesWhatNoDuelHas) {
  auto duel = start();
  duel.entry.session = study_.session.id;  // of an elicitation
  EXPECT_NE(refusal(duel).find("usability"), std::string::npos);
  duel = start();
  duel.trials = 0;
  EXPECT_NE(refusal(duel), "");
  duel = start();
  duel.speed_mm_s = std::numeric_limits<double>::infinity();
  EXPECT_NE(refusal(duel), "");
  duel = start();
  duel.a.name.clear();
  EXPECT_NE(refusal(duel), "");
  duel = start();
  auto wrong = answer(duel);
  wrong.response_s = -1;
  EXPECT_NE(refusal(wrong), "");
  EXPECT_TRUE(duels(study_.file)->empty());
}

TEST_F(DuelRecords, AnAnswerWithoutItsPlanIsAFinding) {
  const auto lost = start();
  ASSERT_EQ(refusal(answer(lost)), "");
  ASSERT_EQ(refusal(end(lost)), "");
  EXPECT_TRUE(duels(study_.file)->empty());
  EXPECT_EQ(checkDuelRecords(study_.file)->size(), 2U);
  EXPECT_EQ(checkStudy(study_.file)->size(), 2U);
  // A word of a newer program.
  auto event = records_.event(felt_.id);
  event.kind = kDuelStartKind;
  event.detail = "{}";
  ASSERT_TRUE(append(study_.file, event));
  EXPECT_FALSE(duels(study_.file));
}

TEST_F(DuelRecords, MergeAndWithdrawalIncludeThem) {
  const auto duel = start();
  ASSERT_EQ(refusal(duel), "");
  ASSERT_EQ(refusal(answer(duel)), "");
  SampleRecords others(2);
  auto other = makeStudy(folder_.file("other.tactus"), others);
  ASSERT_TRUE(study_.file.close());
  ASSERT_TRUE(mergeStudy(other.file, path_, others.id(), 0));
  const auto merged = duels(other.file);
  ASSERT_TRUE(merged);
  ASSERT_EQ(merged->size(), 1U);
  EXPECT_EQ(merged->front().answers.size(), 1U);
  ASSERT_TRUE(withdraw(other.file, study_.person.id, 0));
  EXPECT_TRUE(duels(other.file)->empty());
}

}  // namespace
}  // namespace tactus::store
