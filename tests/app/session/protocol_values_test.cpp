#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "app/session/study_protocol.h"

namespace tactus::session {
namespace {

std::string valueOf(const StudyProtocol& protocol, const std::string& name) {
  for (const ProtocolValue& value : protocolValues(protocol)) {
    if (value.name == name) return value.value;
  }
  return "(none)";
}

StudyProtocol with(const char* name, const char* value) {
  const auto changed = withProtocolValue(StudyProtocol(), name, value);
  EXPECT_TRUE(changed) << changed.error().message();
  return changed.value_or(StudyProtocol());
}

TEST(ProtocolValues, AreListedByName) {
  StudyProtocol protocol;
  protocol.consent["en"] = "Please read.";
  EXPECT_EQ(valueOf(protocol, "blocks"), "speed,force,form");
  EXPECT_EQ(valueOf(protocol, "speed.levels"), "slow,medium,fast");
  EXPECT_EQ(valueOf(protocol, "force.ladder.highest_n"), "1.7");
  EXPECT_EQ(valueOf(protocol, "force.familiarisation_n"), "0.5");
  EXPECT_EQ(valueOf(protocol, "item_order"), "fixed");
  EXPECT_EQ(valueOf(protocol, "languages"), "en");
  EXPECT_EQ(valueOf(protocol, "consent.en"), "Please read.");
  EXPECT_EQ(valueOf(protocol, "device.friction_n"), "");
}

TEST(ProtocolValues, CanBeSetByName) {
  EXPECT_EQ(with("speed.strokes", "6").settings.speed.strokes, 6);
  EXPECT_EQ(with("force.ladder.highest_n", "1.5").settings.force.ladder.highest_n, 1.5);
  EXPECT_EQ(with("force.random", "true").settings.force.random, true);
  EXPECT_EQ(with("force.familiarisation_n", "0.2, 0.9").settings.force.familiarisation_n,
            (std::vector<double>{0.2, 0.9}));
  EXPECT_TRUE(with("force.familiarisation_n", "").settings.force.familiarisation_n.empty());
  EXPECT_EQ(with("blocks", "form").settings.blocks, std::vector{Block::kForm});
  EXPECT_EQ(with("item_order", "shuffled").settings.item_order, questionnaires::ItemOrder::kShuffled);
  EXPECT_EQ(with("languages", "zh-Hant,en").languages, (std::vector<std::string>{"zh-Hant", "en"}));
  EXPECT_EQ(with("consent_version", "2026-1").consent_version, "2026-1");
  EXPECT_EQ(with("consent.zh-Hant", "同意書").consent.at("zh-Hant"), "同意書");
  EXPECT_EQ(with("device.friction_n", "0.26").device.friction_n, 0.26);
  EXPECT_FALSE(withProtocolValue(with("device.friction_n", "0.26"), "device.friction_n", "")->device.friction_n);
  EXPECT_EQ(with("device.name", "7").device.name, "7");
  // Each listed value can be read again.
  for (const ProtocolValue& value : protocolValues(StudyProtocol())) {
    const auto same = withProtocolValue(StudyProtocol(), value.name, value.value);
    ASSERT_TRUE(same) << same.error().message();
    EXPECT_EQ(toJson(*same), toJson(StudyProtocol())) << value.name;
  }
}

TEST(ProtocolValues, OfAnotherKindOrNameAreRefused) {
  const auto refusal = [](const char* name, const char* value) {
    const auto changed = withProtocolValue(StudyProtocol(), name, value);
    EXPECT_FALSE(changed) << name << ' ' << value;
    return changed ? std::string() : changed.error().message();
  };
  EXPECT_NE(refusal("force.ladder.highest", "1").find("force.ladder.highest_n?"), std::string::npos);
  EXPECT_NE(refusal("speed.strokes", "2.5").find("a whole number"), std::string::npos);
  EXPECT_NE(refusal("force.pause_s", "long").find("a number"), std::string::npos);
  EXPECT_NE(refusal("force.random", "1").find("true or false"), std::string::npos);
  EXPECT_NE(refusal("force.familiarisation_n", "0.1,much").find("numbers"), std::string::npos);
  EXPECT_NE(refusal("blocks", "speed,dance").find("dance"), std::string::npos);
  EXPECT_NE(refusal("item_order", "backwards").find("backwards"), std::string::npos);
}

TEST(ProtocolPresets, AreValidAndTouchNeitherConsentNorDevice) {
  StudyProtocol own;
  own.consent_version = "1";
  own.consent["en"] = "Whose study it is.";
  own.contact = "Ward 7";
  own.device.force_cap_n = 1.9;
  for (const ProtocolPreset& preset : protocolPresets()) {
    const auto with = withPreset(own, preset.id);
    ASSERT_TRUE(with) << with.error().message();
    EXPECT_TRUE(validate(*with)) << preset.id;
    EXPECT_EQ(with->consent, own.consent);
    EXPECT_EQ(with->contact, own.contact);
    EXPECT_EQ(with->device.force_cap_n, own.device.force_cap_n);
  }
  EXPECT_FALSE(withPreset(own, "quick"));
}

TEST(ProtocolPresets, AsPublishedIsTheDefaultAndHasThePapersNumbers) {
  const auto published = *withPreset(StudyProtocol(), "published");
  EXPECT_EQ(toJson(published), toJson(StudyProtocol()));
  const ProtocolLoad load = loadOf(published);
  EXPECT_EQ(load.strokes, 12);     // paper, Section 3.1.4: three speeds, four times
  EXPECT_EQ(load.judgements, 17);  // 0.1 to 1.7 N by 0.1 N
  EXPECT_EQ(load.questions, 45);
  // By hand: mean square of 0.1 ... 1.7 N is 1.05; held 3.15 of 5.15 s; of 0.88 N.
  EXPECT_NEAR(load.heat_share, std::sqrt(1.05 * 3.15 / 5.15) / 0.88, 1e-12);
}

TEST(ProtocolPresets, TheShortOneTakesAboutTwentyMinutes) {
  EXPECT_NEAR(loadOf(*withPreset(StudyProtocol(), "short")).minutes, 20, 3);
}

}  // namespace
}  // namespace tactus::session
