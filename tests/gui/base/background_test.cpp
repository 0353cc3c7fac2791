#include <QTest>
#include <atomic>
#include <gtest/gtest.h>
#include <semaphore>

#include "app/workbench/base/worker.h"

#include "tests/gui/patience.h"

namespace tactus::workbench {
namespace {

using tests::kPatience;

TEST(Background, DeliversOnTheThreadOfTheGui) {
  Background background;
  const auto gui = std::this_thread::get_id();
  std::thread::id computed;
  std::thread::id delivered;
  background.run([&](const std::stop_token&) -> Background::Deliver {
    computed = std::this_thread::get_id();
    return [&] { delivered = std::this_thread::get_id(); };
  });
  EXPECT_TRUE(background.isBusy());
  ASSERT_TRUE(QTest::qWaitFor([&] { return !background.isBusy(); }, kPatience));
  EXPECT_EQ(delivered, gui);
  EXPECT_NE(computed, gui);
}

TEST(Background, OnlyTheNewestJobCounts) {
  Background background;
  std::binary_semaphore began(0);
  std::binary_semaphore go_on(0);
  std::atomic<bool> told_to_stop = false;
  int delivered = 0;
  background.run([&](const std::stop_token& stop) -> Background::Deliver {
    began.release();
    go_on.acquire();
    told_to_stop = stop.stop_requested();
    return [&] { delivered += 1; };
  });
  began.acquire();
  background.run([&](const std::stop_token&) -> Background::Deliver { return [&] { delivered += 10; }; });
  background.run([&](const std::stop_token&) -> Background::Deliver { return [&] { delivered += 100; }; });
  go_on.release();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !background.isBusy(); }, kPatience));
  EXPECT_EQ(delivered, 100);
  EXPECT_TRUE(told_to_stop);
}

TEST(Background, WhatIsDroppedIsNotDelivered) {
  Background background;
  bool delivered = false;
  std::binary_semaphore done(0);
  background.run([&](const std::stop_token&) -> Background::Deliver {
    done.release();
    return [&] { delivered = true; };
  });
  done.acquire();
  background.drop();
  EXPECT_FALSE(background.isBusy());
  // A later job ends after every event of the first one.
  background.run([](const std::stop_token&) -> Background::Deliver { return [] {}; });
  ASSERT_TRUE(QTest::qWaitFor([&] { return !background.isBusy(); }, kPatience));
  EXPECT_FALSE(delivered);
}

TEST(Background, EndsWithAJobThatRuns) {
  std::atomic<bool> ended = false;
  {
    Background background;
    std::binary_semaphore began(0);
    background.run([&](const std::stop_token& stop) -> Background::Deliver {
      began.release();
      while (!stop.stop_requested()) std::this_thread::yield();
      ended = true;
      return [] { FAIL() << "nobody is there any more"; };
    });
    began.acquire();
  }
  EXPECT_TRUE(ended);
  QCoreApplication::processEvents();
}

}  // namespace
}  // namespace tactus::workbench
