// The model files opened most recently, newest first, kept in the settings.
#pragma once

#include <QObject>
#include <QStringList>

class QSettings;

namespace tactus::workbench {

class RecentFiles : public QObject {
  Q_OBJECT

 public:
  static constexpr int kMost = 8;  ///< as many as a menu shows without scrolling

  explicit RecentFiles(QSettings& settings, QObject* parent = nullptr);

  QStringList paths() const;

  void add(const QString& path);
  void remove(const QString& path);

 signals:
  void changed();

 private:
  void store(const QStringList& paths);

  QSettings& settings_;
};

}  // namespace tactus::workbench
