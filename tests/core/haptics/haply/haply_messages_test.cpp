// The wire of the Haply Inverse Service, by messages as its documents and its public clients have them.
#include "core/haptics/haply/haply_messages.h"

#include <clocale>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/random.h"

#include "tests/core/haptics/haply/haply_run.h"

namespace tactus::haptics {
namespace {

using Json = nlohmann::json;

TEST(HaplyMessages, TheListOfTheServiceIsRead) {
  const auto message = readHaplyMessage(inventory());
  ASSERT_TRUE(message.has_value()) << message.error().message();
  ASSERT_EQ(message->devices.size(), 1u);
  const HaplyReport& device = message->devices[0];
  EXPECT_EQ(device.id, "049D");
  EXPECT_EQ(device.position_m, (Vector3{0.01, -0.12, 0.15}));
  EXPECT_EQ(device.velocity_m_s, (Vector3{0, 0.5, -0.25}));
  EXPECT_EQ(device.is_calibrated, true);
  EXPECT_EQ(device.is_powered, true);
  EXPECT_EQ(device.preset, "defaults");
  EXPECT_EQ(device.basis, "XYZ");
  EXPECT_FALSE(device.is_mounted_otherwise);
  EXPECT_EQ(device.is_simulated, false);
  EXPECT_EQ(message->grips, std::vector<std::uint32_t>{2}) << "b is the second button";
  EXPECT_TRUE(message->error.empty());
}

// x right, y away, z up there; x right, y up, z toward the user here.
TEST(HaplyMessages, AxesAreThoseOfTheHandAndBack) {
  EXPECT_EQ(fromHaplyAxes({1, 2, 3}), (Vector3{1, 3, -2}));
  EXPECT_EQ(haplyAxesOf(fromHaplyAxes({0.25, -7, 1e-9})), (Vector3{0.25, -7, 1e-9}));
}

TEST(HaplyMessages, WhatALaterMessageLeavesOutIsAbsent) {
  const auto message = readHaplyMessage(stateOf049D(R"({"cursor_position":{"x":1,"y":2,"z":3},"more":[1,{}]})"));
  ASSERT_TRUE(message.has_value());
  EXPECT_EQ(message->devices[0].position_m, (Vector3{1, 2, 3}));
  EXPECT_FALSE(message->devices[0].velocity_m_s);
  EXPECT_FALSE(message->devices[0].is_calibrated);
  EXPECT_FALSE(message->devices[0].is_simulated) << "only the configuration tells";
  EXPECT_TRUE(message->grips.empty());
}

TEST(HaplyMessages, NullCountsAsAbsentAndButtonsHaveTwoNames) {
  const auto message = readHaplyMessage(
      R"({"inverse3":null,"wireless_verse_grip":[{"state":{"buttons":{"button_0":true,"button_3":true,"a":1}}},{}],)"
      R"("error":null})");
  ASSERT_TRUE(message.has_value()) << message.error().message();
  EXPECT_TRUE(message->devices.empty());
  EXPECT_EQ(message->grips, (std::vector<std::uint32_t>{9, 0}));
}

TEST(HaplyMessages, AnErrorOfTheServiceIsASentence) {
  EXPECT_EQ(readHaplyMessage(R"({"error":"device busy"})")->error, "device busy");
  EXPECT_EQ(readHaplyMessage(R"({"error":{"message":"no session","code":4}})")->error, "no session");
  EXPECT_FALSE(readHaplyMessage(R"({"error":{}})")->error.empty());
}

TEST(HaplyMessages, WhatIsNoMessageIsRefusedInOneSentence) {
  for (const char* const text :
       {"", "[]", "{", "3", R"({"inverse3":3})", R"({"inverse3":[3]})", R"({"inverse3":[{}]})",
        R"({"inverse3":[{"device_id":"A","state":{"cursor_position":{"x":1,"y":2}}}]})",
        R"({"inverse3":[{"device_id":"A","state":{"cursor_position":{"x":NaN,"y":2,"z":3}}}]})",
        R"({"inverse3":[{"device_id":"A","state":{"cursor_position":{"x":1e999,"y":2,"z":3}}}]})",
        R"({"inverse3":[{"device_id":"A","state":{"cursor_position":{"x":"1","y":2,"z":3}}}]})"}) {
    const auto message = readHaplyMessage(text);
    ASSERT_FALSE(message.has_value()) << text;
    EXPECT_EQ(message.error().message().find('\n'), std::string::npos);
  }
}

TEST(HaplyMessages, AForceIsTheVectorInNewtonsUnderBothNames) {
  // 1.5 N toward the user and 0.25 N up.
  const Json command = Json::parse(haplyForceText("049D", {0, 0.25, 1.5}));
  const Json& force = command.at("inverse3").at(0).at("commands").at("set_cursor_force");
  EXPECT_EQ(command.at("inverse3").at(0).at("device_id"), "049D");
  EXPECT_EQ(force.at("values"), (Json{{"x", 0.0}, {"y", -1.5}, {"z", 0.25}}));
  EXPECT_EQ(force.at("vector"), force.at("values"));
  EXPECT_TRUE(Json::parse(haplyProbeText("A\"B")).at("inverse3").at(0).at("commands").contains("probe_position"));
  EXPECT_TRUE(Json::parse(haplyFullStateText()).at("session").contains("force_render_full_state"));
}

TEST(HaplyMessages, TheDoubleReadsWhatAnyClientSends) {
  const auto force = readHaplyRequest(haplyForceText("SIM-1", {0.1, -0.2, 0.3}));
  ASSERT_TRUE(force.has_value()) << force.error().message();
  ASSERT_EQ(force->commands.size(), 1u);
  EXPECT_EQ(force->commands[0].force_n, (Vector3{0.1, -0.2, 0.3}));
  const auto other = readHaplyRequest(
      R"({"inverse3":[{"device_id":"A","commands":{"set_cursor_force":{"vector":{"x":0,"y":-2,"z":0}}}},)"
      R"({"device_id":"B","commands":{"probe_position":{}}}]})");
  EXPECT_EQ(other->commands[0].force_n, (Vector3{0, 0, 2})) << "toward the user";
  EXPECT_FALSE(other->commands[1].force_n);
  EXPECT_TRUE(readHaplyRequest(haplyFullStateText())->wants_everything);
  EXPECT_FALSE(readHaplyRequest(R"({"inverse3":[{"device_id":"A","commands":{"set_cursor_force":{}}}]})"));
}

TEST(HaplyMessages, TheDoubleSaysThatItIsSimulated) {
  HaplyState state;
  state.id = "SIM-1";
  state.position_m = {0, -0.12, 0.15};
  state.grip = true;
  const auto first = readHaplyMessage(haplyStateText({state}, true, "busy"));
  ASSERT_TRUE(first.has_value()) << first.error().message();
  EXPECT_EQ(first->devices[0].is_simulated, true);
  EXPECT_EQ(first->devices[0].position_m, state.position_m);
  EXPECT_EQ(first->grips, std::vector<std::uint32_t>{1});
  EXPECT_EQ(first->error, "busy");
  EXPECT_FALSE(readHaplyMessage(haplyStateText({state}, false))->devices[0].is_simulated);
}

TEST(HaplyMessages, ALocaleWithCommasChangesNothing) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  if (std::setlocale(LC_ALL, "de_DE.UTF-8") == nullptr) GTEST_SKIP() << "no locale with decimal commas is here";
  const std::string text = haplyForceText("A", {0.5, 0.125, -0.25});
  const auto request = readHaplyRequest(text);
  const auto message = readHaplyMessage(inventory());
  std::setlocale(LC_ALL, before.c_str());
  EXPECT_NE(text.find("\"x\":0.5,\"y\":0.25,\"z\":0.125"), std::string::npos) << text;
  ASSERT_TRUE(request && message);
  EXPECT_EQ(request->commands[0].force_n, (Vector3{0.5, 0.125, -0.25}));
  EXPECT_EQ(message->devices[0].position_m, (Vector3{0.01, -0.12, 0.15}));
}

// Cut anywhere, and with bytes changed: a value or a sentence, and never anything else.
TEST(HaplyMessages, DamagedMessagesAreReadOrRefused) {
  base::Random random(7);
  const std::string whole = inventory();
  for (std::size_t length = 0; length < whole.size(); ++length)
    EXPECT_FALSE(readHaplyMessage(whole.substr(0, length)).has_value()) << length;
  int refused = 0;
  for (int round = 0; round < 2000; ++round) {
    std::string text = whole;
    for (int i = 0; i < 3; ++i)
      text[static_cast<std::size_t>(random.below(static_cast<int>(text.size())))] =
          static_cast<char>(random.below(256));
    const auto message = readHaplyMessage(text);
    if (message) continue;
    ++refused;
    EXPECT_FALSE(message.error().message().empty());
  }
  EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace tactus::haptics
