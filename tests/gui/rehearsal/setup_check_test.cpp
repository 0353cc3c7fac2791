// The check of the set-up with a stylus in virtual time.
#include "app/workbench/session/setup_check.h"

#include <QTemporaryDir>
#include <gtest/gtest.h>

#include "app/session/study_protocol.h"

#include "tests/gui/sample_study.h"
#include "tests/gui/stylus.h"

namespace tactus::workbench {
namespace {

using session::SetupItem;
using State = SetupCheck::State;
using tests::comesTrue;

class SetupCheckTest : public testing::Test {
 protected:
  void open(const session::StudyProtocol* protocol) {
    tests::makeStudyFile(path, [protocol](store::StudyFile& file, study::RecordIds& ids) {
      session::SessionTools tools{session::systemTools().now, ids};
      if (protocol != nullptr) {
        ASSERT_TRUE(session::setProtocol(file, *protocol, "", {}, tools));
      }
    });
    study.open(path);
    ASSERT_TRUE(comesTrue([this] { return study.isOpen(); }));
    QObject::connect(&check, &SetupCheck::done, [this](const session::SetupCertificate& one) { certified = one; });
    check.begin(QStringLiteral("hid:test-stylus"));
    ASSERT_TRUE(comesTrue([this] { return check.row(SetupItem::kDisk).state != State::kOpen; }));
  }
  static session::StudyProtocol protocol() {
    session::StudyProtocol out;
    out.consent_version = "3";
    out.consent = {{"en", "A study of the tests."}};
    out.contact = "the tests";
    return out;
  }
  void pass(int milliseconds) { time.advance(device, milliseconds); }
  void moveTo(double mm) {
    stylus.moveTo(mm);
    pass(900);
  }
  // Does what the self-test asks of a person, up to the question.
  void doSelfTest() {
    pass(1500);
    moveTo(50);
    moveTo(0);
    stylus.press(true);
    pass(300);
    stylus.press(false);
    pass(300);
    stylus.press(true);
    for (int second = 0; second < 20 && !check.asksDirection(); ++second) pass(1000);
    stylus.press(false);
    pass(200);
  }

  QTemporaryDir folder;
  QString path = folder.filePath(QStringLiteral("setup.tactus"));
  VirtualTime time;
  tests::Stylus stylus;
  StudyConnection study;
  DeviceSession device{stylus.access(time)};
  std::vector<QSize> screens = {{1920, 1080}, {1280, 720}};
  SetupCheck check{study, device, [this] { return screens; }, [] { return std::int64_t{1'700'000'000'000}; }};
  std::optional<session::SetupCertificate> certified;
};

TEST_F(SetupCheckTest, TheSelfTestAndAPersonCompleteTheCertificate) {
  const auto with = protocol();
  ASSERT_NO_FATAL_FAILURE(open(&with));
  for (const SetupItem item : {SetupItem::kScreens, SetupItem::kLanguage, SetupItem::kConsent, SetupItem::kDisk})
    EXPECT_EQ(check.row(item).state, State::kGood) << check.row(item).found.toStdString();
  pass(1500);
  EXPECT_EQ(check.row(SetupItem::kDevice).state, State::kGood) << check.row(SetupItem::kDevice).found.toStdString();
  EXPECT_EQ(check.row(SetupItem::kForce).state, State::kRunning);
  EXPECT_NE(check.instruction().indexOf(QStringLiteral("Move the handle")), -1);
  doSelfTest();
  ASSERT_TRUE(check.asksDirection()) << check.row(SetupItem::kForce).found.toStdString();
  check.feltDirection(devices::Felt::kToward);
  EXPECT_EQ(check.row(SetupItem::kForce).state, State::kGood) << check.row(SetupItem::kForce).found.toStdString();
  pass(4000);
  EXPECT_EQ(check.row(SetupItem::kLatency).state, State::kGood) << check.row(SetupItem::kLatency).found.toStdString();
  EXPECT_FALSE(check.isDone());
  EXPECT_FALSE(certified);
  check.heard(true);
  ASSERT_TRUE(certified);
  EXPECT_TRUE(certified->isGood());
  EXPECT_EQ(certified->device, "hid:test-stylus");
  // Who answers otherwise later takes it back.
  check.heard(false);
  EXPECT_FALSE(certified->isGood());
}

TEST_F(SetupCheckTest, AForceThatPushesAwayIsNotGoodAndAScaleTakesItsPlace) {
  const auto with = protocol();
  ASSERT_NO_FATAL_FAILURE(open(&with));
  doSelfTest();
  ASSERT_TRUE(check.asksDirection());
  EXPECT_FALSE(check.mayPush()) << "while the self-test runs";
  check.feltDirection(devices::Felt::kAway);
  EXPECT_EQ(check.row(SetupItem::kForce).state, State::kBad);
  ASSERT_TRUE(check.mayPush());
  check.pushOnScale();
  pass(100);
  stylus.press(true);
  pass(1500);
  EXPECT_NEAR(device.latest().force_n, SetupCheck::kScaleN, 0.01);
  stylus.press(false);
  pass(300);
  EXPECT_EQ(device.latest().force_n, 0);
  check.scaleShowed(58);  // 0.569 N
  EXPECT_EQ(check.row(SetupItem::kForce).state, State::kBad);
  check.scaleShowed(51);  // 0.500 N
  EXPECT_EQ(check.row(SetupItem::kForce).state, State::kGood);
}

TEST_F(SetupCheckTest, WhatIsMissingIsSaid) {
  screens = {{1024, 600}};
  ASSERT_NO_FATAL_FAILURE(open(nullptr));
  EXPECT_EQ(check.row(SetupItem::kScreens).state, State::kBad);
  EXPECT_EQ(check.row(SetupItem::kLanguage).state, State::kBad);
  EXPECT_EQ(check.row(SetupItem::kConsent).state, State::kBad);
  EXPECT_NE(check.row(SetupItem::kConsent).found.indexOf(QStringLiteral("protocol")), -1);
}

TEST_F(SetupCheckTest, QuestionsAloneNeedNoDevice) {
  auto with = protocol();
  with.settings.blocks = {session::Block::kForm};
  ASSERT_NO_FATAL_FAILURE(open(&with));
  EXPECT_FALSE(device.isRunning());
  for (const SetupItem item : {SetupItem::kDevice, SetupItem::kForce, SetupItem::kLatency})
    EXPECT_EQ(check.row(item).state, State::kGood);
  check.heard(true);
  EXPECT_TRUE(certified && certified->isGood());
}

}  // namespace
}  // namespace tactus::workbench
