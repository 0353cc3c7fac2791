// All texts of the nurse's screens in all languages, by id (strings.tsv).
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
  QHash<QString, std::array<QString, kLanguages.size()>> texts_;
  QStringList ids_;  ///< in the order of the file
};

}  // namespace tactus::workbench::nurse
