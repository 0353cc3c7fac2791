#include "app/workbench/base/file_dialog.h"

#include <QAbstractItemModel>
#include <QApplication>
#include <QFile>
#include <QFileInfo>
#include <QFileSystemModel>
#include <QLineEdit>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <array>
#include <gtest/gtest.h>
#include <sys/inotify.h>
#include <unistd.h>

namespace tactus::workbench {
namespace {

/// Tells whether a file was opened since it was made.
class Watch {
 public:
  explicit Watch(const QString& path) : events_(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {
    EXPECT_GE(::inotify_add_watch(events_, QFile::encodeName(path).constData(), IN_OPEN), 0);
  }
  ~Watch() { ::close(events_); }
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  bool wasOpened() {
    std::array<char, 4096> room{};
    return ::read(events_, room.data(), room.size()) > 0;
  }

 private:
  int events_;
};

class FileDialogs : public testing::Test {
 protected:
  FileDialogs() {
    QFile file(path());
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(QByteArray("SQLite format 3\0", 16) + QByteArray(4080, 'x'));
  }
  QString path() const { return folder_.filePath(QStringLiteral("open.tactus")); }

  /// Closes the dialog once it shows the file with its icon and kind.
  template <class Ask>
  void expectNotOpened(Ask ask) {
    Watch watch(path());
    bool shown = false;
    QTimer look;
    QObject::connect(&look, &QTimer::timeout, &look, [&] {
      auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
      auto* model = dialog == nullptr ? nullptr : dialog->findChild<QFileSystemModel*>();
      if (model == nullptr) return;
      const QModelIndex file = model->index(path());
      const bool has_kind = file.isValid() && !model->type(file).isEmpty() && !model->fileIcon(file).isNull();
      if (!has_kind) return;
      shown = true;
      QTest::qWait(50);  // for what Qt's own thread would do
      look.stop();
      dialog->reject();
    });
    look.start(5);
    ask();
    EXPECT_TRUE(shown);
    EXPECT_FALSE(watch.wasOpened());
  }

  QTemporaryDir folder_;
};

TEST_F(FileDialogs, ToOpenLookIntoNoFile) {
  expectNotOpened([this] { file_dialog::getOpenFileName(nullptr, QStringLiteral("x"), folder_.path()); });
}

TEST_F(FileDialogs, ToSaveLookIntoNoFile) {
  expectNotOpened([this] { file_dialog::getSaveFileName(nullptr, QStringLiteral("x"), path()); });
}

// The proposed folder, one that is there already, and one that is typed and is made.
TEST_F(FileDialogs, AFolderToWriteMayBeNew) {
  const auto answer = [this](const QString& typed) {
    QTimer::singleShot(0, qApp, [typed] {
      auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
      ASSERT_NE(dialog, nullptr);
      if (!typed.isEmpty()) {
        auto* const name = dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
        name->selectAll();
        QTest::keyClicks(name, typed);
      }
      static_cast<QDialog*>(dialog)->accept();
    });
    return file_dialog::getFolderToWrite(nullptr, QStringLiteral("x"), folder_.filePath(QStringLiteral("bundle")));
  };
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(answer({}).toStdString(), folder_.filePath(QStringLiteral("bundle")).toStdString());
    EXPECT_TRUE(QFileInfo(folder_.filePath(QStringLiteral("bundle"))).isDir());
  }
  EXPECT_EQ(answer(QStringLiteral("mine")).toStdString(), folder_.filePath(QStringLiteral("mine")).toStdString());
  EXPECT_TRUE(QFileInfo(folder_.filePath(QStringLiteral("mine"))).isDir());
}

TEST_F(FileDialogs, TheProposedNameIsTheAnswer) {
  const QString proposed = folder_.filePath(QStringLiteral("new.html"));
  QTimer::singleShot(0, qApp, [] {
    auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
    ASSERT_NE(dialog, nullptr);
    static_cast<QDialog*>(dialog)->accept();
  });
  EXPECT_EQ(file_dialog::getSaveFileName(nullptr, QStringLiteral("x"), proposed).toStdString(), proposed.toStdString());
}

}  // namespace
}  // namespace tactus::workbench
