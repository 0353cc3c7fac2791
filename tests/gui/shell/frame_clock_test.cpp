#include "app/workbench/shell/frame_clock.h"

#include <QSignalSpy>
#include <QTest>
#include <QVBoxLayout>
#include <QWidget>
#include <gtest/gtest.h>
#include <memory>

#include "app/workbench/base/refresh.h"

#include "tests/gui/patience.h"

namespace tactus::workbench {
namespace {

/// Counts how often it is painted.
class Canvas : public QWidget {
 public:
  using QWidget::QWidget;
  int painted = 0;

 protected:
  void paintEvent(QPaintEvent* /*event*/) override { ++painted; }
};

class FrameClockTest : public testing::Test {
 protected:
  void SetUp() override {
    for (Canvas* canvas : {first, second}) canvas->setFixedSize(40, 40);
    window.show();
    ASSERT_TRUE(QTest::qWaitFor([this] { return first->painted > 0 && second->painted > 0; }, tests::kPatience));
    first->painted = second->painted = 0;
  }

  QWidget window;
  QVBoxLayout* layout = new QVBoxLayout(&window);
  Canvas* first = new Canvas;
  Canvas* second = new Canvas;
  bool placed = (layout->addWidget(first), layout->addWidget(second), true);
  Refresh* of_first = new Refresh(first, [this] { first->update(); });
  Refresh* of_second = new Refresh(second, [this] { second->update(); });
  std::int64_t now_ns = 0;
  FrameClock clock{window, nullptr, [this] { return now_ns; }};
  QSignalSpy measured{&clock, &FrameClock::measured};
};

TEST_F(FrameClockTest, ItEndsWhenTheLastPanelIsPainted) {
  int first_painted = 0;
  int second_painted = 0;
  QObject::connect(&clock, &FrameClock::measured, &clock, [&] {
    first_painted = first->painted;
    second_painted = second->painted;
  });
  clock.begin();
  of_first->request();
  of_second->request();
  clock.sent();
  ASSERT_TRUE(QTest::qWaitFor([this] { return measured.count() == 1; }, tests::kPatience));
  EXPECT_EQ(first_painted, 1);
  EXPECT_EQ(second_painted, 1);
  EXPECT_EQ(clock.painted()->edits, 1U);
}

TEST_F(FrameClockTest, WhatHappensMeanwhileIsCounted) {
  clock.begin();
  now_ns += 20'000'000;
  of_first->request();
  clock.sent();
  ASSERT_TRUE(QTest::qWaitFor([this] { return measured.count() == 1; }, tests::kPatience));
  EXPECT_EQ(clock.painted()->last_ms, 20);
}

TEST_F(FrameClockTest, HiddenPanelsAreNotWaitedFor) {
  second->hide();
  clock.begin();
  of_first->request();
  of_second->request();
  clock.sent();
  EXPECT_TRUE(QTest::qWaitFor([this] { return measured.count() == 1; }, tests::kPatience));
  EXPECT_EQ(second->painted, 0);
}

TEST_F(FrameClockTest, ACoarsePictureAndTheFinestOneAreTwoTimes) {
  of_first->setRefining(true);
  clock.begin();
  of_second->request();
  clock.sent();
  ASSERT_TRUE(QTest::qWaitFor([this] { return clock.painted().has_value(); }, tests::kPatience));
  EXPECT_FALSE(clock.finest().has_value());
  EXPECT_EQ(measured.count(), 0);
  now_ns += 5'000'000;
  of_first->setRefining(false);
  ASSERT_TRUE(QTest::qWaitFor([this] { return measured.count() == 1; }, tests::kPatience));
  EXPECT_EQ(clock.painted()->last_ms, 0);
  EXPECT_EQ(clock.finest()->last_ms, 5);
}

TEST_F(FrameClockTest, TheOlderOfTwoEditsInAFrameCounts) {
  clock.begin();
  of_first->request();
  clock.sent();
  now_ns += 20'000'000;
  clock.begin();
  of_first->request();
  clock.sent();
  ASSERT_TRUE(QTest::qWaitFor([this] { return measured.count() == 1; }, tests::kPatience));
  EXPECT_EQ(clock.painted()->edits, 1U);
  EXPECT_EQ(clock.painted()->last_ms, 20);
}

TEST_F(FrameClockTest, NothingIsMeasuredWhereNobodyLooks) {
  window.hide();
  clock.begin();
  of_first->request();
  clock.sent();
  QCoreApplication::processEvents();
  EXPECT_FALSE(clock.painted().has_value());
}

TEST_F(FrameClockTest, MedianAndLargestAreOfAllEdits) {
  for (const int ms : {30, 0, 0}) {
    clock.begin();
    now_ns += ms * 1'000'000;
    of_first->request();
    clock.sent();
    const auto before = measured.count();
    ASSERT_TRUE(QTest::qWaitFor([&] { return measured.count() > before; }, tests::kPatience));
  }
  const auto times = clock.painted();
  EXPECT_EQ(times->edits, 3U);
  EXPECT_EQ(times->largest_ms, 30);
  EXPECT_EQ(times->median_ms, 0);
}

TEST(RefreshTest, AThousandRequestsAreOnePieceOfWorkPerFrame) {
  QWidget panel;
  int done = 0;
  Refresh refresh(&panel, [&done] { ++done; });
  panel.show();
  QCoreApplication::processEvents();
  QElapsedTimer clock;
  clock.start();
  for (int i = 0; i < 1000; ++i) {
    refresh.request();
    QCoreApplication::processEvents();
  }
  ASSERT_TRUE(QTest::qWaitFor([&] { return !refresh.isDue(); }, tests::kPatience));
  EXPECT_GE(done, 2);
  EXPECT_LE(done, clock.elapsed() / Refresh::kFrameMs + 2);
}

TEST_F(FrameClockTest, InADragEachEditCountsFromItsOwnBeginning) {
  // Each edit comes while the panel works for the one before, so that something is always still to be done.
  int left = 4;
  Refresh* panel = nullptr;
  panel = new Refresh(first, [&] {
    first->update();
    now_ns += 20'000'000;
    if (left-- == 0) return;
    clock.begin();
    panel->request();
    clock.sent();
  });
  clock.begin();
  panel->request();
  clock.sent();
  ASSERT_TRUE(QTest::qWaitFor([this] { return measured.count() == 1; }, tests::kPatience));
  EXPECT_EQ(clock.painted()->edits, 5U);
  EXPECT_EQ(clock.painted()->largest_ms, 20);
}

}  // namespace
}  // namespace tactus::workbench
