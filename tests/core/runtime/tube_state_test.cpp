// The state of a tube as a copy and as bytes: the same steps from there on, and nothing from bytes that are none.
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "core/base/files/checksums.h"
#include "core/base/random.h"

#include "tests/core/runtime/runtime_models.h"

namespace tactus {
namespace {

using Bytes = std::vector<unsigned char>;

/// A hand that pushes, pulls, lets go and stumbles, drawn from one number.
class Hand {
 public:
  explicit Hand(std::uint64_t seed) : random_(seed) {}

  tactus_feel move(tactus_tube* tube) {
    if (random_.below(150) == 0) speed_mm_s_ = random_.uniform(-60, 150);
    if (random_.below(700) == 0) held_ = !held_;
    const double dt_s = random_.below(900) == 0 ? 5.0 : random_.uniform(0.0005, 0.0015);
    position_mm_ += speed_mm_s_ * 0.001;
    tactus_feel feel = {};
    feel.size = sizeof feel;
    tactus_tube_step(tube, position_mm_, held_ ? 1 : 0, dt_s, &feel);
    return feel;
  }

 private:
  base::Random random_;
  double position_mm_ = 0;
  double speed_mm_s_ = 40;
  bool held_ = true;
};

void expectSame(const tactus_feel& found, const tactus_feel& wanted, int tick) {
  const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
  ASSERT_EQ(bits(found.force_n), bits(wanted.force_n)) << tick;
  ASSERT_EQ(bits(found.depth_mm), bits(wanted.depth_mm)) << tick;
  ASSERT_EQ(bits(found.speed_mm_s), bits(wanted.speed_mm_s)) << tick;
  ASSERT_EQ(bits(found.slip_speed_mm_s), bits(wanted.slip_speed_mm_s)) << tick;
  ASSERT_EQ(bits(found.stretch_mm), bits(wanted.stretch_mm)) << tick;
  ASSERT_EQ(bits(found.model_force_n), bits(wanted.model_force_n)) << tick;
  ASSERT_EQ(found.phase, wanted.phase) << tick;
  ASSERT_EQ(found.held_last, wanted.held_last) << tick;
  ASSERT_EQ(found.stroke, wanted.stroke) << tick;
  ASSERT_EQ(found.limited, wanted.limited) << tick;
  ASSERT_EQ(found.region, wanted.region) << tick;
}

Bytes saved(const tactus_tube* tube) {
  Bytes bytes(tactus_tube_save(tube, nullptr, 0));
  EXPECT_EQ(tactus_tube_save(tube, bytes.data(), bytes.size()), bytes.size());
  return bytes;
}

TEST(RuntimeState, ACopyAndALoadedTubeGoOnAsTheOriginal) {
  base::Random random(3);
  const auto model = support::handleOf(support::s4Shifted());
  for (std::uint64_t run = 0; run < 60; ++run) {
    const auto before = support::ngtSceneHandle(model.get(), 0.4, 70);
    const auto scene = support::ngtSceneHandle(model.get(), 1, 45);
    // The same scene once more, as another process makes it.
    const auto again = support::ngtSceneHandle(support::handleOf(support::s4Shifted()).get(), 1, 45);
    const auto tube = support::tubeOf(before.get());
    if (run % 3 == 0) {
      const tactus_limits limits{sizeof(tactus_limits), 0.1, 0.4};
      ASSERT_EQ(tactus_tube_limits(tube.get(), &limits), TACTUS_OK);
    }
    tactus_tube_place(tube.get(), random.uniform(0, 300));
    Hand hand(run);
    for (int i = 0; i < 1500; ++i) hand.move(tube.get());
    // Before the next step, or in the middle of the fade.
    tactus_tube_scene(tube.get(), scene.get(), 0.5);
    const int more = static_cast<int>(random.below(200)) * (run % 2 == 0 ? 0 : 1);
    for (int i = 0; i < more; ++i) hand.move(tube.get());

    tactus_tube* copied = nullptr;
    ASSERT_EQ(tactus_tube_copy(tube.get(), &copied), TACTUS_OK);
    const support::TubeHandle copy(copied);
    const Bytes bytes = saved(tube.get());
    const auto loaded = support::tubeOf(again.get());
    Hand other(99);
    for (int i = 0; i < 100; ++i) other.move(loaded.get());
    ASSERT_EQ(tactus_tube_load(loaded.get(), bytes.data(), bytes.size()), TACTUS_OK);
    EXPECT_EQ(saved(loaded.get()), bytes);

    Hand of_copy = hand;
    Hand of_loaded = hand;
    Hand of_rollback = hand;
    std::vector<tactus_feel> wanted;
    for (int i = 0; i < 2000; ++i) {
      wanted.push_back(hand.move(tube.get()));
      expectSame(of_copy.move(copy.get()), wanted.back(), i);
      expectSame(of_loaded.move(loaded.get()), wanted.back(), i);
      if (HasFatalFailure()) return;
    }
    // Back again, in the same tube.
    ASSERT_EQ(tactus_tube_load(tube.get(), bytes.data(), bytes.size()), TACTUS_OK);
    for (int i = 0; i < 2000; ++i) expectSame(of_rollback.move(tube.get()), wanted[static_cast<std::size_t>(i)], i);
    if (HasFatalFailure()) return;
  }
}

TEST(RuntimeState, PuncturesArePartOfTheState) {
  auto with_events = support::s4Shifted();
  with_events.events = {{"nasopharynx", 0.6}, {"oropharynx", 0.5}};
  const auto model = support::handleOf(with_events);
  const auto scene = support::ngtSceneHandle(model.get(), 1, 45);
  const double place_mm = fuzzy::endOfCore(with_events.inputs[2], with_events.inputs[2].terms[1]);
  // Past the place and back behind it: the stroke remembers.
  const auto tube = support::tubeOf(scene.get());
  tactus_tube_place(tube.get(), place_mm - 3);
  tactus_feel feel = {};
  feel.size = sizeof feel;
  double position_mm = 0;
  const auto move = [&](tactus_tube* one, double by_mm) {
    position_mm += by_mm;
    tactus_tube_step(one, position_mm, 1, 0.001, &feel);
  };
  for (int i = 0; i < 5000 && feel.depth_mm < place_mm + 1; ++i) move(tube.get(), 0.02);
  for (int i = 0; i < 5000 && feel.depth_mm > place_mm - 2; ++i) move(tube.get(), -0.02);
  ASSERT_LT(feel.depth_mm, place_mm);
  for (int i = 0; i < 200; ++i) move(tube.get(), 0);
  const double with_hole_n = feel.model_force_n;
  const Bytes bytes = saved(tube.get());
  const auto loaded = support::tubeOf(scene.get());
  ASSERT_EQ(tactus_tube_load(loaded.get(), bytes.data(), bytes.size()), TACTUS_OK);
  EXPECT_EQ(saved(loaded.get()), bytes);
  const double here_mm = position_mm;
  std::vector<tactus_feel> wanted;
  for (int i = 0; i < 500; ++i) {
    move(tube.get(), 0.01);
    wanted.push_back(feel);
  }
  position_mm = here_mm;
  for (int i = 0; i < 500; ++i) {
    move(loaded.get(), 0.01);
    expectSame(feel, wanted[static_cast<std::size_t>(i)], i);
    if (HasFatalFailure()) return;
  }
  // At the same depth in a stroke of its own there is a wall.
  tactus_tube_place(loaded.get(), wanted.front().depth_mm);
  tactus_tube_step(loaded.get(), position_mm, 1, 0.001, &feel);
  EXPECT_NEAR(with_hole_n, 0.4 * feel.model_force_n, 1e-12);
}

TEST(RuntimeState, BytesOfAnotherVersionAreRefused) {
  const auto model = support::handleOf(support::s4Shifted());
  const auto tube = support::tubeOf(support::ngtSceneHandle(model.get(), 1, 45).get());
  Bytes bytes = saved(tube.get());
  ASSERT_EQ(bytes[0], '2') << "the last letter of TACTUBE2, on a machine that begins with the last byte";
  bytes[0] = '1';
  const std::size_t end = bytes.size() - 8;
  const std::uint64_t sum = base::crc32({reinterpret_cast<const char*>(bytes.data()), end});
  std::memcpy(bytes.data() + end, &sum, sizeof sum);
  EXPECT_EQ(tactus_tube_load(tube.get(), bytes.data(), bytes.size()), TACTUS_BAD_ARGUMENT);
}

TEST(RuntimeState, BytesOfAnotherSceneAreRefused) {
  const auto model = support::handleOf(support::s4Shifted());
  auto other_model = support::s4Shifted();
  other_model.experts[0].rules[0].weight = 0.5;
  const auto scene = support::ngtSceneHandle(model.get(), 1, 45);
  const auto bytes = saved(support::tubeOf(scene.get()).get());
  const auto other_scene = support::ngtSceneHandle(model.get(), 1, 46);
  const auto of_other_model = support::ngtSceneHandle(support::handleOf(other_model).get(), 1, 45);
  for (const tactus_scene* other : {other_scene.get(), of_other_model.get()}) {
    const auto tube = support::tubeOf(other);
    const Bytes before = saved(tube.get());
    EXPECT_EQ(tactus_tube_load(tube.get(), bytes.data(), bytes.size()), TACTUS_BAD_ARGUMENT);
    EXPECT_EQ(saved(tube.get()), before);
    // With its scene it takes them.
    tactus_tube_scene(tube.get(), scene.get(), 0);
    EXPECT_EQ(tactus_tube_load(tube.get(), bytes.data(), bytes.size()), TACTUS_OK);
  }
}

TEST(RuntimeState, ALoadNeverLoosensALimit) {
  const auto model = support::handleOf(support::s4Shifted());
  const auto scene = support::ngtSceneHandle(model.get(), 0, 45);
  const auto free_tube = support::tubeOf(scene.get());
  Hand hand(1);
  for (int i = 0; i < 500; ++i) hand.move(free_tube.get());
  const Bytes bytes = saved(free_tube.get());
  const auto bounded = support::tubeOf(scene.get());
  const tactus_limits limits{sizeof(tactus_limits), 0.05, 0.2};
  ASSERT_EQ(tactus_tube_limits(bounded.get(), &limits), TACTUS_OK);
  ASSERT_EQ(tactus_tube_load(bounded.get(), bytes.data(), bytes.size()), TACTUS_OK);
  double largest_n = 0;
  for (int i = 0; i < 3000; ++i) largest_n = std::max(largest_n, std::abs(hand.move(bounded.get()).force_n));
  EXPECT_LE(largest_n, 0.2);
  EXPECT_GT(largest_n, 0.1);
}

TEST(RuntimeState, NullsAndSizes) {
  const auto model = support::handleOf(support::s4Shifted());
  const auto scene = support::ngtSceneHandle(model.get(), 1, 45);
  const auto tube = support::tubeOf(scene.get());
  Bytes bytes = saved(tube.get());
  EXPECT_EQ(tactus_tube_save(nullptr, bytes.data(), bytes.size()), 0U);
  Bytes small(bytes.size(), 0xA5);
  EXPECT_EQ(tactus_tube_save(tube.get(), small.data(), bytes.size() - 1), bytes.size());
  EXPECT_EQ(small, Bytes(bytes.size(), 0xA5));
  EXPECT_EQ(tactus_tube_load(nullptr, bytes.data(), bytes.size()), TACTUS_BAD_ARGUMENT);
  EXPECT_EQ(tactus_tube_load(tube.get(), nullptr, bytes.size()), TACTUS_BAD_ARGUMENT);
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_EQ(tactus_tube_load(tube.get(), bytes.data(), size), TACTUS_BAD_ARGUMENT);
  bytes.push_back(0);
  EXPECT_EQ(tactus_tube_load(tube.get(), bytes.data(), bytes.size()), TACTUS_BAD_ARGUMENT);
  EXPECT_EQ(tactus_tube_copy(tube.get(), nullptr), TACTUS_BAD_ARGUMENT);
  tactus_tube* copy = tube.get();
  EXPECT_EQ(tactus_tube_copy(nullptr, &copy), TACTUS_BAD_ARGUMENT);
  EXPECT_EQ(copy, nullptr);
}

TEST(RuntimeState, OneAlteredBitIsRefused) {
  const auto model = support::handleOf(support::s4Shifted());
  const auto scene = support::ngtSceneHandle(model.get(), 1, 45);
  const auto tube = support::tubeOf(scene.get());
  Hand hand(2);
  for (int i = 0; i < 800; ++i) hand.move(tube.get());
  const Bytes bytes = saved(tube.get());
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    Bytes altered = bytes;
    altered[bit / 8] ^= static_cast<unsigned char>(1U << bit % 8);
    ASSERT_EQ(tactus_tube_load(tube.get(), altered.data(), altered.size()), TACTUS_BAD_ARGUMENT) << bit;
  }
  EXPECT_EQ(saved(tube.get()), bytes);
}

/// Puts the checksum there that the bytes now have, as a person who means harm does.
void sign(Bytes& bytes) {
  const std::size_t end = bytes.size() - 8;
  const std::uint64_t sum = base::crc32({reinterpret_cast<const char*>(bytes.data()), end});
  std::memcpy(bytes.data() + end, &sum, sizeof sum);
}

TEST(RuntimeState, HostileBytesWithARightChecksumNeverGiveAForceThatIsNone) {
  const auto model = support::handleOf(support::s4Shifted());
  const auto scene = support::ngtSceneHandle(model.get(), 1, 45);
  const auto tube = support::tubeOf(scene.get());
  Hand hand(5);
  for (int i = 0; i < 800; ++i) hand.move(tube.get());
  const Bytes bytes = saved(tube.get());
  base::Random random(12);
  const double odd[] = {0.0,    -0.0,  1.0,   -1.0,     1e300,     -1e300,
                        5e-324, 1e151, 1e-20, INFINITY, -INFINITY, std::numeric_limits<double>::quiet_NaN()};
  int taken = 0;
  for (int round = 0; round < 6000; ++round) {
    Bytes altered = bytes;
    for (auto changes = 1 + random.below(4); changes > 0; --changes) {
      // Eight bytes make a number; the first nine are the head and the identity.
      const std::size_t at = 8 * (9 + random.below((bytes.size() - 8) / 8 - 9));
      std::uint64_t bits = std::bit_cast<std::uint64_t>(odd[random.below(std::size(odd))]);
      if (random.below(3) == 0) bits = random.below(6);
      if (random.below(5) == 0) bits = random.next();
      std::memcpy(altered.data() + at, &bits, sizeof bits);
    }
    sign(altered);
    const auto victim = support::tubeOf(scene.get());
    if (tactus_tube_load(victim.get(), altered.data(), altered.size()) != TACTUS_OK) continue;
    ++taken;
    Hand after(static_cast<std::uint64_t>(round));
    for (int i = 0; i < 200; ++i) {
      const tactus_feel feel = after.move(victim.get());
      ASSERT_TRUE(std::isfinite(feel.force_n) && std::abs(feel.force_n) <= 2) << round;
      ASSERT_TRUE(std::isfinite(feel.depth_mm) && std::isfinite(feel.speed_mm_s) &&
                  std::isfinite(feel.slip_speed_mm_s) && std::isfinite(feel.stretch_mm) &&
                  std::isfinite(feel.model_force_n))
          << round;
      ASSERT_TRUE(feel.phase >= 0 && feel.phase <= 2 && feel.region >= -1 && feel.region < 5) << round;
    }
  }
  EXPECT_GT(taken, 500);
}

}  // namespace
}  // namespace tactus
