// Every screen of the nurse at each size, size of text and language: nothing cut, overlapping, elided or too small.
// TACTUS_PICTURES=FOLDER keeps the pictures.
#include <QAbstractButton>
#include <QAccessible>
#include <QApplication>
#include <QDir>
#include <QLabel>
#include <gtest/gtest.h>
#include <set>

#include "app/workbench/participant/kit/button.h"
#include "app/workbench/participant/kit/label.h"
#include "app/workbench/participant/kit/screen_frame.h"
#include "app/workbench/participant/screens/sample_screens.h"

#include "tests/gui/text_recorder.h"

namespace tactus::workbench {
namespace {

using nurse::Language;
using nurse::Look;
using tests::textsOf;
using tests::WrittenText;

constexpr double kDotsPerInch = 96;
constexpr double kSlack = 2;  // px, of rounding

struct Setting {
  QSize size;
  int percent;
  Language language;
  std::string pack = {};  ///< of another procedure
};

std::string nameOf(const Setting& setting) {
  return QStringLiteral("%1x%2_%3_%4")
      .arg(setting.size.width())
      .arg(setting.size.height())
      .arg(setting.percent)
      .arg(setting.language.id + QString::fromStdString(setting.pack.empty() ? "" : "_" + setting.pack))
      .replace(QLatin1Char('-'), QLatin1Char('_'))
      .toStdString();
}

class NurseScreens : public testing::TestWithParam<Setting> {
 protected:
  void SetUp() override {
    if (!GetParam().pack.empty()) look.setAbout(procedure::builtIn(GetParam().pack));
    look.setLanguage(GetParam().language);
    look.setTextPercent(GetParam().percent);
    look.setScreen(kDotsPerInch, GetParam().size);
  }

  std::unique_ptr<QWidget> shown(const nurse::SampleScreen& sample) const {
    std::unique_ptr<QWidget> screen = sample.make(look);
    screen->resize(GetParam().size);
    screen->show();
    QCoreApplication::processEvents();
    QCoreApplication::sendPostedEvents();
    return screen;
  }

  Look look;
};

TEST_P(NurseScreens, NothingIsCutOrElidedOrTooSmall) {
  for (const nurse::SampleScreen& sample : nurse::sampleScreens(look)) {
    const auto screen = shown(sample);
    const QString name = sample.name;
    const std::vector<WrittenText> texts = textsOf(*screen);
    EXPECT_FALSE(texts.empty()) << name.toStdString();
    for (const WrittenText& written : texts) {
      const std::string where = name.toStdString() + ": " + written.text.toStdString();
      EXPECT_TRUE(written.clip.adjusted(-kSlack, -kSlack, kSlack, kSlack).contains(written.box)) << "cut " << where;
      EXPECT_GE(written.font.pixelSize(), look.textPx()) << where;
      // One text of the screens has three dots of its own.
      const bool own_dots = look.say(nurse::phrase(QStringLiteral("own.line"))).contains(written.text.trimmed());
      EXPECT_TRUE(own_dots || !written.text.contains(QChar(0x2026))) << "elided " << where;
    }
    const QByteArray folder = qgetenv("TACTUS_PICTURES");
    if (!folder.isEmpty()) {
      const QDir dir(QString::fromLocal8Bit(folder) + QLatin1Char('/') + QString::fromStdString(nameOf(GetParam())));
      dir.mkpath(QStringLiteral("."));
      EXPECT_TRUE(screen->grab().save(dir.filePath(name + QStringLiteral(".png"))));
    }
  }
}

TEST_P(NurseScreens, EachHasAPicture) {
  std::set<ParticipantScreen> shown_there;
  for (const nurse::SampleScreen& sample : nurse::sampleScreens(look)) {
    if (sample.screen) shown_there.insert(*sample.screen);
  }
  for (const ScreenFacts& facts : kScreenFacts) EXPECT_TRUE(shown_there.contains(facts.screen)) << facts.id;
}

TEST_P(NurseScreens, NothingOverlaps) {
  for (const nurse::SampleScreen& sample : nurse::sampleScreens(look)) {
    const auto screen = shown(sample);
    std::vector<WrittenText> texts = textsOf(*screen);
    // Where the red button of the window stands, at the top right.
    const QSize corner = nurse::forceOffCorner(look);
    const int margin = nurse::frameMargin(look);
    texts.push_back({QStringLiteral("force off"),
                     QRectF(screen->width() - margin - corner.width(), margin, corner.width(), corner.height()),
                     {},
                     {}});
    for (std::size_t i = 0; i < texts.size(); ++i) {
      for (std::size_t j = i + 1; j < texts.size(); ++j) {
        const QRectF both = texts[i].box & texts[j].box;
        EXPECT_TRUE(both.width() <= kSlack || both.height() <= kSlack)
            << sample.name.toStdString() << ": " << texts[i].text.toStdString() << " / " << texts[j].text.toStdString();
      }
    }
    const QList<QAbstractButton*> buttons = screen->findChildren<QAbstractButton*>();
    for (qsizetype i = 0; i < buttons.size(); ++i) {
      if (!buttons[i]->isVisible()) continue;
      const QRect box = QRect(buttons[i]->mapTo(screen.get(), QPoint()), buttons[i]->size());
      EXPECT_TRUE(screen->rect().contains(box))
          << sample.name.toStdString() << ": " << buttons[i]->text().toStdString();
      for (qsizetype j = i + 1; j < buttons.size(); ++j) {
        if (!buttons[j]->isVisible()) continue;
        const QRect other = QRect(buttons[j]->mapTo(screen.get(), QPoint()), buttons[j]->size());
        const QRect both = box & other;
        // The room for the ring of one may reach into that of the other.
        EXPECT_TRUE(both.width() <= 2 * nurse::kRingRoom || both.height() <= 2 * nurse::kRingRoom)
            << sample.name.toStdString() << ": " << buttons[i]->text().toStdString() << " / "
            << buttons[j]->text().toStdString();
      }
    }
  }
}

TEST_P(NurseScreens, EveryTextGetsItsRoom) {
  for (const nurse::SampleScreen& sample : nurse::sampleScreens(look)) {
    const auto screen = shown(sample);
    for (const nurse::Label* label : screen->findChildren<nurse::Label*>()) {
      if (!label->isVisible() || label->text().isEmpty()) continue;
      const std::string where = sample.name.toStdString() + ": " + label->text().toStdString();
      const int needed = label->wordWrap() ? label->heightForWidth(label->width()) : label->sizeHint().height();
      EXPECT_GE(label->height() + kSlack, needed) << where;
      EXPECT_TRUE(screen->rect().contains(QRect(label->mapTo(screen.get(), QPoint()), label->size()))) << where;
    }
    for (QAbstractButton* button : screen->findChildren<QAbstractButton*>()) {
      if (!button->isVisible()) continue;
      const QAccessibleInterface* spoken = QAccessible::queryAccessibleInterface(button);
      ASSERT_NE(spoken, nullptr);
      EXPECT_FALSE(spoken->text(QAccessible::Name).isEmpty()) << sample.name.toStdString();
    }
  }
}

std::vector<Setting> settings() {
  std::vector<Setting> all;
  for (const Language& language : nurse::kLanguages) {
    for (const QSize size : {QSize(1280, 720), QSize(1920, 1080)}) {
      for (const int percent : {100, 125, 150}) all.push_back({size, percent, language});
    }
  }
  for (const std::string& pack : procedure::builtInIds()) {
    if (procedure::builtIn(pack) == procedure::defaultProcedure()) continue;
    for (const Language& language : {Language::kEnglish, Language::kTraditionalChinese}) {
      for (const int percent : {100, 150}) all.push_back({{1280, 720}, percent, language, pack});
    }
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(Sizes, NurseScreens, testing::ValuesIn(settings()),
                         [](const testing::TestParamInfo<Setting>& setting) { return nameOf(setting.param); });

}  // namespace
}  // namespace tactus::workbench
