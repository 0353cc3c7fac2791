#include <gtest/gtest.h>

#include "elicitation/speed/participant_speeds.h"
#include "elicitation/speed/speed_terms.h"

namespace tactus::elicitation {
namespace {

study::SpeedSample sample(const std::string& who, int stroke, double speed_mm_s) {
  study::SpeedSample out;
  out.participant = who;
  out.level = "slow";
  out.stroke = stroke;
  out.speed_mm_s = speed_mm_s;
  return out;
}

std::vector<double> speedsOf(std::span<const study::SpeedSample> samples) {
  std::vector<double> out;
  for (const auto& one : samples) out.push_back(one.speed_mm_s);
  return out;
}

TEST(ParticipantSamples, SideBySideNothingIsCopied) {
  const std::vector<study::SpeedSample> all = {sample("A", 1, 1), sample("A", 1, 2), sample("B", 1, 3)};
  const ParticipantSamples samples(all);
  EXPECT_EQ(samples.of("A").data(), all.data());
  EXPECT_EQ(samples.of("A").size(), 2U);
  EXPECT_EQ(samples.of("B").data(), all.data() + 2);
  EXPECT_TRUE(samples.of("C").empty());
}

TEST(ParticipantSamples, ApartTheyAreJoinedInTheirOrder) {
  const std::vector<study::SpeedSample> all = {sample("A", 1, 1), sample("B", 1, 2), sample("A", 2, 3),
                                               sample("B", 2, 4), sample("A", 3, 5)};
  const ParticipantSamples samples(all);
  EXPECT_EQ(speedsOf(samples.of("A")), (std::vector<double>{1, 3, 5}));
  EXPECT_EQ(speedsOf(samples.of("B")), (std::vector<double>{2, 4}));
}

TEST(ParticipantSamples, OnlyTrimmingCopies) {
  const std::vector<study::SpeedSample> all = {sample("A", 1, 1), sample("A", 1, 10), sample("A", 2, 3)};
  std::vector<study::SpeedSample> room;
  EXPECT_EQ(keptSamples(all, 0, room).data(), all.data());
  EXPECT_TRUE(room.empty());
  // 1 is below a fifth of the first stroke's peak of 10.
  EXPECT_EQ(speedsOf(keptSamples(all, 0.2, room)), (std::vector<double>{10, 3}));
}

}  // namespace
}  // namespace tactus::elicitation
