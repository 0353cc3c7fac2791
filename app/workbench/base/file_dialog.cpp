#include "app/workbench/base/file_dialog.h"

#include <QFileIconProvider>
#include <QFileInfo>
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
  QFileDialog dialog(parent, caption, empty.path(), filter);
  dialog.setIconProvider(&icons);
  dialog.setOptions(question.options);
  dialog.setFileMode(question.mode);
  dialog.setAcceptMode(question.accept);
  const QFileInfo place(start.isEmpty() ? documentsFolder() : start);
  dialog.setDirectory(place.isDir() ? place.absoluteFilePath() : place.absolutePath());
  dialog.setHistory({});
  if (question.accept == QFileDialog::AcceptSave && !place.isDir()) dialog.selectFile(place.fileName());
  if (selected_filter != nullptr && !selected_filter->isEmpty()) dialog.selectNameFilter(*selected_filter);
  if (dialog.exec() != QDialog::Accepted) return {};
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

}  // namespace tactus::workbench::file_dialog
