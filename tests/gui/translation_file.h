// The texts of a *.ts file, and of what lupdate finds in the sources now.
#pragma once

#include <QString>
#include <QStringList>
#include <map>
#include <tuple>

namespace tactus::tests {

struct SourceText {
  QString context;
  QString source;
  QString comment;  ///< tells texts apart that read the same

  friend bool operator<(const SourceText& one, const SourceText& other) {
    return std::tie(one.context, one.source, one.comment) < std::tie(other.context, other.source, other.comment);
  }
};

struct Translation {
  bool numerus = false;   ///< has plural forms
  bool finished = false;  ///< by a translator; the file may still hold a proposal
  QStringList forms;      ///< one, or one for each plural form of the language
};

using TranslationFile = std::map<SourceText, Translation>;

/// Reads `path`, which must be there.
TranslationFile readTranslations(const QString& path);

/// What lupdate finds in the sources of the program. It warns of texts whose class it cannot tell, which no translation
/// reaches; `warnings` takes that.
TranslationFile textsOfTheSources(QString* warnings = nullptr);

/// Folder of the *.ts files of the program.
QString translationFolder();

}  // namespace tactus::tests
