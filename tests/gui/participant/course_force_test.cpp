// The forces on the course of the screens.
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
using Phase = ForceState::Phase;

using CourseForceTest = CourseTest;

TEST_F(CourseForceTest, ForceOffIsAtOnceAndTheStepComesAgain) {
  beginForce();
  nurse->painted(at().serial);
  advance(2300);
  device->setHeld(true);
  advance(300);
  ASSERT_GT(device->latest().force_n, 0.15);
  nurse->forceOff();
  EXPECT_EQ(at().overlay, ForceOffOverlay::kForceOff);
  advance(60);
  EXPECT_EQ(device->latest().force_n, 0);
  device->setHeld(false);
  nurse->next();
  nurse->resume();  // the key that stopped the force is no answer to the overlay
  EXPECT_EQ(at().overlay, ForceOffOverlay::kForceOff);
  ASSERT_TRUE(stored());
  look();
  nurse->resume();
  ASSERT_TRUE(stored());
  EXPECT_EQ(at().overlay, ForceOffOverlay::kNone);
  EXPECT_EQ(screen(), Screen::kForce);
  steps->moveTo(*device, 0, 200);
  judge("small");
  getUp();
  const auto judgements = judgementsInFile();
  ASSERT_EQ(judgements.size(), 1U);
  EXPECT_EQ(judgements[0].attempt, 1);
  EXPECT_TRUE(judgements[0].scored);
}

TEST_F(CourseForceTest, ThePauseOfTheResearcherTakesTheForceAway) {
  beginForce();
  nurse->painted(at().serial);
  advance(2300);
  device->setHeld(true);
  advance(300);
  ASSERT_GT(device->latest().force_n, 0.15);
  nurse->session().pause("the phone rings");
  ASSERT_TRUE(stored());
  EXPECT_TRUE(at().paused);
  advance(60);
  EXPECT_EQ(device->latest().force_n, 0);
  device->setHeld(false);
  look();
  nurse->next();
  EXPECT_FALSE(at().can_go_on);
  nurse->session().unpause();
  ASSERT_TRUE(stored());
  EXPECT_FALSE(at().paused);
  judge("small");
  getUp();
  EXPECT_EQ(judgementsInFile().size(), 1U);
}

TEST_F(CourseForceTest, AnUnpluggedDeviceIsToldAndItsStepComesAgain) {
  haptics::VirtualDeviceSettings settings;
  // The second start of the device finds it as new.
  settings.faults = {{haptics::InjectedFault::kUnplugged, 12, 1e6}};
  tests::SteppedFeel faulty(settings);
  steps = &faulty;
  beginForce();
  nurse->painted(at().serial);
  device->setHeld(true);
  for (int i = 0; i < 200 && screen() == Screen::kForce; ++i) advance(100);
  ASSERT_EQ(screen(), Screen::kDeviceCheck);
  EXPECT_EQ(at().device, DeviceStep::kWrong);
  EXPECT_EQ(device->latest().force_n, 0);
  device->setHeld(false);
  EXPECT_TRUE(at().can_go_on) << "she may try again";
  next();
  ASSERT_EQ(device->state(), DeviceSession::State::kRunning);
  steps->moveTo(*device, 0, 200);
  checkDevice();
  judge("small");
  getUp();
  ASSERT_EQ(judgementsInFile().size(), 1U);
}

TEST_F(CourseForceTest, TheButtonOfTheDeviceLightsWordsFromAnyEnd) {
  beginForce();
  feel();
  look();
  nurse->lightNext();
  const QString first = at().force.lit;
  EXPECT_FALSE(first.isEmpty());
  EXPECT_TRUE(at().force.chosen.isEmpty()) << "lit is not chosen";
  for (std::size_t i = 0; i < 7; ++i) nurse->lightNext();  // five words and two more answers
  EXPECT_EQ(at().force.lit, first);
  nurse->answerLit();
  // The end is drawn: with "beyond what I meet in practice" the series would end here, so the same button confirms it.
  EXPECT_EQ(at().force.sure, first == QStringLiteral("beyond_practice"));
  if (at().force.sure) {
    look();
    nurse->answerLit();
  }
  ASSERT_TRUE(stored());
  if (first != QStringLiteral("beyond_practice")) {
    ASSERT_EQ(screen(), Screen::kForce) << "the next force";
  }
  getUp();
  ASSERT_EQ(judgementsInFile().size(), 1U);
  const auto events = *store::events(tests::lookInto(path), {{}, {}, true});
  const auto by_button = [](const auto& event) {
    const auto line = *session::answerInputIn(event);
    return line && line->input.means == session::InputMeans::kDeviceButton && line->input.presses == 8;
  };
  EXPECT_EQ(std::count_if(events.begin(), events.end(), by_button), 1);
}

TEST_F(CourseForceTest, BackChangesTheWordOfTheForceBeforeAndKeepsBoth) {
  plan.settings.force.ladder = {0.2, 0.6, 0.2};
  beginForce();
  EXPECT_FALSE(at().can_go_back) << "there is none before";
  judge("small");
  look();
  ASSERT_TRUE(at().can_go_back);
  nurse->back();
  EXPECT_TRUE(at().force.before);
  EXPECT_EQ(at().force.phase, Phase::kAnswer);
  EXPECT_EQ(at().force.chosen, QStringLiteral("small"));
  advance(3000);
  EXPECT_EQ(device->latest().force_n, 0) << "nothing is felt meanwhile";
  look();
  nurse->back();  // it was right
  EXPECT_FALSE(at().force.before);
  look();
  nurse->back();
  answer("medium");
  EXPECT_FALSE(at().force.before);
  judge("large");
  // A slip: this would have been the end of the series, so she is asked once whether she means it.
  judge("beyond_practice");
  ASSERT_EQ(screen(), Screen::kForce);
  EXPECT_TRUE(at().force.sure);
  nurse->next();
  EXPECT_EQ(screen(), Screen::kForce) << "the press that chose it does not confirm it too";
  look();
  nurse->choose(QStringLiteral("very_large"));
  EXPECT_FALSE(at().force.sure) << "another word needs no such question";
  nurse->choose(QStringLiteral("beyond_practice"));
  nurse->next();
  ASSERT_TRUE(at().force.sure);
  next();
  ASSERT_EQ(screen(), Screen::kRating);
  look();
  ASSERT_TRUE(at().can_go_back);
  nurse->back();
  ASSERT_EQ(screen(), Screen::kForce);
  answer("very_large");
  ASSERT_EQ(screen(), Screen::kRating);
  getUp();
  const auto all = judgementsInFile();
  ASSERT_EQ(all.size(), 5U);
  EXPECT_EQ(all[1].entry.supersedes, all[0].entry.id);
  EXPECT_EQ(all[1].term, "medium");
  EXPECT_EQ(all[1].forward_mm, all[0].forward_mm);
  EXPECT_EQ(all[4].entry.supersedes, all[3].entry.id);
  EXPECT_EQ(all[4].term, "very_large");
}

}  // namespace
}  // namespace tactus::workbench
