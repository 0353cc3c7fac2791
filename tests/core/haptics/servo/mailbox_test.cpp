#include "core/haptics/servo/mailbox.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <gtest/gtest.h>
#include <memory>
#include <thread>
#include <vector>

#include "core/base/random.h"

namespace tactus::haptics {
namespace {

/// Five cache lines whose content follows from the seed: half of one and half of another value shows.
struct Wide {
  std::uint64_t seed = 0;
  std::array<std::uint64_t, 39> words{};

  static Wide of(std::uint64_t seed) {
    Wide wide;
    wide.seed = seed;
    base::Random random(seed);
    for (std::uint64_t& word : wide.words) word = random.next();
    return wide;
  }
  bool isWhole() const {
    base::Random random(seed);
    for (const std::uint64_t word : words) {
      if (word != random.next()) return false;
    }
    return true;
  }
};

/// Counts how often each value is freed.
struct CountingEnd {
  std::vector<std::atomic<int>>* freed = nullptr;
  void operator()(const Wide* wide) const {
    (*freed)[wide->seed].fetch_add(1);
    delete wide;
  }
};
using Counted = std::unique_ptr<const Wide, CountingEnd>;

Counted counted(std::uint64_t seed, std::vector<std::atomic<int>>& freed) {
  return {new Wide(Wide::of(seed)), CountingEnd{&freed}};
}

TEST(Mailbox, IsEmptyAtFirst) {
  Mailbox<int> mailbox;
  EXPECT_EQ(mailbox.newest(), nullptr);
}

TEST(Mailbox, GivesTheNewestValueUntilThereIsANewerOne) {
  Mailbox<int> mailbox;
  EXPECT_EQ(mailbox.post(10), 1U);
  EXPECT_EQ(mailbox.post(20), 2U);
  for (int look = 0; look < 3; ++look) {
    const Numbered<int>* const letter = mailbox.newest();
    ASSERT_NE(letter, nullptr);
    EXPECT_EQ(letter->value, 20);
    EXPECT_EQ(letter->number, 2U);
  }
  EXPECT_EQ(mailbox.post(30), 3U);
  EXPECT_EQ(mailbox.newest()->value, 30);
}

TEST(Mailbox, FreesAValueOnceItsSuccessorIsTaken) {
  std::vector<std::atomic<int>> freed(4);
  Mailbox<Counted> mailbox;
  mailbox.post(counted(1, freed));
  (void)mailbox.newest();
  mailbox.post(counted(2, freed));
  mailbox.freeWhatIsNotRead();
  EXPECT_EQ(freed[1], 0) << "the reader may still be reading it";
  (void)mailbox.newest();
  EXPECT_EQ(freed[1], 0) << "only the poster frees";
  mailbox.freeWhatIsNotRead();
  EXPECT_EQ(freed[1], 1);
  EXPECT_EQ(freed[2], 0);
}

TEST(Mailbox, FreesWhatWasNeverTakenAtOnce) {
  std::vector<std::atomic<int>> freed(101);
  Mailbox<Counted> mailbox;
  mailbox.post(counted(0, freed));
  (void)mailbox.newest();
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    mailbox.post(counted(seed, freed));
    EXPECT_EQ(mailbox.held(), 2U) << "the one in use and the newest";
  }
  EXPECT_EQ(freed[0], 0);
  for (std::uint64_t seed = 1; seed < 100; ++seed) EXPECT_EQ(freed[seed], 1) << seed;
}

TEST(Mailbox, BetweenTwoThreadsEveryValueIsWholeAndFreedExactlyOnce) {
  constexpr std::uint64_t kPosts = 20'000;
  std::vector<std::atomic<int>> freed(kPosts + 1);
  std::uint64_t torn = 0, backwards = 0, freed_in_use = 0, seen = 0;
  std::size_t most_held = 0;
  {
    Mailbox<Counted> mailbox;
    std::atomic<bool> reading{false};
    std::thread reader([&] {
      reading.store(true);
      std::uint64_t last = 0;
      while (last < kPosts) {
        const auto* const letter = mailbox.newest();
        if (letter == nullptr) continue;
        if (letter->number < last) ++backwards;
        if (letter->number != last) ++seen;
        last = letter->number;
        if (!letter->value->isWhole() || letter->value->seed != letter->number) ++torn;
        if (freed[letter->number].load() != 0) ++freed_in_use;
      }
    });
    while (!reading.load()) std::this_thread::yield();
    for (std::uint64_t seed = 1; seed <= kPosts; ++seed) {
      mailbox.post(counted(seed, freed));
      most_held = std::max(most_held, mailbox.held());
      if (seed % 64 == 0) std::this_thread::yield();
    }
    reader.join();
  }
  EXPECT_EQ(torn, 0U);
  EXPECT_EQ(backwards, 0U);
  EXPECT_EQ(freed_in_use, 0U);
  EXPECT_GT(seen, 1U) << "the threads never met";
  EXPECT_LE(most_held, 3U) << "one not yet known to be out of use, the one in use, and the newest";
  for (std::uint64_t seed = 1; seed <= kPosts; ++seed) ASSERT_EQ(freed[seed], 1) << seed;
}

}  // namespace
}  // namespace tactus::haptics
