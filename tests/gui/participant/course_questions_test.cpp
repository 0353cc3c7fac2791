// The questions and the review on the course of the screens.
#include <algorithm>
#include <atomic>
#include <gtest/gtest.h>
#include <memory>

#include "core/store/persons.h"
#include "core/store/sessions.h"
#include "core/store/study_info.h"

#include "tests/gui/participant/course_test.h"

namespace tactus::workbench {
namespace {

using tests::comesTrue;
using Screen = ParticipantScreen;

using CourseQuestionsTest = CourseTest;

TEST_F(CourseQuestionsTest, NothingThatWasPressedBeforeAnswersTheNextScreen) {
  beginQuestions();
  // A double click: the second one comes before the next question is painted.
  choose("small");
  nurse->next();
  nurse->next();
  ASSERT_TRUE(stored());
  EXPECT_EQ(at().question.position, 2);
  nurse->choose(QStringLiteral("large"));
  EXPECT_TRUE(at().question.chosen.isEmpty());
  // Within 300 ms of the first frame.
  nurse->painted(at().serial);
  advance(290);
  nurse->choose(QStringLiteral("large"));
  EXPECT_TRUE(at().question.chosen.isEmpty());
  // A frame of the screen before is not this one's.
  advance(20);
  nurse->choose(QStringLiteral("large"));
  EXPECT_EQ(at().question.chosen, QStringLiteral("large"));
  // Enter is held: it confirms this question, not the next.
  nurse->setInputHeld(true);
  nurse->next();
  ASSERT_TRUE(stored());
  look();
  nurse->choose(QStringLiteral("large"));
  EXPECT_TRUE(at().question.chosen.isEmpty());
  nurse->setInputHeld(false);
  advance(310);
  nurse->choose(QStringLiteral("large"));
  EXPECT_EQ(at().question.chosen, QStringLiteral("large"));
  getUp();
  EXPECT_EQ(answersInFile().size(), 2U);
}

TEST_F(CourseQuestionsTest, TheTimeOfAnAnswerCountsFromTheFirstFrame) {
  beginQuestions();
  advance(5000);  // a slow machine: not painted yet
  nurse->painted(at().serial);
  advance(2000);
  nurse->choose(QStringLiteral("small"));
  advance(500);
  nurse->next();
  ASSERT_TRUE(stored());
  getUp();
  EXPECT_NEAR(answersInFile()[0].response_s, 2.5, 1e-9);  // both times are whole milliseconds
}

TEST_F(CourseQuestionsTest, BackShowsTheAnswerAndAChangeIsANewRecord) {
  beginQuestions();
  answer("small");
  answer("large");
  look();
  nurse->back();
  ASSERT_TRUE(stored());
  EXPECT_EQ(at().question.position, 2);
  EXPECT_EQ(at().question.chosen, QStringLiteral("large"));
  next();  // unchanged: no record
  EXPECT_EQ(at().question.position, 3);
  look();
  nurse->back();
  ASSERT_TRUE(stored());
  answer("medium");
  EXPECT_EQ(at().question.position, 3);
  getUp();
  const auto answers = answersInFile();
  ASSERT_EQ(answers.size(), 3U);
  EXPECT_EQ(answers[2].entry.supersedes, answers[1].entry.id);
}

TEST_F(CourseQuestionsTest, ACellOfTheReviewIsChangedAndLeadsBack) {
  beginQuestions();
  for (int question = 0; question < 45; ++question) {
    if (screen() == Screen::kRest) next();
    answer("medium");
  }
  ASSERT_EQ(screen(), Screen::kReview);
  look();
  nurse->changeItem(7);
  ASSERT_TRUE(stored());
  ASSERT_EQ(screen(), Screen::kQuestion);
  EXPECT_EQ(at().question.item, 7);
  EXPECT_TRUE(at().question.from_review);
  answer("very_large");
  ASSERT_EQ(screen(), Screen::kReview);
  EXPECT_EQ(at().review.answers[6].word, QStringLiteral("very_large"));
  look();
  nurse->changeItem(3);
  ASSERT_TRUE(stored());
  next();  // as it was
  ASSERT_EQ(screen(), Screen::kReview);
  getUp();
  EXPECT_EQ(answersInFile().size(), 46U);
}

TEST_F(CourseQuestionsTest, AFullDiskIsSaidAndNothingIsAnsweredMeanwhile) {
  beginQuestions();
  const auto full = std::make_shared<std::atomic<bool>>(true);
  study->order([full](store::StudyFile&, study::RecordIds&) -> base::Result<void> {
    if (*full) return base::fail(base::ErrorCode::kIo, "disk", "no space left", "free space");
    return {};
  });
  choose("small");
  nurse->next();
  ASSERT_TRUE(comesTrue([this] { return at().failed; }));
  EXPECT_EQ(at().question.position, 1);
  EXPECT_FALSE(at().can_go_on);
  *full = false;
  study->storeNow();
  ASSERT_TRUE(stored());
  EXPECT_FALSE(at().failed);
  EXPECT_EQ(at().question.position, 2);
}

}  // namespace
}  // namespace tactus::workbench
