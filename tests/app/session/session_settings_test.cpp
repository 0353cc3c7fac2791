#include "app/session/session_settings.h"

#include "tests/app/session/session_fixture.h"

namespace tactus::session {
namespace {

TEST(SessionSettings, ComeBackAsTheyWere) {
  SessionSettings settings = shortSession();
  settings.blocks = {Block::kForm, Block::kSpeed};
  settings.speed.levels = {"slow", "fast"};
  settings.speed.stroke.shortest_mm = 12.25;
  settings.force.familiarisation_n = {0.1, 0.7};
  settings.force.device_friction_n = 0.26;
  settings.force.random_steps.highest_n = 0.9;
  settings.form = "usability-v1";
  const auto back = parseSessionSettings(toJson(settings));
  ASSERT_TRUE(back) << back.error().message();
  EXPECT_EQ(toJson(*back), toJson(settings));
  EXPECT_EQ(back->blocks, settings.blocks);
  EXPECT_EQ(back->speed.stroke.shortest_mm, 12.25);
  EXPECT_EQ(back->force.device_friction_n, 0.26);
}

TEST(SessionSettings, WhatIsMissingKeepsItsDefault) {
  const auto read = parseSessionSettings(R"({"speed": {"strokes": 7}})");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->speed.strokes, 7);
  EXPECT_EQ(read->speed.practice, experiments::SpeedSettings{}.practice);
  EXPECT_EQ(read->blocks, SessionSettings{}.blocks);
}

TEST(SessionSettings, WhatDoesNotFitIsRefusedWithItsPlace) {
  const auto refused = [](std::string_view text, std::string_view place) {
    const auto read = parseSessionSettings(text);
    ASSERT_FALSE(read) << text;
    EXPECT_EQ(read.error().place, place) << read.error().message();
  };
  refused("[]", "");
  refused(R"({"speed": 3})", "/speed");
  refused(R"({"speed": {"strokes": "four"}})", "/speed/strokes");
  refused(R"({"speed": {"levels": ["slow", 2]}})", "/speed/levels/1");
  refused(R"({"speed": {"order": "random"}})", "/speed/order");
  refused(R"({"force": {"random_steps": {"lowest_n": null}}})", "/force/random_steps/lowest_n");
  refused(R"({"blocks": ["speed", "dance"]})", "/blocks");
  refused(R"({"force": {"ascending": 1}})", "/force/ascending");
}

TEST(BlockSeed, IsAnotherForEachBlock) {
  EXPECT_NE(blockSeed(1, Block::kSpeed), blockSeed(1, Block::kForce));
  EXPECT_NE(blockSeed(1, Block::kSpeed), blockSeed(2, Block::kSpeed));
  EXPECT_EQ(blockSeed(1, Block::kForm), blockSeed(1, Block::kForm));
}

}  // namespace
}  // namespace tactus::session
