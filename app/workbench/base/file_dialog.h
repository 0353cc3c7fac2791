// The dialogs that ask for files and folders. Qt's own look into every file of a folder to tell its kind, and to open
// and close a study that is open here drops SQLite's lock on it; these tell by the name alone.
#pragma once

#include <QFileDialog>
#include <QString>

namespace tactus::workbench::file_dialog {

/// As QFileDialog's functions of the same names: an empty text where nothing was chosen.
QString getOpenFileName(QWidget* parent, const QString& caption, const QString& start = {}, const QString& filter = {});
/// Several files at once; none: nothing was chosen.
QStringList getOpenFileNames(QWidget* parent, const QString& caption, const QString& start = {},
                             const QString& filter = {});
QString getSaveFileName(QWidget* parent, const QString& caption, const QString& start = {}, const QString& filter = {},
                        QString* selected_filter = nullptr, QFileDialog::Options options = {});
QString getExistingDirectory(QWidget* parent, const QString& caption, const QString& start = {});
/// A folder to write into: `proposed`, or another one; one that is typed and does not exist is made.
QString getFolderToWrite(QWidget* parent, const QString& caption, const QString& proposed);

}  // namespace tactus::workbench::file_dialog
