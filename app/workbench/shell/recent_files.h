// The model and study files opened most recently, newest first, kept in the settings with the name of their model and
// the time.
#pragma once

#include <QDateTime>
#include <QList>
#include <QObject>
#include <QStringList>

class QSettings;

namespace tactus::workbench {

struct RecentFile {
  QString path;
  QString model;     ///< name of the model; empty: none is known
  QDateTime opened;  ///< invalid: not known
};

class RecentFiles : public QObject {
  Q_OBJECT

 public:
  static constexpr int kMost = 8;  ///< as many as a menu shows without scrolling

  explicit RecentFiles(QSettings& settings, QObject* parent = nullptr);

  QList<RecentFile> files() const;
  QStringList paths() const;

  /// `path` was opened or saved now. Without `model` the name that is known stays.
  void add(const QString& path, const QString& model = {});
  void remove(const QString& path);

 signals:
  void changed();

 private:
  void store(const QList<RecentFile>& files);

  QSettings& settings_;
};

/// `opened` beside `now` for the screen: `today 14:05`, `yesterday`, or the day.
QString whenText(const QDateTime& opened, const QDateTime& now);

}  // namespace tactus::workbench
