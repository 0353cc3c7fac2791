// All texts of the nurse's screens in all languages, by id: those of strings.tsv, and the questions as the forms word
// them everywhere (questionnaires/).
#pragma once

#include <QHash>
#include <QString>
#include <QStringList>
#include <array>

#include "app/workbench/participant/kit/language.h"
#include "app/workbench/participant/kit/phrase.h"

namespace tactus::workbench::nurse {

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
