#include "app/workbench/participant/kit/wordbook.h"

#include <QFile>
#include <QFontDatabase>
#include <QRawFont>
#include <QRegularExpression>
#include <QSet>
#include <gtest/gtest.h>
#include <iconv.h>

#include "app/workbench/base/display_text.h"

namespace tactus::workbench::nurse {
namespace {

QString textOf(const Wordbook& words, const QString& id, const Language& language) {
  return words.say(phrase(id), language);
}

QStringList placesIn(const QString& text) {
  static const QRegularExpression kPlace(QStringLiteral("%[0-9n]"));
  QStringList places;
  for (auto match = kPlace.globalMatch(text); match.hasNext();) places << match.next().captured();
  places.sort();
  return places;
}

// What simplified Chinese writes otherwise.
QSet<QChar> traditionalOnly() {
  QFile file(QStringLiteral(TACTUS_GOLDEN_DIR "/unihan/simplified.tsv"));
  EXPECT_TRUE(file.open(QIODevice::ReadOnly));
  QSet<QChar> characters;
  for (const QString& line : QString::fromUtf8(file.readAll()).split(QLatin1Char('\n'), Qt::SkipEmptyParts))
    characters.insert(line.at(0));
  EXPECT_GT(characters.size(), 2000);
  return characters;
}

TEST(Wordbook, EveryTextIsThereInEveryLanguageWithTheSamePlaces) {
  const Wordbook words;
  EXPECT_GT(words.ids().size(), 200);
  for (const QString& id : words.ids()) {
    const QStringList places = placesIn(textOf(words, id, Language::kEnglish));
    for (const Language& language : kLanguages) {
      const QString text = textOf(words, id, language);
      EXPECT_FALSE(text.trimmed().isEmpty()) << id.toStdString();
      EXPECT_EQ(text, text.trimmed()) << id.toStdString();
      // A form for one may write the number as a word of its own.
      if (id.endsWith(QLatin1String(".one"))) continue;
      EXPECT_EQ(placesIn(text), places) << id.toStdString();
    }
  }
}

TEST(Wordbook, SimplifiedChineseHasNoTraditionalCharacter) {
  const Wordbook words;
  const QSet<QChar> traditional = traditionalOnly();
  for (const QString& id : words.ids()) {
    const QString text = textOf(words, id, Language::kSimplifiedChinese);
    for (const QChar character : text)
      EXPECT_FALSE(traditional.contains(character)) << id.toStdString() << QString(character).toStdString();
  }
}

// Big5 holds the characters of Taiwan and Hong Kong, and no simplified one that traditional Chinese does not write too.
TEST(Wordbook, TraditionalChineseHasNoSimplifiedCharacter) {
  const iconv_t to_big5 = iconv_open("BIG5", "UTF-8");
  ASSERT_NE(to_big5, reinterpret_cast<iconv_t>(-1));
  const auto has = [&](const QString& text) {
    QByteArray from = text.toUtf8();
    QByteArray to(4 * from.size() + 4, 0);
    char* in = from.data();
    char* out = to.data();
    auto in_left = static_cast<std::size_t>(from.size());
    auto out_left = static_cast<std::size_t>(to.size());
    iconv(to_big5, nullptr, nullptr, nullptr, nullptr);
    return iconv(to_big5, &in, &in_left, &out, &out_left) == 0;
  };
  EXPECT_FALSE(has(QStringLiteral("阻力有多大？这")));
  const Wordbook words;
  for (const QString& id : words.ids()) {
    const QString text = textOf(words, id, Language::kTraditionalChinese);
    EXPECT_TRUE(has(text)) << id.toStdString() << ' ' << text.toStdString();
  }
  iconv_close(to_big5);
}

// Half-width marks stand in no Chinese sentence, and both texts pause at the same places.
TEST(Wordbook, ChineseHasItsOwnPunctuation) {
  const Wordbook words;
  static const QRegularExpression kHalf(QStringLiteral("[,.?!:;()]"));
  static const QRegularExpression kOther(QStringLiteral("[^，。？！：；、]"));
  for (const QString& id : words.ids()) {
    QString traditional = textOf(words, id, Language::kTraditionalChinese);
    QString simplified = textOf(words, id, Language::kSimplifiedChinese);
    EXPECT_FALSE(traditional.contains(kHalf)) << traditional.toStdString();
    EXPECT_FALSE(simplified.contains(kHalf)) << simplified.toStdString();
    EXPECT_EQ(traditional.remove(kOther), simplified.remove(kOther)) << id.toStdString();
  }
}

TEST(Wordbook, QuotationMarksAreThoseOfTheRegion) {
  const Wordbook words;
  for (const QString& id : words.ids()) {
    EXPECT_FALSE(textOf(words, id, Language::kTraditionalChinese).contains(QChar(0x201C))) << id.toStdString();
    EXPECT_FALSE(textOf(words, id, Language::kSimplifiedChinese).contains(QChar(0x300C))) << id.toStdString();
  }
}

TEST(Wordbook, CountsHaveAFormForOneInEnglish) {
  const Wordbook words;
  EXPECT_EQ(words.say(counted(QStringLiteral("code.back"), 1), Language::kEnglish),
            "Welcome back, we kept your 1 answer.");
  EXPECT_EQ(words.say(counted(QStringLiteral("code.back"), 27), Language::kEnglish),
            "Welcome back, we kept your 27 answers.");
  EXPECT_EQ(words.say(counted(QStringLiteral("rev.gaps"), 1), Language::kEnglish), "1 question is still open.");
  EXPECT_EQ(words.say(counted(QStringLiteral("rev.gaps"), 3), Language::kTraditionalChinese),
            QStringLiteral("還有 3 題未作答。"));
  for (const QString& id : words.ids()) {
    if (id.endsWith(QLatin1String(".one"))) continue;
    const bool counts = placesIn(textOf(words, id, Language::kEnglish)).contains(QStringLiteral("%n"));
    EXPECT_EQ(words.ids().contains(id + QStringLiteral(".one")), counts) << id.toStdString();
  }
}

TEST(Wordbook, ValuesTakeTheirPlaces) {
  const Wordbook words;
  EXPECT_EQ(words.say(phrase(QStringLiteral("q.title"),
                             {QStringLiteral("3"), QStringLiteral("3"), QStringLiteral("12"), QStringLiteral("45")}),
                      Language::kEnglish),
            "Part 3 of 3: question 12 of 45");
  EXPECT_EQ(words.say(plain(QStringLiteral("from the study")), Language::kSimplifiedChinese), "from the study");
}

TEST(Wordbook, TheNamedFontsHaveEveryCharacter) {
  const Wordbook words;
  for (const Language& language : kLanguages) {
    const QString family = fontFamilies(language).front();
    ASSERT_TRUE(QFontDatabase::hasFamily(family)) << family.toStdString() << ": install fonts-noto-cjk";
    QFont font(family);
    font.setPixelSize(29);
    const QRawFont raw = QRawFont::fromFont(font);
    for (const QString& id : words.ids()) {
      for (const QChar character : textOf(words, id, language))
        EXPECT_TRUE(raw.supportsCharacter(character)) << id.toStdString() << ' ' << QString(character).toStdString();
    }
    for (const QChar character : languageName(language.id)) EXPECT_TRUE(raw.supportsCharacter(character));
  }
}

}  // namespace
}  // namespace tactus::workbench::nurse
