// A stroke without a hand is a recording like those of a hand: it comes out of its own model again bit for bit.
#include <algorithm>
#include <gtest/gtest.h>

#include "app/replay/recorded_strokes.h"
#include "app/replay/stroke_replay.h"
#include "core/model_io/model_file.h"

#include "tests/support/invented_experts.h"
#include "tests/support/ngt_model.h"

namespace tactus::replay {
namespace {

const contracts::Stroke kStroke{100, 160, 120, {0.66, 60, 0, 0}};

StoredRecording stored(const fuzzy::ForceModel& model, study::Recording samples) {
  StoredRecording out;
  out.id = study::RecordId{{1, 2, 3}};
  out.number = 1;
  out.person = "velvet-otter";
  out.simulated = true;
  out.calculated = true;
  out.model_name = model.name;
  out.model_text = *model_io::modelText(model, "told.tactus.json");
  constexpr const char* kNotNeeded[] = {"speed", "slip_speed", "stretch", "model_force", "force", "stroke", "limited"};
  std::erase_if(samples.channels, [&](const study::Channel& channel) {
    return std::find(std::begin(kNotNeeded), std::end(kNotNeeded), channel.name) != std::end(kNotNeeded);
  });
  out.samples = std::move(samples);
  return out;
}

const std::vector<double>& channel(const study::Recording& recording, const std::string& name) {
  for (const study::Channel& one : recording.channels) {
    if (one.name == name) return one.values;
  }
  throw std::logic_error(name);
}

TEST(CalculatedStroke, ComesOutOfItsOwnModelAgainBitForBit) {
  fuzzy::ForceModel offset = support::s4FiveRegions();
  offset.renderer = fuzzy::RendererParameters{};
  offset.renderer->depth_offset_mm = 12.7;
  for (const fuzzy::ForceModel& model : {support::s4FiveRegions(), support::inventedExperts(), offset}) {
    const auto ready = *editing::ready(model);
    const auto recording = calculatedRecording(kStroke, *ready);
    ASSERT_TRUE(recording) << recording.error().message();
    const auto strokes = recordedStrokes({{stored(model, *recording)}, {}, {}});
    ASSERT_EQ(strokes.size(), 1U);
    EXPECT_EQ(strokes[0].use, StrokeUse::kExact);
    EXPECT_TRUE(strokes[0].calculated);
    EXPECT_TRUE(strokes[0].simulated);
    EXPECT_EQ(strokes[0].conditions.at("lubrication"), 0.66);
    const auto run = runStroke(strokes[0], *ready, {});
    ASSERT_TRUE(run) << run.error().message();
    EXPECT_EQ(run->force_n, strokes[0].recorded_n);
    EXPECT_DOUBLE_EQ(run->depth_mm.front(), 100);
  }
}

// 60 mm at 120 mm/s in the middle are 15 * 60 / (8 * 120) = 0.9375 s; before and after the hand rests for 0.3 s.
TEST(CalculatedStroke, TheHandMakesTheStrokeAndTheTubeFollows) {
  const auto model = support::s4FiveRegions();
  const auto recording = calculatedRecording(kStroke, **editing::ready(model)).value();
  const auto& time = channel(recording, "time");
  const auto& position = channel(recording, "position");
  const auto& button = channel(recording, "button");
  const auto& depth = channel(recording, "depth");
  EXPECT_NEAR(time.back(), 0.9375 + 0.6, 0.002);
  EXPECT_EQ(position.front(), 0);
  EXPECT_EQ(position.back(), 60);
  EXPECT_EQ(button.front(), 0);
  EXPECT_EQ(button.back(), 0);
  EXPECT_EQ(*std::max_element(button.begin(), button.end()), 1);
  EXPECT_NEAR(*std::max_element(channel(recording, "speed").begin(), channel(recording, "speed").end()), 120, 0.01);
  EXPECT_EQ(depth.front(), 100);
  // The spring of the friction model is stretched by less than 3 mm where the force is below 1.1 N.
  EXPECT_GT(depth.back(), 157);
  EXPECT_LE(depth.back(), 160);
}

TEST(CalculatedStroke, AModelThatTheRendererRefusesIsRefused) {
  auto model = support::s4FiveRegions();
  model.inputs[2].unit = "cm";
  EXPECT_FALSE(calculatedRecording(kStroke, **editing::ready(model)));
}

}  // namespace
}  // namespace tactus::replay
