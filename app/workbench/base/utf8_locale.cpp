#include "app/workbench/base/utf8_locale.h"

#include <QByteArray>
#include <QLocale>
#include <clocale>
#include <langinfo.h>

namespace tactus::workbench {
namespace {

bool isUtf8() { return std::setlocale(LC_ALL, "") != nullptr && qstricmp(nl_langinfo(CODESET), "UTF-8") == 0; }

/// Of the messages, such as `de_DE.ISO-8859-1`; empty where none is named.
QByteArray namedLocale() {
  for (const char* variable : {"LC_ALL", "LC_MESSAGES", "LANG"})
    if (const QByteArray name = qgetenv(variable); !name.isEmpty()) return name;
  return {};
}

}  // namespace

void useUtf8Locale() {
  if (isUtf8()) return;
  const QByteArray named = namedLocale();
  const QByteArray language = named.split('.').first().split('@').first();
  if (!language.isEmpty()) QLocale::setDefault(QLocale(QString::fromLatin1(language)));
  qputenv("LC_ALL", "C.UTF-8");
  std::setlocale(LC_ALL, "");
}

}  // namespace tactus::workbench
