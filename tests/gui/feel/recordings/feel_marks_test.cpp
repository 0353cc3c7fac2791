#include "app/workbench/feel/recordings/feel_marks.h"

#include <QSignalSpy>
#include <gtest/gtest.h>

#include "app/workbench/feel/recordings/feel_store.h"
#include "app/workbench/study/connection/study_connection.h"
#include "core/store/feel_records.h"

#include "tests/gui/feel/feel_test.h"
#include "tests/gui/sample_study.h"

namespace tactus::workbench {
namespace {

using tests::comesTrue;

class FeelMarksTest : public FeelTest {
 protected:
  void openStudy() {
    tests::makeStudyFile(path);
    study.open(path);
    ASSERT_TRUE(comesTrue([this] { return study.isOpen() && !study.isOpening(); }));
  }
  void TearDown() override { study.close(); }

  QString path = folder.path(QStringLiteral("felt.tactus"));
  StudyConnection study;
  FeelStore store{feel, scene, study, [] { return std::optional<study::RecordId>(); }};
  FeelMarks marks{feel, scene, study, store};
};

TEST_F(FeelMarksTest, KeepsWhatTheHandFeelsAndReturnsToIt) {
  openStudy();
  feel.start(QStringLiteral("virtual"));
  push();
  const double depth_mm = feel.depthMm();
  const double force_n = feel.latest().force_n;
  ASSERT_GT(force_n, 0);
  marks.mark();
  ASSERT_EQ(marks.marks().size(), 1U);
  const study::FeelMark mark = marks.marks()[0];
  EXPECT_EQ(mark.depth_mm, depth_mm);
  EXPECT_EQ(mark.force_n, force_n);
  EXPECT_NEAR(mark.model_force_n, kLowN, kFeltRounding);
  EXPECT_EQ(mark.setting.model, "Two experts");
  EXPECT_TRUE(mark.setting.simulated);

  // In the far region; then back, with the tube in the hand.
  time.moveTo(feel, 25, 20);  // the hand gives way to the force
  ASSERT_GT(feel.depthMm(), 7);
  QSignalSpy said(&marks, &FeelMarks::said);
  QSignalSpy differs(&marks, &FeelMarks::differs);
  feel.session().setHeld(false);
  time.advance(feel, 100);
  marks.returnTo(0);
  time.advance(feel, 50);
  EXPECT_NEAR(feel.depthMm(), depth_mm, 1e-9);
  EXPECT_EQ(differs.count(), 0);
  EXPECT_EQ(said.count(), 1);
  feel.newPlacement();
  time.advance(feel, 50);
  EXPECT_NEAR(feel.depthMm(), 0, 1e-9) << "another placement begins outside again";
  feel.stop();
  scene.setValue(tests::kDepth, 9);
  marks.returnTo(0);
  EXPECT_NEAR(scene.value(tests::kDepth), depth_mm, 1e-9);

  // The model has changed: it is said with both forces.
  models.edit(*editing::ready(harder()));
  marks.returnTo(0);
  ASSERT_EQ(differs.count(), 1);
  const QString sentence = differs.front().front().toString();
  EXPECT_TRUE(sentence.contains(QStringLiteral("0.25 N"))) << sentence.toStdString();
  EXPECT_TRUE(sentence.contains(QStringLiteral("0.75 N"))) << sentence.toStdString();
}

TEST_F(FeelMarksTest, AreInTheStudyWhenItIsOpenedAgain) {
  openStudy();
  feel.start(QStringLiteral("virtual"));
  push();
  marks.mark();
  marks.mark();
  const auto kept = marks.marks();
  feel.stop();
  ASSERT_TRUE(comesTrue([this] { return !study.isBusy(); }));
  study.close();
  ASSERT_TRUE(comesTrue([this] { return !study.isOpen(); }));
  EXPECT_TRUE(marks.marks().empty());
  study.open(path);
  ASSERT_TRUE(comesTrue([this] { return marks.marks().size() == 2; }));
  EXPECT_EQ(marks.marks()[0].depth_mm, kept[0].depth_mm);
  EXPECT_EQ(marks.marks()[0].force_n, kept[0].force_n);
}

TEST_F(FeelMarksTest, NothingIsMarkedThatNoHandFeels) {
  QSignalSpy said(&marks, &FeelMarks::said);
  marks.mark();
  EXPECT_TRUE(marks.marks().empty());
  feel.start(QStringLiteral("virtual"));
  time.advance(feel, 50);
  marks.mark();
  EXPECT_TRUE(marks.marks().empty());
  EXPECT_EQ(said.count(), 2);
  push();
  marks.mark();
  EXPECT_EQ(marks.marks().size(), 1U) << "without a study too";
  EXPECT_EQ(said.count(), 3);
  marks.returnTo(7);  // none
}

}  // namespace
}  // namespace tactus::workbench
