#include "app/workbench/desktop/system_look.h"

#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusPendingCallWatcher>
#include <QDBusPendingReply>

namespace tactus::workbench {
namespace {

constexpr auto kService = "org.freedesktop.portal.Desktop";
constexpr auto kPath = "/org/freedesktop/portal/desktop";
constexpr auto kInterface = "org.freedesktop.portal.Settings";
constexpr auto kGroup = "org.freedesktop.appearance";
constexpr auto kKey = "color-scheme";
// Its values; 0 is no wish.
constexpr uint kDark = 1;
constexpr uint kLight = 2;

}  // namespace

void SystemLook::refreshState() {
  QDBusConnection bus = QDBusConnection::sessionBus();
  if (!bus.isConnected()) return;
  bus.connect(QLatin1String(kService), QLatin1String(kPath), QLatin1String(kInterface),
              QStringLiteral("SettingChanged"), this, SLOT(onSetting(QString, QString, QDBusVariant)));
  QDBusMessage ask = QDBusMessage::createMethodCall(QLatin1String(kService), QLatin1String(kPath),
                                                    QLatin1String(kInterface), QStringLiteral("Read"));
  ask << QLatin1String(kGroup) << QLatin1String(kKey);
  auto* answer = new QDBusPendingCallWatcher(bus.asyncCall(ask), this);
  connect(answer, &QDBusPendingCallWatcher::finished, this, [this, answer] {
    const QDBusPendingReply<QDBusVariant> reply = *answer;
    if (reply.isValid()) onSetting(QLatin1String(kGroup), QLatin1String(kKey), reply.value());
    answer->deleteLater();
  });
}

void SystemLook::onSetting(const QString& group, const QString& key, const QDBusVariant& value) {
  if (group != QLatin1String(kGroup) || key != QLatin1String(kKey)) return;
  // `Read` answers with a variant in a variant.
  QVariant wish = value.variant();
  if (wish.canConvert<QDBusVariant>()) wish = wish.value<QDBusVariant>().variant();
  if (wish.toUInt() == kDark) emit changed(theme::Look::kDark);
  if (wish.toUInt() == kLight) emit changed(theme::Look::kLight);
}

}  // namespace tactus::workbench
