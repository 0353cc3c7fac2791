// A value that another thread computes while it is held.
#include "app/workbench/base/computed.h"

#include <QCoreApplication>
#include <QTest>
#include <algorithm>
#include <atomic>
#include <gtest/gtest.h>
#include <optional>
#include <random>
#include <semaphore>
#include <thread>
#include <tuple>
#include <vector>

#include "tests/gui/patience.h"

namespace tactus::workbench {
namespace {

using tests::kPatience;

std::uint64_t mixed(std::uint64_t of) {
  for (int i = 0; i < 2'000; ++i) of = of * 6'364'136'223'846'793'005U + 1'442'695'040'888'963'407U;
  return of;
}

// Inputs change 1,000 times while the view that holds the value is shown and hidden at random.
TEST(Computed, AfterAThousandChangesTheValueIsThatOfASynchronousRunAndNothingIsComputedWhileHidden) {
  constexpr std::size_t kChanges = 1'000;
  std::size_t input = 0;
  std::vector<char> held_at(kChanges + 1, 0);                // by input: whether the view was shown then
  std::vector<std::atomic<bool>> computed_at(kChanges + 1);  // by input; written by the other thread
  Computed<std::size_t, std::uint64_t> cell([&] { return std::optional(input); },
                                            [&](std::size_t of, const auto&) {
                                              computed_at[of] = true;
                                              return std::make_shared<const std::uint64_t>(mixed(of));
                                            });
  std::vector<std::size_t> seen;
  QObject::connect(&cell, &Computation::valueChanged, &cell, [&] {
    ASSERT_NE(cell.value(), nullptr);
    EXPECT_EQ(*cell.value(), mixed(*cell.of()));
    EXPECT_TRUE(cell.isHeld());
    seen.push_back(*cell.of());
  });
  std::mt19937 random(7);
  QObject view;
  const auto show = [&](bool shown) {
    cell.hold(view, shown);
    held_at[input] |= shown ? 1 : 0;
  };
  for (input = 1; input <= kChanges; ++input) {
    held_at[input] = cell.isHeld() ? 1 : 0;
    cell.refresh();
    EXPECT_EQ(cell.isBusy(), cell.isHeld());
    switch (random() % 8) {
      case 0: show(false); break;
      case 1: show(true); break;
      case 2: QCoreApplication::processEvents(); break;
      case 3: std::ignore = QTest::qWaitFor([&] { return !cell.isBusy(); }, kPatience); break;
      default: break;
    }
    if (!cell.isHeld()) {
      EXPECT_FALSE(cell.isBusy());
    }
  }
  input = kChanges;
  show(true);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !cell.isBusy(); }, kPatience));
  EXPECT_EQ(*cell.of(), kChanges);
  EXPECT_EQ(*cell.value(), mixed(kChanges));
  EXPECT_GT(seen.size(), 10U);
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end())) << "results come in the order of their inputs";
  std::size_t hidden = 0;
  for (std::size_t i = 1; i <= kChanges; ++i) {
    hidden += held_at[i] != 0 ? 0 : 1;
    EXPECT_FALSE(computed_at[i] && held_at[i] == 0) << i << " was computed while hidden";
  }
  EXPECT_GT(hidden, 100U);
}

TEST(Computed, AValueNeedsItsInputsOnlyWhileItIsHeldItself) {
  Computed<int, int> first([] { return std::optional(2); },
                           [](int of, const auto&) { return std::make_shared<const int>(10 * of); });
  Computed<int, int> second([&] { return first.value() ? std::optional(*first.value()) : std::nullopt; },
                            [](int of, const auto&) { return std::make_shared<const int>(of + 1); });
  second.needs(first);
  QObject::connect(&first, &Computation::valueChanged, &second, &Computation::refresh);
  QCoreApplication::processEvents();
  EXPECT_FALSE(first.isBusy());
  {
    QObject view;
    second.hold(view);
    EXPECT_TRUE(first.isBusy());
    ASSERT_TRUE(QTest::qWaitFor([&] { return second.value() != nullptr; }, kPatience));
    EXPECT_EQ(*second.value(), 21);
    EXPECT_TRUE(first.isHeld());
  }
  QCoreApplication::processEvents();
  EXPECT_FALSE(first.isHeld()) << "a holder that ended lets go";
}

TEST(Computed, WithoutInputsThereIsNoValueAndAReasonIsASentence) {
  std::optional<int> input = 1;
  Computed<int, int> cell([&] { return input; },
                          [](int of, const auto&) -> Computed<int, int>::Answer {
                            if (of < 0) return tl::unexpected(QStringLiteral("Below zero."));
                            return std::make_shared<const int>(of);
                          });
  QObject view;
  cell.hold(view);
  ASSERT_TRUE(QTest::qWaitFor([&] { return cell.value() != nullptr; }, kPatience));
  input = -1;
  cell.refresh();
  EXPECT_NE(cell.value(), nullptr) << "the old one stays until the new one comes";
  ASSERT_TRUE(QTest::qWaitFor([&] { return !cell.isBusy(); }, kPatience));
  EXPECT_EQ(cell.value(), nullptr);
  EXPECT_EQ(cell.failure(), QStringLiteral("Below zero."));
  input.reset();
  cell.refresh();
  EXPECT_FALSE(cell.isBusy());
  EXPECT_TRUE(cell.failure().isEmpty());
}

// The end of the program: the views and what they hold go while the other thread computes.
TEST(Computed, EndsWhileItComputesAndItsViewIsGone) {
  for (int i = 0; i < 100; ++i) {
    std::binary_semaphore began{0};
    auto owned = std::make_shared<std::vector<int>>(1'000, i);
    auto view = std::make_unique<QObject>();
    auto cell =
        std::make_unique<Computed<int, int>>([] { return std::optional(1); },
                                             [&began, owned](int, const RunOf<int>& run) -> Computed<int, int>::Answer {
                                               began.release();
                                               while (!run.stop.stop_requested()) {
                                                 run.progress(0.5);
                                                 run.hand(owned->front());
                                                 std::this_thread::yield();
                                               }
                                               return std::make_shared<const int>(owned->back());
                                             });
    owned.reset();
    cell->hold(*view);
    began.acquire();
    if (i % 2 == 0) view.reset();
    if (i % 3 == 0) QCoreApplication::processEvents();
    cell.reset();
    view.reset();
  }
  QCoreApplication::processEvents();
}

}  // namespace
}  // namespace tactus::workbench
