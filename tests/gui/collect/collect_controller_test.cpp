#include "app/workbench/collect/collect_controller.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <gtest/gtest.h>

#include "app/workbench/collect/participant_table.h"
#include "core/store/persons.h"

#include "tests/gui/sample_study.h"

namespace tactus::workbench {
namespace {

using tests::comesTrue;

class CollectControllerTest : public testing::Test {
 protected:
  void open() {
    study.open(path);
    ASSERT_TRUE(comesTrue([this] { return study.isOpen() && collect.isCurrent() && isRead(); }));
  }
  bool isRead() const { return collect.overview().rows.size() == people; }

  QTemporaryDir folder;
  QString path = folder.filePath(QStringLiteral("study.tactus"));
  std::size_t people = 0;
  StudyConnection study;
  CollectController collect{study};
};

TEST_F(CollectControllerTest, ANewParticipantHasACodeOfTwoWordsAndIsInTheList) {
  tests::makeStudyFile(path);
  open();
  ParticipantTable table(collect);
  QSignalSpy added(&collect, &CollectController::added);
  collect.addParticipant();
  ASSERT_TRUE(comesTrue([&] { return table.rowCount() == 1; }));
  ASSERT_EQ(added.size(), 1);
  const QString code = added.front()[1].toString();
  EXPECT_EQ(code.count(QLatin1Char('-')), 1) << code.toStdString();
  EXPECT_EQ(table.index(0, ParticipantTable::kCode).data().toString(), code);
  EXPECT_EQ(table.index(0, ParticipantTable::kNext).data().toString(), QStringLiteral("Consent"));
  EXPECT_EQ(table.index(0, ParticipantTable::kLastSeen).data().toString(), QStringLiteral("never"));
  study.close();
  ASSERT_TRUE(comesTrue([&] { return !study.isOpen(); }));
  EXPECT_EQ(table.rowCount(), 0);
  EXPECT_EQ(store::persons(tests::lookInto(path))->size(), 1U);
}

TEST_F(CollectControllerTest, TheOverviewWaitsForTheEndOfASession) {
  tests::makeStudyFile(path);
  open();
  collect.setSessionRunning(true);
  collect.addParticipant();
  QSignalSpy added(&collect, &CollectController::added);
  ASSERT_TRUE(comesTrue([&] { return added.size() == 1; }));
  QSignalSpy read(&study, &StudyConnection::contentsChanged);
  ASSERT_TRUE(comesTrue([&] { return !read.isEmpty(); }));
  EXPECT_TRUE(collect.overview().rows.empty());
  EXPECT_FALSE(collect.isCurrent());
  collect.setSessionRunning(false);
  EXPECT_TRUE(comesTrue([&] { return collect.overview().rows.size() == 1; }));
}

TEST_F(CollectControllerTest, AWithdrawalIsCountedBeforeAndDeletesThatParticipantAlone) {
  tests::makeStudyFile(path, [](store::StudyFile& file, study::RecordIds& ids) {
    tests::addVisit(file, ids, "amber-crow", false);
    tests::addVisit(file, ids, "blue-fox", false);
  });
  people = 2;
  open();
  const study::RecordId person = collect.overview().rows.front().person;
  store::WithdrawalPreview counted;
  QObject::connect(&collect, &CollectController::previewed,
                   [&](const study::RecordId&, const store::WithdrawalPreview& preview) { counted = preview; });
  collect.previewWithdrawal(person);
  ASSERT_TRUE(comesTrue([&] { return counted.records > 0; }));
  EXPECT_EQ(counted.sessions, 1);

  QString gone;
  QObject::connect(&collect, &CollectController::withdrawn, [&](const QString& code) { gone = code; });
  collect.withdraw(person);
  EXPECT_TRUE(collect.isWithdrawing());
  ASSERT_TRUE(comesTrue([&] { return !gone.isEmpty() && collect.overview().rows.size() == 1; }));
  EXPECT_EQ(gone, QStringLiteral("amber-crow"));
  EXPECT_FALSE(collect.isWithdrawing());
  EXPECT_EQ(collect.overview().rows.front().code, QStringLiteral("blue-fox"));
}

}  // namespace
}  // namespace tactus::workbench
