#include "tests/gui/translation_file.h"

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QXmlStreamReader>

#include "core/base/check.h"

namespace tactus::tests {

TranslationFile readTranslations(const QString& path) {
  QFile file(path);
  TACTUS_CHECK(file.open(QIODevice::ReadOnly));
  TranslationFile out;
  QXmlStreamReader xml(&file);
  QString context;
  SourceText text;
  Translation translation;
  while (!xml.atEnd()) {
    const auto token = xml.readNext();
    if (token == QXmlStreamReader::EndElement && xml.name() == QLatin1String("message")) out[text] = translation;
    if (token != QXmlStreamReader::StartElement) continue;
    const auto is = [&](const char* name) { return xml.name() == QLatin1String(name); };
    if (is("name")) {
      context = xml.readElementText();
    } else if (is("message")) {
      text = {context, {}, {}};
      translation = {};
      translation.numerus = xml.attributes().value(QLatin1String("numerus")) == QLatin1String("yes");
    } else if (is("source")) {
      text.source = xml.readElementText();
    } else if (is("comment")) {
      text.comment = xml.readElementText();
    } else if (is("translation")) {
      translation.finished = !xml.attributes().hasAttribute(QLatin1String("type"));
      if (!translation.numerus) translation.forms << xml.readElementText();
    } else if (is("numerusform")) {
      translation.forms << xml.readElementText();
    }
  }
  TACTUS_CHECK(!xml.hasError());
  return out;
}

TranslationFile textsOfTheSources(QString* warnings) {
  const QTemporaryDir folder;
  const QString path = folder.filePath(QStringLiteral("found.ts"));
  QProcess lupdate;
  lupdate.start(QStringLiteral(TACTUS_LUPDATE), {QStringLiteral("@" TACTUS_LUPDATE_LIST), QStringLiteral("-ts"), path});
  TACTUS_CHECK(lupdate.waitForFinished(-1) && lupdate.exitCode() == 0);
  if (warnings != nullptr) *warnings = QString::fromUtf8(lupdate.readAllStandardError());
  return readTranslations(path);
}

QString translationFolder() { return QStringLiteral(TACTUS_SOURCE_DIR "/app/workbench/translations"); }

}  // namespace tactus::tests
