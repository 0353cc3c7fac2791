#include "app/workbench/study/connection/study_connection.h"

#include <QFile>
#include <QFileInfo>
#include <gtest/gtest.h>
#include <memory>

#include "core/store/persons.h"

#include "tests/gui/sample_models.h"
#include "tests/gui/sample_study.h"
#include "tests/support/as_nobody.h"
#include "tests/support/french_probe.h"

namespace tactus::workbench {
namespace {

using tests::comesTrue;

// The study alone: no model, no history.
class StudyConnectionTest : public testing::Test {
 protected:
  void SetUp() override {
    tests::makeStudyFile(
        path, [](store::StudyFile& file, study::RecordIds& ids) { tests::addVisit(file, ids, "velvet-otter", false); });
    QObject::connect(study.get(), &StudyConnection::failed,
                     [this](const QString&, const QString& sentence) { failed = sentence; });
    study->open(path);
    ASSERT_TRUE(comesTrue([this] { return study->isOpen(); })) << failed.toStdString();
  }
  void closeStudy() {
    study->close();
    ASSERT_TRUE(comesTrue([this] { return !study->isOpen(); })) << failed.toStdString();
  }
  void addPerson(const char* code) {
    study->order([code](store::StudyFile& file, study::RecordIds& ids) {
      return store::append(file, study::Person{ids.next(), code, false});
    });
  }
  std::size_t personsInFile() { return store::persons(tests::lookInto(path))->size(); }

  tests::ModelFolder folder;
  QString path = folder.path(QStringLiteral("people.tactus"));
  std::unique_ptr<StudyConnection> study = std::make_unique<StudyConnection>();
  QString failed;
};

TEST_F(StudyConnectionTest, OpensAndWritesAStudyWithoutAnyModel) {
  ASSERT_EQ(study->people().size(), 1U);
  EXPECT_EQ(study->people()[0].code, QStringLiteral("velvet-otter"));
  addPerson("calm-fox");
  study->refresh();
  EXPECT_TRUE(comesTrue([this] { return study->people().size() == 2; }));
  closeStudy();
  EXPECT_TRUE(failed.isEmpty()) << failed.toStdString();
  EXPECT_EQ(personsInFile(), 2U);
}

TEST_F(StudyConnectionTest, ANewStudyKeepsItsProcedure) {
  EXPECT_EQ(study->procedure(), procedure::defaultProcedure());
  const QString other = folder.path(QStringLiteral("probe.tactus"));
  const auto probe = support::frenchProbe();
  study->create(other, probe);
  ASSERT_TRUE(comesTrue([&] { return study->path() == other; })) << failed.toStdString();
  EXPECT_EQ(study->procedure()->sha256, probe->sha256);
  study->open(path);
  ASSERT_TRUE(comesTrue([&] { return study->path() == path; }));
  EXPECT_EQ(study->procedure(), procedure::defaultProcedure());
  study->open(other);
  ASSERT_TRUE(comesTrue([&] { return study->path() == other; }));
  EXPECT_EQ(study->procedure()->sha256, probe->sha256);
  closeStudy();
  EXPECT_EQ(study->procedure(), procedure::defaultProcedure());
}

TEST_F(StudyConnectionTest, ItsEndWaitsForWhatWasOrdered) {
  addPerson("calm-fox");
  study.reset();
  EXPECT_EQ(personsInFile(), 2U);
}

TEST_F(StudyConnectionTest, WhatMayNotBeWrittenOpensForReading) {
  closeStudy();
  const QString folder_path = QFileInfo(path).absolutePath();
  const auto readable = QFile::ReadOwner | QFile::ReadGroup | QFile::ReadOther;
  const auto entered = QFile::ExeOwner | QFile::ExeGroup | QFile::ExeOther;
  ASSERT_TRUE(QFile::setPermissions(path, readable));
  ASSERT_TRUE(QFile::setPermissions(folder_path, readable | entered));
  {
    const support::AsNobody nobody;
    study->open(path);
    ASSERT_TRUE(comesTrue([this] { return study->isOpen(); })) << failed.toStdString();
    EXPECT_TRUE(study->isReadOnly());
    EXPECT_FALSE(study->takesOrders());
    EXPECT_EQ(study->people().size(), 1U);
    study->close();
    ASSERT_TRUE(comesTrue([this] { return !study->isOpen(); })) << failed.toStdString();
  }
  EXPECT_FALSE(study->isReadOnly());
  EXPECT_TRUE(failed.isEmpty()) << failed.toStdString();
  ASSERT_TRUE(QFile::setPermissions(folder_path, readable | entered | QFile::WriteOwner));
  ASSERT_TRUE(QFile::setPermissions(path, readable | QFile::WriteOwner));
  EXPECT_EQ(personsInFile(), 1U);
}

TEST_F(StudyConnectionTest, ACopyHoldsWhatWasOrdered) {
  addPerson("calm-fox");
  const QString copy = folder.path(QStringLiteral("copy.tactus"));
  bool copied = false;
  QObject::connect(study.get(), &StudyConnection::copied, [&](const QString& to) { copied = to == copy; });
  study->saveCopy(copy);
  ASSERT_TRUE(comesTrue([&] { return copied; })) << failed.toStdString();
  EXPECT_EQ(store::persons(tests::lookInto(copy))->size(), 2U);
  QString refused;
  QObject::connect(study.get(), &StudyConnection::copyFailed, [&](const QString& sentence) { refused = sentence; });
  study->saveCopy(copy);  // nothing is written over
  ASSERT_TRUE(comesTrue([&] { return !refused.isEmpty(); }));
  EXPECT_TRUE(refused.contains(QStringLiteral("copy.tactus"))) << refused.toStdString();
}

TEST_F(StudyConnectionTest, WhatAReplacedStudyRefusedIsWrittenInTheCopy) {
  addPerson("calm-fox");
  ASSERT_TRUE(comesTrue([this] { return !study->isBusy(); }));
  const QString other = folder.path(QStringLiteral("other.tactus"));
  tests::makeStudyFile(other);
  ASSERT_TRUE(QFile::remove(path));
  ASSERT_TRUE(QFile::rename(other, path));
  addPerson("quiet-heron");
  ASSERT_TRUE(comesTrue([this] { return !study->failure().isEmpty(); }));

  const QString copy = folder.path(QStringLiteral("copy.tactus"));
  study->moveTo(copy);
  ASSERT_TRUE(comesTrue([&] { return study->path() == copy && !study->isOpening(); })) << failed.toStdString();
  EXPECT_TRUE(comesTrue([this] { return study->failure().isEmpty() && study->people().size() == 3; }));
  addPerson("bright-tern");
  closeStudy();
  EXPECT_EQ(store::persons(tests::lookInto(copy))->size(), 4U);
  EXPECT_EQ(personsInFile(), 0U) << "the file that came in its place is as it was";
}

TEST_F(StudyConnectionTest, NothingIsDeliveredToAnAskerThatHasEnded) {
  auto asker = std::make_unique<QObject>();
  bool delivered = false;
  bool later = false;
  const auto tell = [](bool& told) {
    return [&told](const store::StudyFile&) -> StudyConnection::Deliver { return [&told] { told = true; }; };
  };
  study->read(*asker, tell(delivered));
  asker.reset();
  study->read(*study, tell(later));
  ASSERT_TRUE(comesTrue([&] { return later; }));
  EXPECT_FALSE(delivered);
}

TEST_F(StudyConnectionTest, AReadingOfAClosedStudyIsAnswered) {
  bool was_read = false;
  bool was_closed = false;
  closeStudy();
  study->read(
      *study, [&](const store::StudyFile&) -> StudyConnection::Deliver { return [&] { was_read = true; }; },
      [&] { was_closed = true; });
  EXPECT_TRUE(comesTrue([&] { return was_closed; }));
  EXPECT_FALSE(was_read);
}

TEST_F(StudyConnectionTest, WhatHoldsTheFileIsDroppedBeforeItIsClosedOrExchanged) {
  const QString other = folder.path(QStringLiteral("other.tactus"));
  tests::makeStudyFile(other);
  auto first = std::make_shared<bool>(false);
  auto second = std::make_shared<bool>(false);
  study->beforeClosing([first] { *first = true; });
  EXPECT_FALSE(*first);
  study->open(other);
  ASSERT_TRUE(comesTrue([&] { return study->path() == other && !study->isOpening(); }));
  study->beforeClosing([second] { *second = true; });
  closeStudy();
  EXPECT_TRUE(*first);
  EXPECT_TRUE(*second);
}

}  // namespace
}  // namespace tactus::workbench
