#include "app/workbench/labs/data/lab_data.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <algorithm>
#include <atomic>
#include <functional>
#include <gtest/gtest.h>
#include <semaphore>

#include "tests/gui/labs/lab_study_file.h"
#include "tests/gui/sample_study.h"

namespace tactus::workbench {
namespace {

using tests::comesTrue;

template <class T>
using Work = Computed<LabInputs, T>;

class LabDataTest : public testing::Test {
 protected:
  void open() {
    study.open(path);
    ASSERT_TRUE(comesTrue([this] { return study.isOpen(); }));
  }

  QTemporaryDir folder;
  QString path = tests::demoStudyIn(folder);
  StudyConnection study;
  LabData data{study};
};

TEST_F(LabDataTest, NothingIsReadUntilALabIsOnTheScreen) {
  open();
  EXPECT_FALSE(data.isReading());
  EXPECT_EQ(data.study(), nullptr);
  QObject lab;
  data.hold(lab);
  EXPECT_TRUE(data.isReading());
  ASSERT_TRUE(comesTrue([this] { return data.study() != nullptr; }));
  EXPECT_EQ(data.study()->study.participants.size(), 4U);
  const auto accepted = std::count_if(data.study()->strokes.begin(), data.study()->strokes.end(),
                                      [](const auto& one) { return !one.practice && one.verdict == "accepted"; });
  EXPECT_EQ(accepted, 48);  // of four nurses three levels of four strokes
  EXPECT_EQ(data.study()->codeOf(data.study()->strokes.front().entry.session), "S1");
  study.close();
  ASSERT_TRUE(comesTrue([this] { return !study.isOpen(); }));
  EXPECT_EQ(data.study(), nullptr);
}

TEST_F(LabDataTest, WhileASessionRunsReadingWaits) {
  open();
  data.setSessionRunning(true);
  QObject lab;
  data.hold(lab);
  data.refresh();
  EXPECT_FALSE(data.isReading());
  data.setSessionRunning(false);
  EXPECT_TRUE(comesTrue([this] { return data.study() != nullptr; }));
}

TEST_F(LabDataTest, WorkRunsWhileItIsWantedAndStartsAgainWithASetting) {
  open();
  std::vector<double> seen;
  Work<double> work([this] { return data.inputs(); },
                    [](const LabInputs& from, const RunOf<double>& run) {
                      run.progress(0.5);
                      return std::make_shared<const double>(from.settings.speed.alpha);
                    });
  followLabData(work, data);
  QObject::connect(&work, &Computation::valueChanged, &work, [&] { seen.push_back(*work.value()); });
  QObject view;
  work.hold(view);
  ASSERT_TRUE(comesTrue([&] { return seen.size() == 1 && !work.isBusy(); }));
  auto settings = data.settings();
  settings.speed.alpha = 0.75;
  data.setSettings(settings);
  ASSERT_TRUE(comesTrue([&] { return seen.size() == 2; }));
  EXPECT_EQ(seen.back(), 0.75);
  work.hold(view, false);
  settings.speed.alpha = 0.8;
  data.setSettings(settings);
  EXPECT_FALSE(work.isBusy());
  work.hold(view);
  ASSERT_TRUE(comesTrue([&] { return seen.size() == 3; }));
  EXPECT_EQ(seen.back(), 0.8);
}

TEST_F(LabDataTest, ACanceledRunDeliversNothingAndTheNextChangeStartsAgain) {
  open();
  std::binary_semaphore started{0};
  std::counting_semaphore<> may_end{0};
  std::atomic<int> runs = 0;
  std::vector<int> delivered;  // the number of the run, for each result
  Work<int> work([this] { return data.inputs(); },
                 [&](const LabInputs&, const RunOf<int>& run) {
                   const int number = ++runs;
                   run.hand(number);
                   if (number == 1) started.release();
                   may_end.acquire();
                   return std::make_shared<const int>(number);
                 });
  followLabData(work, data);
  QObject::connect(&work, &Computation::valueChanged, &work, [&] { delivered.push_back(*work.value()); });
  QObject view;
  work.hold(view);
  ASSERT_TRUE(comesTrue([&] { return started.try_acquire(); }));
  work.cancel();
  const int canceled = runs;
  EXPECT_FALSE(work.isBusy());
  EXPECT_TRUE(work.isCanceled());
  delivered.clear();
  may_end.release(10);  // the study may be read once more meanwhile, which starts a run of its own
  data.setSettings(data.settings());
  EXPECT_FALSE(work.isCanceled());
  ASSERT_TRUE(comesTrue([&] { return !delivered.empty() && !work.isBusy(); }));
  for (const int number : delivered) EXPECT_GT(number, canceled);
  // The first result and the last one of the last run.
  ASSERT_GE(delivered.size(), 2U);
  EXPECT_EQ(delivered.back(), delivered[delivered.size() - 2]);
}

TEST_F(LabDataTest, ARunSaysWhatItIsDoingAndTheNextOneBeginsAnew) {
  open();
  std::counting_semaphore<> may_end{0};
  Work<int> work([this] { return data.inputs(); },
                 [&may_end](const LabInputs&, const RunOf<int>& run) -> Work<int>::Answer {
                   run.say(QStringLiteral("Drawing strokes"));
                   may_end.acquire();
                   return nullptr;
                 });
  followLabData(work, data);
  QObject view;
  work.hold(view);
  EXPECT_TRUE(work.doing().isEmpty());
  ASSERT_TRUE(comesTrue([&] { return work.doing() == QLatin1String("Drawing strokes"); }));
  work.refresh();
  EXPECT_TRUE(work.doing().isEmpty());
  may_end.release(10);
}

TEST_F(LabDataTest, WhatIsShownComesEvenIfASettingHasMovedButNotAfterACancel) {
  open();
  std::binary_semaphore started{0};
  std::binary_semaphore may_show{0};
  std::vector<std::pair<double, bool>> shown;  // alpha of the run, and whether that is still the setting
  std::vector<double> ended;
  struct Value {
    double alpha;
    bool last;
  };
  Work<Value> work([this] { return data.inputs(); },
                   [&](const LabInputs& from, const RunOf<Value>& run) -> Work<Value>::Answer {
                     const double alpha = from.settings.speed.alpha;
                     if (alpha == 0.6) {
                       started.release();
                       may_show.acquire();
                       EXPECT_TRUE(run.stop.stop_requested());
                       if (run.given_up()) return nullptr;
                     }
                     run.show({alpha, false});
                     return std::make_shared<const Value>(Value{alpha, true});
                   });
  followLabData(work, data);
  QObject::connect(&work, &Computation::valueChanged, &work, [&] {
    const Value& now = *work.value();
    if (now.last) {
      ended.push_back(now.alpha);
    } else {
      shown.emplace_back(now.alpha, work.isCurrent());
    }
  });
  QObject view;
  const auto set = [this](double alpha) {
    auto settings = data.settings();
    settings.speed.alpha = alpha;
    data.setSettings(settings);
  };
  work.hold(view);
  ASSERT_TRUE(comesTrue([&] { return !ended.empty() && !work.isBusy() && !data.isReading(); }));
  const auto moveAway = [&](const std::function<void()>& move) {
    shown.clear();
    ended.clear();
    set(0.6);
    EXPECT_TRUE(comesTrue([&] { return started.try_acquire(); }));
    move();
    may_show.release();
  };
  moveAway([&] { set(0.7); });
  ASSERT_TRUE(comesTrue([&] { return !ended.empty() && !work.isBusy(); }));
  EXPECT_EQ(shown, (std::vector<std::pair<double, bool>>{{0.6, false}, {0.7, true}}));
  EXPECT_EQ(ended, std::vector<double>{0.7});
  moveAway([&] { work.cancel(); });
  set(0.7);
  ASSERT_TRUE(comesTrue([&] { return !ended.empty() && !work.isBusy(); }));
  EXPECT_EQ(shown, (std::vector<std::pair<double, bool>>{{0.7, true}}));
}

TEST_F(LabDataTest, TheModelIsBuiltWithTheSettingsAndSaysThem) {
  open();
  LabModel model(data);
  QObject lab;
  model.hold(lab);
  ASSERT_TRUE(comesTrue([&] { return model.built() != nullptr; }));
  EXPECT_EQ(model.built()->experts.size(), 4U);
  // The paper's terms with alpha 0.95 on simulated strokes (facts: 51.5 102.0 126.6 187.0).
  const auto before = model.built()->averaged_ramps;
  ASSERT_EQ(before.size(), 2U);
  EXPECT_NEAR(before[0].p, 51.5, 3);
  auto settings = data.settings();
  settings.speed.alpha = 1;
  data.setSettings(settings);
  ASSERT_TRUE(comesTrue([&] { return model.value()->settings.speed.alpha == 1; }));
  EXPECT_EQ(model.built()->averaged_ramps[0].q, model.built()->averaged_ramps[1].p);  // medium is a triangle
  // Another m clusters again, another alpha does not; both give what the settings give by themselves.
  settings.speed.fcm.m = 2.5;
  data.setSettings(settings);
  ASSERT_TRUE(comesTrue([&] { return model.value()->settings.speed.fcm.m == 2.5; }));
  const auto afresh = elicitation::buildModel(data.study()->study, data.study()->forms, settings).value();
  EXPECT_EQ(model.built()->averaged_ramps, afresh.averaged_ramps);
  EXPECT_EQ(model.built()->notes, afresh.notes);
}

}  // namespace
}  // namespace tactus::workbench
