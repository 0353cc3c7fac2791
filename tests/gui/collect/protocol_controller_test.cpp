#include "app/workbench/collect/protocol_controller.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <gtest/gtest.h>

#include "app/session/session.h"
#include "core/store/persons.h"
#include "core/store/research_key.h"
#include "core/store/study_records.h"

#include "tests/gui/sample_study.h"

namespace tactus::workbench {
namespace {

using tests::comesTrue;

class ProtocolControllerTest : public testing::Test {
 protected:
  void SetUp() override {
    tests::makeStudyFile(path);
    openStudy();
    const auto refuse = [this](const QString& sentence) { refused = sentence; };
    QObject::connect(&protocol, &ProtocolController::refused, refuse);
    QObject::connect(&protocol, &ProtocolController::keyRefused, refuse);
  }
  void openStudy() {
    study.open(path);
    ASSERT_TRUE(comesTrue([this] { return protocol.isReady(); }));
  }
  void closeStudy() {
    study.close();
    ASSERT_TRUE(comesTrue([this] { return !study.isOpen(); }));
  }
  void store(const char* reason = "") {
    QSignalSpy stored(&protocol, &ProtocolController::stored);
    protocol.store(QString::fromUtf8(reason), QStringLiteral("Ada"));
    ASSERT_TRUE(comesTrue([&] { return !stored.isEmpty() || !refused.isEmpty(); }));
    ASSERT_TRUE(comesTrue([&] { return !protocol.isStoring() && (protocol.changes() == 0 || !refused.isEmpty()); }));
  }

  QTemporaryDir folder;
  QString path = folder.filePath(QStringLiteral("study.tactus"));
  StudyConnection study;
  ProtocolController protocol{study};
  QString refused;
};

TEST_F(ProtocolControllerTest, BeginsWithThePublishedExperimentWithoutAConsentText) {
  EXPECT_EQ(protocol.version(), 0);
  EXPECT_TRUE(protocol.isDirty());
  EXPECT_EQ(protocol.value("force.ladder.highest_n"), QStringLiteral("1.7"));
  ASSERT_TRUE(protocol.problem());
  EXPECT_EQ(protocol.problem()->field, "consent.en");
  EXPECT_TRUE(protocol.isNew());
  protocol.set("force.ladder.highest_n", QStringLiteral("high"));
  EXPECT_FALSE(protocol.isNew());
  protocol.discard();
  EXPECT_TRUE(protocol.isNew());
  protocol.set("consent.en", QStringLiteral("Please read."));
  EXPECT_FALSE(protocol.problem());
  EXPECT_FALSE(protocol.isNew());
}

TEST_F(ProtocolControllerTest, ALadderThatTheDeviceCannotHoldIsRefusedAtItsField) {
  protocol.set("consent.en", QStringLiteral("Please read."));
  protocol.set("force.ladder.highest_n", QStringLiteral("2.4"));
  ASSERT_TRUE(protocol.problem());
  EXPECT_EQ(protocol.problem()->field, "force.ladder.highest_n");
  EXPECT_TRUE(protocol.problem()->sentence.contains(QStringLiteral("the force cap of the device")));
  // A stronger device holds it.
  protocol.set("device.force_cap_n", QStringLiteral("2.5"));
  EXPECT_FALSE(protocol.problem());
}

TEST_F(ProtocolControllerTest, WhatIsNoNumberChangesNothing) {
  protocol.set("speed.strokes", QStringLiteral("many"));
  ASSERT_TRUE(protocol.problem());
  EXPECT_EQ(protocol.problem()->field, "speed.strokes");
  EXPECT_EQ(protocol.value("speed.strokes"), QStringLiteral("4"));
  protocol.set("speed.strokes", QStringLiteral("6"));
  EXPECT_EQ(protocol.draft().settings.speed.strokes, 6);
  EXPECT_TRUE(protocol.isChanged("speed.strokes"));
  protocol.reset("speed.strokes");
  EXPECT_EQ(protocol.value("speed.strokes"), QStringLiteral("4"));
}

TEST_F(ProtocolControllerTest, IsADraftUntilAParticipantFollowsItThenAmendedWithAReason) {
  protocol.set("consent.en", QStringLiteral("Please read."));
  store();
  EXPECT_EQ(protocol.version(), 1);
  EXPECT_FALSE(protocol.isLocked());
  EXPECT_FALSE(protocol.isDirty());
  protocol.set("speed.strokes", QStringLiteral("5"));
  EXPECT_EQ(protocol.changes(), 1);
  store();
  EXPECT_EQ(protocol.version(), 1);  // drafts of one version

  closeStudy();
  {
    auto file = store::StudyFile::open(path.toStdString());
    ASSERT_TRUE(file);
    study::RecordIds ids;
    const study::Person person{ids.next(), "amber-crow", false};
    ASSERT_TRUE(store::append(*file, person));
    const auto start = session::startUnderProtocol(*file, person.id, "en", 1);
    ASSERT_TRUE(start) << start.error().message();
    ASSERT_TRUE(session::Session::begin(*file, *start, session::systemTools()));
    ASSERT_TRUE(file->close());
  }
  openStudy();
  EXPECT_TRUE(protocol.isLocked());
  protocol.set("speed.strokes", QStringLiteral("6"));
  store();
  EXPECT_TRUE(refused.contains(QStringLiteral("reason"))) << refused.toStdString();
  EXPECT_EQ(protocol.value("speed.strokes"), QStringLiteral("6"));  // nothing that was typed is lost
  refused.clear();
  store("more insertions");
  EXPECT_EQ(protocol.version(), 2);
  EXPECT_FALSE(protocol.isLocked());
  closeStudy();
  const auto records = store::protocols(tests::lookInto(path));
  ASSERT_TRUE(records);
  EXPECT_EQ(records->back().reason, "more insertions");
  EXPECT_EQ(records->back().author, "Ada");
}

TEST_F(ProtocolControllerTest, TheKeyIsSetChangedAndRemoved) {
  EXPECT_FALSE(protocol.hasKey());
  protocol.setKey(QStringLiteral("open sesame"));
  ASSERT_TRUE(comesTrue([this] { return protocol.hasKey(); }));
  protocol.setKey(QStringLiteral("abc"));
  ASSERT_TRUE(comesTrue([this] { return !refused.isEmpty(); }));
  EXPECT_TRUE(protocol.hasKey());
  closeStudy();
  EXPECT_TRUE(store::opensResearch(tests::lookInto(path), "open sesame").value());
  EXPECT_FALSE(store::opensResearch(tests::lookInto(path), "open").value());
}

}  // namespace
}  // namespace tactus::workbench
