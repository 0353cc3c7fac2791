#include "app/workbench/tune/history/history_file.h"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>
#include <gtest/gtest.h>

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

}  // namespace
}  // namespace tactus::workbench
