// The languages of the nurse's screens.
#pragma once

#include <QString>
#include <QStringList>
#include <array>
#include <optional>

namespace tactus::workbench::nurse {

enum class Language { kEnglish, kTraditionalChinese, kSimplifiedChinese };

inline constexpr std::array kLanguages = {Language::kEnglish, Language::kTraditionalChinese,
                                          Language::kSimplifiedChinese};

/// `en`, `zh-Hant`, `zh-Hans`.
QString idOf(Language language);
std::optional<Language> languageWithId(const QString& id);

/// The font families, first the one with the right shapes of the language. Han characters share code points, so without
/// a named family Chinese appears in Japanese shapes; and a second font with another family of Chinese characters takes
/// the shapes of the first one unless its family stands first.
QStringList fontFamilies(Language language);

}  // namespace tactus::workbench::nurse
