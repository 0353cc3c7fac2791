#include "app/workbench/base/worker.h"

#include <QTest>
#include <gtest/gtest.h>
#include <memory>
#include <numeric>
#include <semaphore>
#include <vector>

#include "tests/gui/patience.h"

namespace tactus::workbench {
namespace {

using tests::kPatience;
constexpr std::size_t kTasks = 1000;

std::vector<int> upTo(std::size_t count) {
  std::vector<int> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

TEST(Worker, DoesItsTasksInOrderOnOneOtherThread) {
  std::vector<int> done;
  std::thread::id other;
  Worker worker;
  worker.waitForDone();  // there is nothing to wait for
  worker.post([&] { other = std::this_thread::get_id(); });
  for (const int number : upTo(kTasks)) {
    worker.post([&, number] {
      if (std::this_thread::get_id() == other) done.push_back(number);
    });
  }
  worker.waitForDone();
  EXPECT_EQ(done, upTo(kTasks));
  EXPECT_NE(other, std::this_thread::get_id());
}

TEST(Worker, EndsWhenEverythingIsDone) {
  std::vector<int> done;
  {
    Worker worker;
    std::binary_semaphore go_on(0);
    worker.post([&] { go_on.acquire(); });
    for (const int number : upTo(kTasks)) worker.post([&, number] { done.push_back(number); });
    go_on.release();
    // A task is let go of together with what it holds.
    const auto held = std::make_shared<int>(1);
    worker.post([held] {});
    worker.waitForDone();
    EXPECT_EQ(held.use_count(), 1);
    worker.post([&] { done.push_back(static_cast<int>(kTasks)); });
  }
  EXPECT_EQ(done, upTo(kTasks + 1));
}

TEST(CallQueue, CallsInOrderOnTheThreadOfTheGui) {
  const auto gui = std::this_thread::get_id();
  std::vector<int> called;
  CallQueue box;
  Worker worker;
  for (const int number : upTo(kTasks)) {
    worker.post([&, number] {
      box.post([&, number] {
        if (std::this_thread::get_id() == gui) called.push_back(number);
      });
    });
  }
  worker.waitForDone();
  EXPECT_TRUE(called.empty());
  ASSERT_TRUE(QTest::qWaitFor([&] { return called.size() >= kTasks; }, kPatience));
  EXPECT_EQ(called, upTo(kTasks));
}

TEST(CallQueue, MakesNoCallOnceItIsGone) {
  bool called = false;
  bool told = false;
  CallQueue other;
  {
    CallQueue box;
    box.post([&] { called = true; });
  }
  other.post([&] { told = true; });
  ASSERT_TRUE(QTest::qWaitFor([&] { return told; }, kPatience));
  EXPECT_FALSE(called);
}

// A call may make another one, or end the box that makes it.
TEST(CallQueue, MayGoInTheMiddleOfACall) {
  auto box = std::make_unique<CallQueue>();
  bool ended = false;
  box->post([&] {
    box->post([&] { ADD_FAILURE() << "called by a box that is gone"; });
    box.reset();
    ended = true;
  });
  ASSERT_TRUE(QTest::qWaitFor([&] { return ended; }, kPatience));
  QTest::qWait(0);
}

}  // namespace
}  // namespace tactus::workbench
