#include "app/workbench/help/guide_pages.h"

#include <QFile>
#include <QFileInfo>

// The library is static: the linker drops its resource unless the code names it, outside of any namespace.
static void carryGuide() { Q_INIT_RESOURCE(guide); }

namespace tactus::workbench {
namespace {

QString resourceOf(const QUrl& url) { return QLatin1Char(':') + url.path(); }

QString headingOf(const QUrl& url) {
  QFile file(resourceOf(url));
  if (!file.open(QIODevice::ReadOnly)) return {};
  return QString::fromUtf8(file.readLine()).remove(QLatin1Char('#')).trimmed();
}

}  // namespace

QList<GuidePage> guidePages() {
  carryGuide();
  QList<GuidePage> pages;
  for (const char* name : {"bench", "researcher-path", "researcher-session", "labs-speed", "researcher-build",
                           "own-procedure", "nurse", "simulator"}) {
    const QUrl url(QStringLiteral("qrc:/tactus/docs/guide/%1.md").arg(QLatin1String(name)));
    pages << GuidePage{url, headingOf(url)};
  }
  return pages;
}

bool isCarried(const QUrl& url) {
  carryGuide();
  return url.scheme() == QLatin1String("qrc") && QFileInfo(resourceOf(url)).isFile();
}

}  // namespace tactus::workbench
