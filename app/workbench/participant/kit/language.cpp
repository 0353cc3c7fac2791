#include "app/workbench/participant/kit/language.h"

namespace tactus::workbench::nurse {

QString idOf(Language language) {
  switch (language) {
    case Language::kEnglish:
      return QStringLiteral("en");
    case Language::kTraditionalChinese:
      return QStringLiteral("zh-Hant");
    case Language::kSimplifiedChinese:
      break;
  }
  return QStringLiteral("zh-Hans");
}

std::optional<Language> languageWithId(const QString& id) {
  for (const Language language : kLanguages) {
    if (idOf(language) == id) return language;
  }
  return std::nullopt;
}

QStringList fontFamilies(Language language) {
  const QString latin = QStringLiteral("DejaVu Sans");
  switch (language) {
    case Language::kEnglish:
      return {latin};
    case Language::kTraditionalChinese:
      return {QStringLiteral("Noto Sans CJK TC"), latin};
    case Language::kSimplifiedChinese:
      break;
  }
  return {QStringLiteral("Noto Sans CJK SC"), latin};
}

}  // namespace tactus::workbench::nurse
