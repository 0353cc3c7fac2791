#include "app/workbench/tune/history/history_file.h"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>
#include <gtest/gtest.h>

#include "core/store/model_versions.h"
#include "core/store/study_file.h"

namespace tactus::workbench {
namespace {

TEST(HistoryFile, OldHistoriesMakeRoomForNewOnes) {
  const QTemporaryDir folder;
  const QStringList all = {QStringLiteral("a.tactus"), QStringLiteral("b.tactus"), QStringLiteral("c.tactus"),
                           QStringLiteral("d.tactus")};
  // From the oldest to the newest.
  study::RecordIds ids;
  for (int i = 0; i < all.size(); ++i) {
    const QString path = folder.filePath(all[i]);
    ASSERT_TRUE(store::StudyFile::create(path.toStdString(), {ids.next(), all[i].toStdString(), 0, "tests"}));
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::ReadWrite));
    ASSERT_TRUE(file.setFileTime(QDateTime(QDate(2026, 1, 1 + i), QTime(12, 0)), QFileDevice::FileModificationTime));
  }
  // A crash left the second one.
  QFile journal(folder.filePath(all[1] + QStringLiteral("-wal")));
  ASSERT_TRUE(journal.open(QIODevice::WriteOnly));
  const qint64 one = QFileInfo(folder.filePath(all[3])).size();
  const auto files = [&] {
    return QDir(folder.path()).entryList({QStringLiteral("*.tactus")}, QDir::Files, QDir::Name);
  };

  HistoryFile::makeRoom(folder.path(), 100 * one);
  EXPECT_EQ(files(), all);
  HistoryFile::makeRoom(folder.path(), one);
  EXPECT_EQ(files(), (QStringList{all[1], all[3]}));
}

TEST(HistoryFile, CopiesFromBeforeAnUpgradeGoWithTheirHistory) {
  const QTemporaryDir folder;
  study::RecordIds ids;
  const QString path = folder.filePath(QStringLiteral("a.tactus"));
  ASSERT_TRUE(store::StudyFile::create(path.toStdString(), {ids.next(), "a", 0, "tests"}));
  for (const char* name : {"a.tactus.before-v1", "gone.tactus.before-v3"}) {
    QFile copy(folder.filePath(QLatin1String(name)));
    ASSERT_TRUE(copy.open(QIODevice::WriteOnly));
  }
  const auto files = [&] { return QDir(folder.path()).entryList(QDir::Files, QDir::Name); };
  HistoryFile::makeRoom(folder.path());
  EXPECT_EQ(files(), (QStringList{QStringLiteral("a.tactus"), QStringLiteral("a.tactus.before-v1")}));
  HistoryFile::discard(path);
  EXPECT_EQ(files(), QStringList());
}

// What a state is called comes from outside: from a study, from another program.
TEST(HistoryFile, ALabelWithoutAKindStaysWhole) {
  const QTemporaryDir folder;
  for (const std::string label : {"my version", "", "edit: shoulder to 3"}) {
    const QString path = folder.filePath(QStringLiteral("h%1.tactus").arg(label.size()));
    study::RecordIds ids;
    std::string sha256;
    {
      auto file = store::StudyFile::create(path.toStdString(), {ids.next(), "h", 0, "tests"});
      ASSERT_TRUE(file);
      const study::ModelVersion version{ids.next(), {}, 1, "author", label, "{}", {}};
      ASSERT_TRUE(store::append(*file, version));
      sha256 = store::latestModelVersion(*file).value()->sha256;
    }
    ASSERT_TRUE(HistoryFile::settle(path, sha256, {"author", 2}));
    const auto file = store::StudyFile::open(path.toStdString(), {store::Access::kReadOnly, {}});
    const auto versions = store::modelVersions(*file);
    ASSERT_EQ(versions->size(), 2U);
    EXPECT_EQ(versions->back().label, label.starts_with("edit: ") ? "return: shoulder to 3" : "return: " + label);
  }
}

}  // namespace
}  // namespace tactus::workbench
