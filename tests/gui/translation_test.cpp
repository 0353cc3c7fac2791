// The *.ts files hold the texts of the sources as they are now, and nothing else.
#include <QCoreApplication>
#include <QDir>
#include <QLocale>
#include <gtest/gtest.h>

#include "app/workbench/program_options.h"

#include "tests/gui/translation_file.h"

namespace tactus::workbench {
namespace {

using tests::readTranslations;
using tests::SourceText;
using tests::TranslationFile;

constexpr auto kRepair =
    "Repair: cmake --build build/dev --target update_translations, then add the missing plural forms";

std::string name(const SourceText& text) { return (text.context + ": " + text.source).toStdString(); }

QStringList languages() {
  const QDir folder(tests::translationFolder());
  QStringList paths;
  for (const QString& file : folder.entryList({QStringLiteral("*.ts")})) paths << folder.filePath(file);
  return paths;
}

TEST(TranslationTest, FilesHoldTheTextsOfTheSources) {
  QString warnings;
  const TranslationFile in_sources = tests::textsOfTheSources(&warnings);
  EXPECT_EQ(warnings.toStdString(), "");
  EXPECT_GT(in_sources.size(), 700U);
  for (const QString& path : languages()) {
    // English is the language of the sources: only what it counts needs words.
    const bool english = path.endsWith(QStringLiteral("_en.ts"));
    const TranslationFile in_file = readTranslations(path);
    for (const auto& [text, translation] : in_sources) {
      if (english && !translation.numerus) continue;
      const auto held = in_file.find(text);
      EXPECT_TRUE(held != in_file.end() && held->second.numerus == translation.numerus)
          << path.toStdString() << " lacks\n  " << name(text) << '\n'
          << kRepair;
    }
    for (const auto& [text, translation] : in_file) {
      EXPECT_TRUE(in_sources.contains(text) && (translation.numerus || !english))
          << path.toStdString() << " holds, but the sources lack\n  " << name(text) << '\n'
          << kRepair;
    }
  }
}

TEST(TranslationTest, EnglishHasAllPluralForms) {
  const TranslationFile english = readTranslations(tests::translationFolder() + QStringLiteral("/tactus_en.ts"));
  int counts = 0;
  for (const auto& [text, translation] : english) {
    if (!translation.numerus) continue;
    ++counts;
    EXPECT_TRUE(translation.finished && translation.forms.size() == 2 && !translation.forms.contains(QString()))
        << name(text) << '\n'
        << kRepair;
    for (const QString& form : translation.forms) EXPECT_FALSE(form.contains(QStringLiteral("(s)"))) << name(text);
  }
  EXPECT_GT(counts, 20);
}

// main.cpp of the tests installs English, as the program does.
TEST(TranslationTest, EnglishIsCarried) {
  const auto rules = [](int count) {
    return QCoreApplication::translate("tactus::workbench::ModelHeader", "%n rule(s)", nullptr, count);
  };
  EXPECT_EQ(rules(1), QStringLiteral("1 rule"));
  EXPECT_EQ(rules(2), QStringLiteral("2 rules"));
  EXPECT_EQ(rules(0), QStringLiteral("0 rules"));
}

TEST(TranslationTest, ALanguageThatIsNotCarriedChangesNothing) {
  installTranslations(*QCoreApplication::instance(), QLocale(QStringLiteral("is_IS")));
  EXPECT_EQ(QCoreApplication::translate("tactus::workbench::ModelHeader", "%n rule(s)", nullptr, 1),
            QStringLiteral("1 rule"));
}

}  // namespace
}  // namespace tactus::workbench
