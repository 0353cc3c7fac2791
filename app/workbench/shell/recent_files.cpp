#include "app/workbench/shell/recent_files.h"

#include <QSettings>

namespace tactus::workbench {
namespace {

constexpr auto kKey = "recent_models";

}  // namespace

RecentFiles::RecentFiles(QSettings& settings, QObject* parent) : QObject(parent), settings_(settings) {}

QStringList RecentFiles::paths() const { return settings_.value(QLatin1String(kKey)).toStringList(); }

void RecentFiles::add(const QString& path) {
  QStringList list = paths();
  list.removeAll(path);
  list.prepend(path);
  while (list.size() > kMost) list.removeLast();
  store(list);
}

void RecentFiles::remove(const QString& path) {
  QStringList list = paths();
  if (list.removeAll(path) > 0) store(list);
}

void RecentFiles::store(const QStringList& paths) {
  settings_.setValue(QLatin1String(kKey), paths);
  emit changed();
}

}  // namespace tactus::workbench
