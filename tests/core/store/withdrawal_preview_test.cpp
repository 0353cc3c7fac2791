
#include <gtest/gtest.h>

#include "core/store/entries.h"
#include "core/store/model_versions.h"
#include "core/store/persons.h"
#include "core/store/sessions.h"
#include "core/store/withdrawal.h"

#include "tests/core/store/naming_model.h"
#include "tests/core/store/sample_records.h"
#include "tests/support/temp_folder.h"

namespace tactus::store {
namespace {

TEST(WithdrawalPreview, CountsWhatTheWithdrawalThenRemoves) {
  const support::TempFolder folder;
  SampleRecords records;
  auto study = makeStudy(folder.file("study.tactus"), records);
  const auto session = study.session.id;
  ASSERT_TRUE(append(study.file, records.profile(session)));
  ASSERT_TRUE(append(study.file, records.stroke(session)));
  auto felt = records.stroke(session);
  felt.level = "feel";
  ASSERT_TRUE(append(study.file, felt));
  ASSERT_TRUE(append(study.file, records.judgement(session)));
  const auto answer = records.answer(session);
  ASSERT_TRUE(append(study.file, answer));
  auto correction = records.answer(session);
  correction.entry.supersedes = answer.entry.id;
  ASSERT_TRUE(append(study.file, correction));
  ASSERT_TRUE(append(study.file, records.event(session)));
  const auto other = records.person("calm-fox");
  ASSERT_TRUE(append(study.file, other));
  const auto others = records.session(other.id);
  ASSERT_TRUE(append(study.file, others));
  ASSERT_TRUE(append(study.file, records.answer(others.id)));
  ASSERT_TRUE(append(study.file, records.model(namingModel({"velvet-otter", "calm-fox"}))));
  ASSERT_TRUE(append(study.file, records.model("{}")));

  const auto preview = previewWithdrawal(study.file, study.person.id);
  ASSERT_TRUE(preview) << preview.error().message();
  EXPECT_EQ(preview->sessions, 1);
  EXPECT_EQ(preview->strokes, 1);
  EXPECT_EQ(preview->judgements, 1);
  EXPECT_EQ(preview->answers, 2) << "with the corrected one";
  EXPECT_EQ(preview->records, 9);  // person, session, profile, 2 strokes, judgement, 2 answers, event
  EXPECT_EQ(preview->models_cleaned, 1);
  EXPECT_EQ(preview->models_kept, 1);
  EXPECT_EQ(answers(study.file)->size(), 2U) << "nothing is removed yet";

  const auto withdrawal = withdraw(study.file, study.person.id, 5);
  ASSERT_TRUE(withdrawal) << withdrawal.error().message();
  EXPECT_EQ(withdrawal->records, preview->records);
  EXPECT_EQ(withdrawal->models, preview->models_cleaned);
  EXPECT_FALSE(previewWithdrawal(study.file, study.person.id));
}

}  // namespace
}  // namespace tactus::store
