#include "app/workbench/screen_pictures.h"

#include <QCommandLineParser>
#include <QDir>
#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSet>
#include <QTemporaryDir>
#include <QWidget>
#include <gtest/gtest.h>

#include "app/workbench/program_options.h"

namespace tactus::workbench {
namespace {

base::Result<ProgramOptions> optionsOf(const QStringList& arguments) {
  QCommandLineParser parser;
  describeOptions(parser);
  EXPECT_TRUE(parser.parse(QStringList{QStringLiteral("tactus-workbench")} + arguments));
  return readOptions(parser);
}

TEST(ScreenPictures, AreAllListedWithTheirSize) {
  const QTemporaryDir folder;
  const PictureSettings wanted{folder.filePath(QStringLiteral("new/pictures")), QSize(1280, 720), 1,
                               QStringLiteral("en")};
  const auto written = writeScreenPictures(wanted);
  ASSERT_TRUE(written) << written.error().message();
  QFile list(wanted.folder + QStringLiteral("/screens.json"));
  ASSERT_TRUE(list.open(QIODevice::ReadOnly));
  const QJsonArray all = QJsonDocument::fromJson(list.readAll()).array();
  QSet<QString> screens;
  for (const QJsonValue& value : all) {
    const QJsonObject picture = value.toObject();
    EXPECT_EQ(picture.keys(),
              (QStringList{QStringLiteral("area"), QStringLiteral("file"), QStringLiteral("height"),
                           QStringLiteral("language"), QStringLiteral("scale"), QStringLiteral("screen"),
                           QStringLiteral("title"), QStringLiteral("width")}));
    const QString name =
        picture[QStringLiteral("area")].toString() + QLatin1Char('/') + picture[QStringLiteral("screen")].toString();
    EXPECT_EQ(picture[QStringLiteral("file")].toString(), name + QStringLiteral(".png"));
    EXPECT_EQ(QImage(wanted.folder + QLatin1Char('/') + name + QStringLiteral(".png")).size(),
              QSize(picture[QStringLiteral("width")].toInt(), picture[QStringLiteral("height")].toInt()))
        << name.toStdString();
    EXPECT_FALSE(picture[QStringLiteral("title")].toString().isEmpty());
    // A dialog has its own size.
    static const QSet<QString> kDialogs = {QStringLiteral("help/shortcuts"), QStringLiteral("collect/withdrawal"),
                                           QStringLiteral("deliver/serve"),  QStringLiteral("help/search"),
                                           QStringLiteral("tune/carry"),     QStringLiteral("feel/blind-duel"),
                                           QStringLiteral("tune/tell"),      QStringLiteral("feel/blind-duel-trial")};
    if (!kDialogs.contains(name)) {
      EXPECT_EQ(picture[QStringLiteral("width")].toInt(), wanted.size.width());
      EXPECT_EQ(picture[QStringLiteral("height")].toInt(), wanted.size.height());
    }
    screens << name;
  }
  EXPECT_EQ(screens.size(), all.size());
  for (const char* name : {"start/start",          "understand/overview",
                           "understand/simulator", "understand/surface",
                           "build/method",         "build/depth_length",
                           "tune/overview",        "tune/rule_editor",
                           "tune/findings",        "tune/history",
                           "deliver/overview",     "deliver/bundle_made",
                           "take_part/welcome",    "take_part/question_neck",
                           "take_part/force_off",  "collect/home",
                           "collect/home_empty",   "collect/protocol",
                           "collect/withdrawal",   "collect/monitor",
                           "feel/layout",          "feel/solid",
                           "help/guide",           "help/tour_1",
                           "help/tour_8",          "help/search"}) {
    EXPECT_TRUE(screens.contains(QLatin1String(name))) << name;
  }
}

TEST(ProgramOptions, SayWhatPicturesAreWanted) {
  const auto options = optionsOf({QStringLiteral("--screens"), QStringLiteral("out"), QStringLiteral("--size"),
                                  QStringLiteral("1920x1080"), QStringLiteral("--scale"), QStringLiteral("2"),
                                  QStringLiteral("--language"), QStringLiteral("zh-Hant")});
  ASSERT_TRUE(options && options->pictures);
  EXPECT_EQ(options->pictures->folder, QStringLiteral("out"));
  EXPECT_EQ(options->pictures->size, QSize(1920, 1080));
  EXPECT_EQ(options->pictures->scale, 2);
  EXPECT_EQ(options->pictures->language, QStringLiteral("zh-Hant"));
  EXPECT_TRUE(options->pictures->study.isEmpty());
  const auto own = optionsOf(
      {QStringLiteral("--screens"), QStringLiteral("out"), QStringLiteral("--study"), QStringLiteral("ward.tactus")});
  EXPECT_EQ(own->pictures->study, QStringLiteral("ward.tactus"));
  EXPECT_FALSE(optionsOf({QStringLiteral("study.tactus")})->pictures);
}

TEST(ScreenPictures, AWidePictureIsMadeSmallerAndANarrowOneIsNot) {
  const QTemporaryDir folder;
  PictureSettings wanted;
  wanted.folder = folder.path();
  wanted.size = QSize(640, 360);
  QWidget window;
  for (const int widest_px : {320, 1000}) {
    wanted.widest_px = widest_px;
    ASSERT_TRUE(PictureAlbum(wanted).add(QStringLiteral("area"), QStringLiteral("screen"), {}, window));
    EXPECT_EQ(QImage(folder.filePath(QStringLiteral("area/screen.png"))).size(),
              widest_px == 320 ? QSize(320, 180) : wanted.size);
  }
}

TEST(ScreenPictures, OfAPackAreThoseOfItsParticipants) {
  const QTemporaryDir folder;
  PictureSettings wanted{folder.path(), QSize(640, 480), 1, QStringLiteral("zh-Hant")};
  wanted.pack = procedure::builtIn("male-urethral-catheter");
  const auto written = writeScreenPictures(wanted);
  ASSERT_TRUE(written) << written.error().message();
  EXPECT_EQ(QDir(folder.path()).entryList(QDir::Dirs | QDir::NoDotAndDotDot), QStringList{QStringLiteral("take_part")});
  for (const char* name : {"question_angle", "review_lubrication", "speed", "thanks"})
    EXPECT_TRUE(QFile::exists(folder.filePath(QStringLiteral("take_part/%1.png").arg(QLatin1String(name))))) << name;
}

TEST(ProgramOptions, NameThePackOfThePictures) {
  const QString screens = QStringLiteral("--screens=out");
  const auto options = optionsOf({screens, QStringLiteral("--pack=male-urethral-catheter")});
  ASSERT_TRUE(options) << options.error().message();
  EXPECT_EQ(options->pictures->pack->id, "male-urethral-catheter");
  EXPECT_FALSE(optionsOf({screens, QStringLiteral("--pack=no-such-pack")}));
  EXPECT_FALSE(
      optionsOf({screens, QStringLiteral("--pack=male-urethral-catheter"), QStringLiteral("--study=a.tactus")}));
}

TEST(ProgramOptions, NameTheStudyOfTheParticipants) {
  const auto options = optionsOf({QStringLiteral("--take-part"), QStringLiteral("ngt.tactus")});
  ASSERT_TRUE(options);
  EXPECT_EQ(options->take_part, QStringLiteral("ngt.tactus"));
  EXPECT_TRUE(options->file.isEmpty());
}

TEST(ProgramOptions, ThatCannotBeMeantAreASentence) {
  for (const char* bad : {"1280", "1280x", "x720", "12x720", "1280x99999", "1280x720x2", "-1280x720"}) {
    const auto options =
        optionsOf({QStringLiteral("--screens"), QStringLiteral("out"), QStringLiteral("--size=") + QLatin1String(bad)});
    ASSERT_FALSE(options) << bad;
    EXPECT_NE(options.error().message().find("1280x720"), std::string::npos);
  }
  for (const char* bad : {"0", "-960", "960.5", "9000", "wide"}) {
    EXPECT_FALSE(optionsOf(
        {QStringLiteral("--screens"), QStringLiteral("out"), QStringLiteral("--width=") + QLatin1String(bad)}))
        << bad;
  }
  for (const char* bad : {"0", "-1", "nan", "5", "two"}) {
    EXPECT_FALSE(optionsOf(
        {QStringLiteral("--screens"), QStringLiteral("out"), QStringLiteral("--scale=") + QLatin1String(bad)}))
        << bad;
  }
  for (const char* bad : {"90", "0", "big"}) {
    EXPECT_FALSE(
        optionsOf({QStringLiteral("--screens"), QStringLiteral("out"), QStringLiteral("--text=") + QLatin1String(bad)}))
        << bad;
  }
  const auto large = optionsOf({QStringLiteral("--screens"), QStringLiteral("out"), QStringLiteral("--text"),
                                QStringLiteral("150"), QStringLiteral("--dark")});
  ASSERT_TRUE(large);
  EXPECT_EQ(large->pictures->text_percent, 150);
  EXPECT_TRUE(large->pictures->dark);
}

TEST(ProgramOptions, ALanguageThatThePicturesLackIsRefused) {
  const auto options = optionsOf({QStringLiteral("--screens"), QStringLiteral("out"), QStringLiteral("--language=xx")});
  ASSERT_FALSE(options);
  EXPECT_EQ(options.error().message(), "--language: found 'xx', wanted en, zh-Hant or zh-Hans");
}

TEST(ProgramOptions, WhatWouldBeIgnoredIsRefused) {
  for (const char* alone : {"--speed=2", "--size=1280x720", "--scale=2", "--width=960", "--text=150", "--dark",
                            "--language=en", "--study=a.tactus", "--pack=male-urethral-catheter"}) {
    EXPECT_FALSE(optionsOf({QLatin1String(alone)})) << alone;
  }
  const auto two = optionsOf({QStringLiteral("a.tactus"), QStringLiteral("--rehearse")});
  ASSERT_FALSE(two);
  EXPECT_EQ(two.error().message(),
            "found --rehearse and 'a.tactus', wanted one of them (the study of --rehearse and --screens is named by "
            "--study)");
  EXPECT_FALSE(optionsOf({QStringLiteral("a.tactus"), QStringLiteral("b.tactus")}));
  EXPECT_FALSE(optionsOf({QStringLiteral("--screens=out"), QStringLiteral("--rehearse")}));
  EXPECT_TRUE(
      optionsOf({QStringLiteral("--rehearse"), QStringLiteral("--speed=2"), QStringLiteral("--study=a.tactus")}));
}

}  // namespace
}  // namespace tactus::workbench
