// All texts of the nurse's screens in all languages, by id: those of strings.tsv, over them the words of the procedure,
// and the questions as its form words them everywhere (questionnaires/).
#pragma once

#include <QHash>
#include <QString>
#include <QStringList>
#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "core/procedure/procedure.h"

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

/// A language of the nurse's screens. A procedure may bring others than those of strings.tsv.
struct Language {
  QString id = QStringLiteral("en");  ///< BCP 47: `en`, `zh-Hant`

  bool operator==(const Language&) const = default;

  static const Language kEnglish;
  static const Language kTraditionalChinese;
  static const Language kSimplifiedChinese;
};
inline const Language Language::kEnglish{};
inline const Language Language::kTraditionalChinese{QStringLiteral("zh-Hant")};
inline const Language Language::kSimplifiedChinese{QStringLiteral("zh-Hans")};

/// Those of strings.tsv, in the order of its columns.
inline const std::array kLanguages = {Language::kEnglish, Language::kTraditionalChinese, Language::kSimplifiedChinese};

/// The languages into which the words of `procedure` are put, in its order: those to choose from where a study names
/// none.
std::vector<QString> languagesOf(const procedure::Procedure& procedure);

/// The font families, first the one with the right shapes of the language. Han characters share code points, so without
/// a named family Chinese appears in Japanese shapes; and a second font with another family of Chinese characters takes
/// the shapes of the first one unless its family stands first.
QStringList fontFamilies(const Language& language);

class Wordbook {
 public:
  /// `form`: the one of the procedure that is asked; another id: its first.
  explicit Wordbook(const procedure::Procedure& procedure = *procedure::defaultProcedure(), std::string_view form = {});

  /// `phrase` in `language`; a text that the language lacks, in the first language of the procedure, else in English.
  /// An unknown id is our own bug and stops the program.
  QString say(const Phrase& phrase, const Language& language) const;
  bool has(const QString& id) const { return texts_.contains(id); }
  QStringList ids() const { return ids_; }

 private:
  using Texts = QHash<QString, QString>;  ///< by language

  void add(const QString& id, const QString& language, const QString& text);
  void addStrings();
  void addProcedure(const procedure::Procedure& procedure);
  /// `q.item.12` and `q.ask.12`, what a question says and what it then asks; `q.instructions`, `w.very_small`, …
  void addForm(const procedure::Procedure& procedure, const study::Form& form, const QString& language);
  /// `u.1`, …
  void addUsability(const procedure::Procedure& procedure, const QString& language);
  QString text(const Texts& texts, const Language& language) const;

  QHash<QString, Texts> texts_;
  QStringList ids_;  ///< in the order of the file, then those of the procedure
  QString first_;    ///< the language in which everything of the procedure is worded
};

}  // namespace tactus::workbench::nurse
