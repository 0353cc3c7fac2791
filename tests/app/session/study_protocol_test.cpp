#include "app/session/study_protocol.h"

#include <gtest/gtest.h>

#include "core/store/persons.h"

#include "tests/support/temp_folder.h"

namespace tactus::session {
namespace {

StudyProtocol good() {
  StudyProtocol protocol;
  protocol.settings.speed.strokes = 5;
  protocol.languages = {"zh-Hant", "en"};
  protocol.consent_version = "2026-2";
  protocol.consent = {{"en", "I agree.\nReally."}, {"zh-Hant", "我同意。"}};
  protocol.device = {"Touch", 0.12, 2, 0.88};
  return protocol;
}

std::string refusal(const StudyProtocol& protocol) {
  const auto ok = validate(protocol);
  return ok ? "" : ok.error().message();
}

TEST(StudyProtocol, ComesBackFromItsText) {
  const auto text = toJson(good());
  EXPECT_EQ(text.find('\n'), std::string::npos);
  const auto read = parseStudyProtocol(text);
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_EQ(toJson(*read), text);
  EXPECT_EQ(read->settings.speed.strokes, 5);
  EXPECT_EQ(read->languages, (std::vector<std::string>{"zh-Hant", "en"}));
  EXPECT_EQ(read->consent.at("zh-Hant"), "我同意。");
  EXPECT_EQ(read->device.friction_n, 0.12);
  EXPECT_TRUE(parseStudyProtocol("{}"));
  for (const char* bad : {"", "[]", R"({"languages":"en"})", R"({"languages":[1]})", R"({"consent":{"en":1}})",
                          R"({"device":7})", R"({"device":{"friction_n":"low"}})", R"({"settings":[]})"}) {
    EXPECT_FALSE(parseStudyProtocol(bad)) << bad;
  }
}

TEST(StudyProtocol, IsRefusedWithTheReason) {
  EXPECT_EQ(refusal(good()), "");
  auto protocol = good();
  protocol.consent.erase("en");
  EXPECT_EQ(refusal(protocol), "language 'en': found no consent text, wanted the text that participants agree to");
  protocol = good();
  protocol.consent_version.clear();
  EXPECT_NE(refusal(protocol).find("consent_version"), std::string::npos);
  protocol = good();
  protocol.languages = {};
  EXPECT_NE(refusal(protocol).find("languages"), std::string::npos);
  protocol = good();
  protocol.languages = {"en", "en"};
  EXPECT_NE(refusal(protocol).find("found twice"), std::string::npos);
  protocol = good();
  protocol.languages = {"fi"};
  EXPECT_EQ(refusal(protocol), "language 'fi': found no screens in it, wanted one of en, zh-Hant, zh-Hans");
  // A form may be worded in more languages than the screens.
  protocol = good();
  protocol.languages = {"de"};
  protocol.consent["de"] = "Text";
  protocol.settings.blocks = {Block::kSpeed, Block::kForce};
  EXPECT_NE(refusal(protocol).find("no screens in it"), std::string::npos);
  protocol = good();
  protocol.settings.force.ladder.highest_n = 2.5;
  EXPECT_EQ(refusal(protocol), "ladder.highest_n: found 2.5 N, wanted at most 2 N, the force cap of the device");
  protocol = good();
  protocol.device.force_cap_n = 9;
  EXPECT_NE(refusal(protocol).find("device"), std::string::npos);
}

class StoredProtocol : public testing::Test {
 protected:
  void SetUp() override {
    auto created = store::StudyFile::create(folder_.file("study.tactus"), {tools_.ids.next(), "test", 1, "test"});
    ASSERT_TRUE(created);
    file_.emplace(std::move(*created));
    ASSERT_TRUE(store::append(*file_, person_));
  }
  std::string set(const StudyProtocol& protocol, const std::string& reason = {}) {
    const auto made = setProtocol(*file_, protocol, "researcher", reason, tools_);
    return made ? "version " + std::to_string(made->version) : made.error().message();
  }

  support::TempFolder folder_;
  SessionTools tools_{[] { return study::Moment{1000, 0}; }, study::RecordIds(3)};  // a clock that stands still
  study::Person person_{tools_.ids.next(), "amber-otter", false};
  std::optional<store::StudyFile> file_;
};

TEST_F(StoredProtocol, IsLockedByTheFirstSessionOfAParticipant) {
  EXPECT_EQ(*currentProtocol(*file_), std::nullopt);
  EXPECT_FALSE(startUnderProtocol(*file_, person_.id, "en", 1));
  EXPECT_EQ(set(good()), "version 1");
  auto later = good();
  later.settings.speed.strokes = 3;
  EXPECT_EQ(set(later), "version 1");
  EXPECT_EQ((*currentProtocol(*file_))->settings.speed.strokes, 3) << "the later draft, whatever the clock says";

  const auto stale = startUnderProtocol(*file_, person_.id, "en", 1);
  ASSERT_TRUE(stale);
  EXPECT_EQ(set(good()), "version 1");
  EXPECT_FALSE(Session::begin(*file_, *stale, tools_)) << "a draft that no longer counts";

  EXPECT_FALSE(startUnderProtocol(*file_, person_.id, "de", 1));
  const auto start = startUnderProtocol(*file_, person_.id, "zh-Hant", 7);
  ASSERT_TRUE(start) << start.error().message();
  EXPECT_EQ(start->consent_version, "2026-2");
  EXPECT_EQ(start->device_friction_n, 0.12);
  const auto session = Session::begin(*file_, *start, tools_);
  ASSERT_TRUE(session) << session.error().message();
  EXPECT_EQ(session->record().protocol, start->protocol);
  EXPECT_EQ(session->settings().speed.strokes, 5);

  EXPECT_NE(set(later).find("an amendment without a reason"), std::string::npos);
  EXPECT_EQ(set(later, "too tiring"), "version 2");
  const auto resumed = Session::resume(*file_, session->record().id, tools_);
  ASSERT_TRUE(resumed);
  EXPECT_EQ(resumed->settings().speed.strokes, 5) << "a session keeps the protocol that it began with";
}

}  // namespace
}  // namespace tactus::session
