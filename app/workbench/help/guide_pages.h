// The pages of the guide, which the program carries (docs/guide).
#pragma once

#include <QList>
#include <QString>
#include <QUrl>

namespace tactus::workbench {

struct GuidePage {
  QUrl url;
  QString title;  ///< its first heading
};

/// In the order in which a newcomer reads them.
QList<GuidePage> guidePages();

/// Whether the program carries `url`.
bool isCarried(const QUrl& url);

}  // namespace tactus::workbench
