// Follows the look of the desktop while the program runs: light or dark, as the desktop's settings portal says
// (org.freedesktop.portal.Settings, key color-scheme). Qt 6.4 reports the look only at the start of the program.
#pragma once

#include <QDBusVariant>
#include <QObject>

#include "app/workbench/base/theme.h"

namespace tactus::workbench {

class SystemLook : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  /// Asks for the look, and listens to changes. Does nothing if there is no session bus or no portal.
  void refreshState();

 public slots:
  /// A setting of the portal: emits `changed` where it is the one of the look and has a wish.
  void onSetting(const QString& group, const QString& key, const QDBusVariant& value);

 signals:
  void changed(tactus::workbench::theme::Look look);
};

}  // namespace tactus::workbench
