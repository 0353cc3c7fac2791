#include "app/session/setup_certificate.h"

#include "app/session/data_checks.h"
#include "app/session/study_view.h"
#include "app/session/trials.h"
#include "core/store/entries.h"

#include "tests/app/session/session_fixture.h"

namespace tactus::session {
namespace {

SetupCertificate allGood() {
  SetupCertificate out;
  out.utc_ms = 1'700'000'000'000;
  out.device = "hid:1209:ffb0:1";
  out.program = "tactus test";
  for (const SetupItem item : kSetupItems) out.findings.push_back({item, true, "1280 × 720, \"ready\""});
  return out;
}

TEST(SetupCertificate, IsGoodOnlyIfEachItemWasCheckedAndIsGood) {
  EXPECT_TRUE(allGood().isGood());
  EXPECT_FALSE(SetupCertificate().isGood());
  for (std::size_t i = 0; i < kSetupItems.size(); ++i) {
    auto bad = allGood();
    bad.findings[i].good = false;
    EXPECT_FALSE(bad.isGood()) << name(kSetupItems[i]);
    bad.findings.erase(bad.findings.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_FALSE(bad.isGood()) << name(kSetupItems[i]);
  }
}

TEST(SetupCertificate, HoldsForItsDeviceForTwelveHours) {
  const auto one = allGood();
  EXPECT_TRUE(holds(one, one.device, one.utc_ms));
  EXPECT_TRUE(holds(one, one.device, one.utc_ms + 12 * 3600 * 1000));
  EXPECT_FALSE(holds(one, one.device, one.utc_ms + 12 * 3600 * 1000 + 1));
  EXPECT_FALSE(holds(one, one.device, one.utc_ms - 1));
  EXPECT_FALSE(holds(one, "hid:1209:ffb0:2", one.utc_ms));
}

TEST(SetupCertificate, ComesBackFromTheLog) {
  const Note note = setupChecked(allGood());
  study::EventRecord event;
  event.kind = note.kind;
  event.detail = note.detail;
  const auto back = setupIn(event);
  ASSERT_TRUE(back && *back) << back.error().message();
  EXPECT_EQ(**back, allGood());
  event.detail = R"({"utc_ms": 1, "device": "x", "findings": [{"item": "weather", "good": true}]})";
  EXPECT_FALSE(setupIn(event));
  event.kind = "rested";
  EXPECT_FALSE(setupIn(event)->has_value());
}

// A session of a real person with a device says whether its set-up was checked; a later good check at its resumption
// is enough. One of questions alone, or of a simulated person, needs none.
TEST_F(SessionTest, WithoutASetupCheckASessionIsMarked) {
  auto with = start();
  with.device = "hid:1209:ffb0:1";
  begin(with);
  base::Random random(3);
  for (int i = 0; i < 12; ++i) doNext(random);
  const auto marked = [this] {
    const auto view = studyForElicitation(*file_);
    EXPECT_TRUE(view) << view.error().message();
    const auto findings = dataFindings(view->study);
    const bool found = std::any_of(findings.begin(), findings.end(), [](const auto& one) {
      return one.kind == study::DataFinding::Kind::kSetupUnchecked;
    });
    EXPECT_EQ(view->study.participants[0].setup_unchecked, found);
    for (const auto& trial : *trials(*file_, *view)) EXPECT_EQ(trial.setup_checked, !found);
    return found;
  };
  EXPECT_TRUE(marked());
  auto bad = allGood();
  bad.findings[1].good = false;
  ASSERT_TRUE(session_->note(setupChecked(bad)));
  EXPECT_TRUE(marked());
  restart();
  auto good = allGood();
  good.utc_ms += 1;
  ASSERT_TRUE(session_->note(setupChecked(good)));
  EXPECT_FALSE(marked());
  EXPECT_EQ(**latestSetup(*file_), good);
}

TEST_F(SessionTest, QuestionsAloneNeedNoSetupCheck) {
  auto settings = shortSession();
  settings.blocks = {Block::kForm};
  auto with = start(settings);
  with.device = "hid:1209:ffb0:1";
  begin(with);
  base::Random random(3);
  for (int i = 0; i < 12; ++i) doNext(random);
  EXPECT_FALSE(*isWithoutSetup(*file_, session_->record()));
  EXPECT_FALSE(latestSetup(*file_)->has_value());
}

}  // namespace
}  // namespace tactus::session
