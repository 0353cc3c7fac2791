// All texts of the nurse's screens in all languages, by id: those of strings.tsv, and the questions as the forms word
// them everywhere (questionnaires/).
#pragma once

#include <QHash>
#include <QString>
#include <QStringList>
#include <array>
#include <optional>

namespace tactus::workbench::nurse {

/// A text of the nurse's screens before a language is chosen: an id of the word book with its values.
struct Phrase {
  QString id;                ///< of the word book; empty: `plain` is shown
  QStringList values;        ///< for %1, %2, …
  std::optional<int> count;  ///< for %n
  QString plain;             ///< a text of the study or of the person, the same in every language

  bool operator==(const Phrase&) const = default;
  bool isEmpty() const { return id.isEmpty() && plain.isEmpty(); }
};

inline Phrase phrase(const QString& id, const QStringList& values = {}) { return {id, values, std::nullopt, {}}; }
inline Phrase counted(const QString& id, int count) { return {id, {}, count, {}}; }
inline Phrase plain(const QString& text) { return {{}, {}, std::nullopt, text}; }

/// The languages of the nurse's screens.
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

class Wordbook {
 public:
  Wordbook();

  /// `phrase` in `language`. An unknown id is our own bug and stops the program.
  QString say(const Phrase& phrase, Language language) const;
  QStringList ids() const { return ids_; }

 private:
  void add(const QString& id, Language language, const QString& text);
  /// `q.depth.oropharynx`, `q.question`, `w.very_small`, `u.1`, …
  void addForms(Language language);

  QHash<QString, std::array<QString, kLanguages.size()>> texts_;
  QStringList ids_;  ///< in the order of the file, then those of the forms
};

}  // namespace tactus::workbench::nurse
