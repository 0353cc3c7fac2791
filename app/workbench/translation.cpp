#include "app/workbench/translation.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>
#include <memory>

namespace tactus::workbench {
namespace {

bool add(QCoreApplication& application, const QLocale& locale, const QString& name, const QString& folder) {
  auto translator = std::make_unique<QTranslator>();
  if (!translator->load(locale, name, QStringLiteral("_"), folder)) return false;
  translator->setParent(&application);
  return QCoreApplication::installTranslator(translator.release());
}

}  // namespace

void installTranslations(QCoreApplication& application, const QLocale& locale) {
  const QString carried = QStringLiteral(":/i18n");
  const QString name = QStringLiteral("tactus");
  add(application, QLocale(QLocale::English), name, carried);
  if (locale.language() == QLocale::English || !add(application, locale, name, carried)) return;
  // The buttons of Qt's own dialogs, where the system has them.
  add(application, locale, QStringLiteral("qtbase"), QLibraryInfo::path(QLibraryInfo::TranslationsPath));
}

}  // namespace tactus::workbench
