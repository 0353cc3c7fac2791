#include "app/workbench/base/utf8_locale.h"

#include <QLocale>
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <gtest/gtest.h>
#include <langinfo.h>
#include <string>
#include <utility>
#include <vector>

namespace tactus::workbench {
namespace {

using Variables = std::vector<std::pair<const char*, const char*>>;

/// In a process of its own: the characters and the language, with nothing else in the environment.
void expectAfter(const Variables& variables, const std::string& wanted) {
  EXPECT_EXIT(
      {
        for (const char* name : {"LC_ALL", "LC_CTYPE", "LC_NUMERIC", "LC_TIME", "LC_MESSAGES", "LANG", "LANGUAGE"})
          qunsetenv(name);
        for (const auto& [name, value] : variables) qputenv(name, value);
        QLocale::setDefault(QLocale::C);
        useUtf8Locale();
        const QString language = QLocale::languageToCode(QLocale().language());
        std::fprintf(stderr, "%s %s", nl_langinfo(CODESET), qPrintable(language));
        std::exit(0);
      },
      testing::ExitedWithCode(0), "^" + wanted + "$");
}

TEST(Utf8Locale, NothingIsSet) { expectAfter({}, "UTF-8 C"); }
TEST(Utf8Locale, LcAllIsC) { expectAfter({{"LC_ALL", "C"}, {"LANG", "de_DE.UTF-8"}}, "UTF-8 C"); }
TEST(Utf8Locale, OldCharactersKeepTheLanguage) {
  expectAfter({{"LC_ALL", "de_DE.ISO-8859-1"}}, "UTF-8 de");
  expectAfter({{"LANG", "nl_NL@euro"}}, "UTF-8 nl");
}
TEST(Utf8Locale, LocaleThatIsNotThere) {
  expectAfter({{"LANG", "nl_NL.UTF-8"}, {"LC_TIME", "xx_XX.UTF-8"}}, "UTF-8 nl");
}

}  // namespace
}  // namespace tactus::workbench
