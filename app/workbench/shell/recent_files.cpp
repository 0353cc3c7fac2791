#include "app/workbench/shell/recent_files.h"

#include <QCoreApplication>
#include <QLocale>
#include <QSettings>
#include <algorithm>

namespace tactus::workbench {
namespace {

constexpr auto kKey = "recent_files";
constexpr auto kPathsKey = "recent_models";  // paths alone, of versions before 0.3

struct RecentText {
  Q_DECLARE_TR_FUNCTIONS(RecentText)
};

}  // namespace

RecentFiles::RecentFiles(QSettings& settings, QObject* parent) : QObject(parent), settings_(settings) {}

QList<RecentFile> RecentFiles::files() const {
  QList<RecentFile> files;
  const int count = settings_.beginReadArray(QLatin1String(kKey));
  for (int i = 0; i < count; ++i) {
    settings_.setArrayIndex(i);
    files << RecentFile{settings_.value(QLatin1String("path")).toString(),
                        settings_.value(QLatin1String("model")).toString(),
                        settings_.value(QLatin1String("opened")).toDateTime()};
  }
  settings_.endArray();
  for (const QString& path : settings_.value(QLatin1String(kPathsKey)).toStringList())
    files << RecentFile{path, {}, {}};
  return files.mid(0, kMost);
}

QStringList RecentFiles::paths() const {
  QStringList paths;
  for (const RecentFile& file : files()) paths << file.path;
  return paths;
}

void RecentFiles::add(const QString& path, const QString& model) {
  QList<RecentFile> all = files();
  RecentFile now{path, model, QDateTime::currentDateTime()};
  const auto before = std::find_if(all.begin(), all.end(), [&](const RecentFile& file) { return file.path == path; });
  if (before != all.end()) {
    if (model.isEmpty()) now.model = before->model;
    all.erase(before);
  }
  all.prepend(now);
  store(all.mid(0, kMost));
}

void RecentFiles::remove(const QString& path) {
  QList<RecentFile> all = files();
  if (all.removeIf([&](const RecentFile& file) { return file.path == path; }) > 0) store(all);
}

void RecentFiles::store(const QList<RecentFile>& files) {
  settings_.remove(QLatin1String(kPathsKey));
  settings_.remove(QLatin1String(kKey));
  settings_.beginWriteArray(QLatin1String(kKey), static_cast<int>(files.size()));
  for (int i = 0; i < files.size(); ++i) {
    settings_.setArrayIndex(i);
    settings_.setValue(QLatin1String("path"), files[i].path);
    settings_.setValue(QLatin1String("model"), files[i].model);
    settings_.setValue(QLatin1String("opened"), files[i].opened);
  }
  settings_.endArray();
  emit changed();
}

QString whenText(const QDateTime& opened, const QDateTime& now) {
  if (!opened.isValid()) return {};
  const qint64 days = opened.date().daysTo(now.date());
  if (days == 0) return RecentText::tr("today %1").arg(opened.time().toString(QStringLiteral("HH:mm")));
  if (days == 1) return RecentText::tr("yesterday");
  return QLocale().toString(opened.date(), QLocale::ShortFormat);
}

}  // namespace tactus::workbench
