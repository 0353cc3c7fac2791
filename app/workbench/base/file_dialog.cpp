#include "app/workbench/base/file_dialog.h"

#include <QDir>
#include <QFileIconProvider>
#include <QFileInfo>
#include <QLineEdit>
#include <QTemporaryDir>

#include "app/workbench/base/documents.h"

namespace tactus::workbench::file_dialog {
namespace {

class PlainIcons : public QFileIconProvider {
 public:
  using QFileIconProvider::icon;
  QIcon icon(const QFileInfo& info) const override { return icon(info.isDir() ? Folder : File); }
  QString type(const QFileInfo& info) const override { return info.isDir() ? QString() : info.suffix(); }
};

/// Qt's own one says of the name of a new folder that it was not found, and takes the folder that is marked in the list
/// before the one that is typed.
class Dialog : public QFileDialog {
 public:
  using QFileDialog::QFileDialog;
  void accept() override {
    const auto* const name = findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
    const bool names = fileMode() == Directory && acceptMode() == AcceptSave && name != nullptr;
    if (!names || name->text().isEmpty()) return QFileDialog::accept();
    folder_ = directory().absoluteFilePath(name->text());
    QDir().mkpath(folder_);
    QDialog::accept();
  }
  /// The folder to write into; empty for any other question.
  const QString& folder() const { return folder_; }

 private:
  QString folder_;
};

struct Question {
  QFileDialog::FileMode mode = QFileDialog::ExistingFile;
  QFileDialog::AcceptMode accept = QFileDialog::AcceptOpen;
  QFileDialog::Options options = {};
};

QStringList ask(QWidget* parent, const QString& caption, const QString& start, const QString& filter,
                const Question& question, QString* selected_filter) {
  PlainIcons icons;
  // Qt's dialog looks into the files of its first folder before it can be told not to.
  const QTemporaryDir empty;
  Dialog dialog(parent, caption, empty.path(), filter);
  dialog.setIconProvider(&icons);
  dialog.setOptions(question.options);
  dialog.setFileMode(question.mode);
  dialog.setAcceptMode(question.accept);
  const QFileInfo place(start.isEmpty() ? documentsFolder() : start);
  const bool names =
      question.accept == QFileDialog::AcceptSave && (question.mode == QFileDialog::Directory || !place.isDir());
  dialog.setDirectory(names || !place.isDir() ? place.absolutePath() : place.absoluteFilePath());
  dialog.setHistory({});
  if (names) dialog.selectFile(place.fileName());
  if (selected_filter != nullptr && !selected_filter->isEmpty()) dialog.selectNameFilter(*selected_filter);
  if (dialog.exec() != QDialog::Accepted) return {};
  if (!dialog.folder().isEmpty()) return {dialog.folder()};
  if (selected_filter != nullptr) *selected_filter = dialog.selectedNameFilter();
  return dialog.selectedFiles();
}

}  // namespace

QString getOpenFileName(QWidget* parent, const QString& caption, const QString& start, const QString& filter) {
  return ask(parent, caption, start, filter, {}, nullptr).value(0);
}

QStringList getOpenFileNames(QWidget* parent, const QString& caption, const QString& start, const QString& filter) {
  return ask(parent, caption, start, filter, {QFileDialog::ExistingFiles}, nullptr);
}

QString getSaveFileName(QWidget* parent, const QString& caption, const QString& start, const QString& filter,
                        QString* selected_filter, QFileDialog::Options options) {
  return ask(parent, caption, start, filter, {QFileDialog::AnyFile, QFileDialog::AcceptSave, options}, selected_filter)
      .value(0);
}

QString getExistingDirectory(QWidget* parent, const QString& caption, const QString& start) {
  return ask(parent, caption, start, {}, {QFileDialog::Directory, QFileDialog::AcceptOpen, QFileDialog::ShowDirsOnly},
             nullptr)
      .value(0);
}

QString getFolderToWrite(QWidget* parent, const QString& caption, const QString& proposed) {
  return ask(parent, caption, proposed, {},
             {QFileDialog::Directory, QFileDialog::AcceptSave, QFileDialog::ShowDirsOnly}, nullptr)
      .value(0);
}

}  // namespace tactus::workbench::file_dialog
