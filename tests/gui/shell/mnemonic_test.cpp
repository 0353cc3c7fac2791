// Alt and a letter, or a letter in an open menu, means one thing: in each language of the window.
#include <QAction>
#include <QDir>
#include <QMenu>
#include <QMenuBar>
#include <QSettings>
#include <QTranslator>
#include <gtest/gtest.h>

#include "app/workbench/workbench.h"

#include "tests/gui/sample_models.h"

namespace tactus::workbench {
namespace {

/// The letter behind a single &, in lower case; none: a null character.
QChar mnemonicOf(const QString& text) {
  for (qsizetype i = 0; i + 1 < text.size(); ++i) {
    if (text[i] != QLatin1Char('&')) continue;
    if (text[i + 1] != QLatin1Char('&')) return text[i + 1].toLower();
    ++i;
  }
  return {};
}

void expectNoClash(const QList<QAction*>& level, const QString& where, const QString& language) {
  QHash<QChar, QString> taken;
  for (QAction* action : level) {
    if (action->isSeparator()) continue;
    const QString text = action->text();
    if (const QChar letter = mnemonicOf(text); !letter.isNull()) {
      EXPECT_FALSE(taken.contains(letter)) << language.toStdString() << ", " << where.toStdString() << ": "
                                           << text.toStdString() << " and " << taken.value(letter).toStdString();
      taken.insert(letter, text);
    }
    if (action->menu() != nullptr) expectNoClash(action->menu()->actions(), where + QLatin1Char('/') + text, language);
  }
}

TEST(Mnemonics, MeanOneThingOnEachLevelOfTheMenus) {
  // English, and what the program carries besides.
  QStringList languages{QString()};
  languages << QDir(QStringLiteral(":/i18n")).entryList({QStringLiteral("tactus_*.qm")});
  EXPECT_GT(languages.size(), 1);
  for (const QString& language : languages) {
    QTranslator translator;
    if (!language.isEmpty()) {
      ASSERT_TRUE(translator.load(QStringLiteral(":/i18n/") + language)) << language.toStdString();
      QCoreApplication::installTranslator(&translator);
    }
    const tests::ModelFolder folder;
    QSettings settings(folder.path(QStringLiteral("settings.ini")), QSettings::IniFormat);
    Workbench bench(settings, folder.path(QStringLiteral("autosave")));
    expectNoClash(bench.window.menuBar()->actions(), QStringLiteral("menus"), language);
  }
}

}  // namespace
}  // namespace tactus::workbench
