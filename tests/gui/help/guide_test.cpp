#include <QDir>
#include <QListWidget>
#include <QRegularExpression>
#include <QTextDocument>
#include <gtest/gtest.h>

#include "app/workbench/help/guide_pages.h"
#include "app/workbench/help/guide_window.h"

namespace tactus::workbench {
namespace {

QDir docs() { return QDir(QStringLiteral(TACTUS_SOURCE_DIR "/docs")); }

TEST(Guide, HasEachPageOfItsFolderWithItsHeading) {
  const QList<GuidePage> pages = guidePages();
  EXPECT_EQ(pages.size(), QDir(docs().filePath(QStringLiteral("guide"))).entryList({QStringLiteral("*.md")}).size());
  for (const GuidePage& page : pages) {
    EXPECT_TRUE(isCarried(page.url)) << page.url.toString().toStdString();
    EXPECT_FALSE(page.title.isEmpty()) << page.url.toString().toStdString();
  }
}

TEST(Guide, CarriesEveryPictureAndPageThatItsPagesName) {
  const QRegularExpression named(QStringLiteral("\\]\\(([^)#]+)"));
  for (const GuidePage& page : guidePages()) {
    QFile file(QLatin1Char(':') + page.url.path());
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    auto found = named.globalMatch(QString::fromUtf8(file.readAll()));
    while (found.hasNext()) {
      const QString link = found.next().captured(1);
      if (!link.endsWith(QLatin1String(".png")) && !link.endsWith(QLatin1String(".md"))) continue;
      EXPECT_TRUE(isCarried(page.url.resolved(QUrl(link))))
          << page.url.toString().toStdString() << ": " << link.toStdString();
    }
  }
}

TEST(Guide, ALinkBetweenPagesStaysInTheWindow) {
  GuideWindow window;
  auto* pages = window.findChild<QListWidget*>();
  ASSERT_NE(pages, nullptr);
  const QList<GuidePage> all = guidePages();
  ASSERT_EQ(pages->count(), all.size());
  EXPECT_EQ(window.browser().source(), all[0].url);
  EXPECT_TRUE(window.browser().toPlainText().startsWith(all[0].title));
  emit window.browser().anchorClicked(QUrl(QStringLiteral("simulator.md#anything")));
  EXPECT_TRUE(window.browser().source().path().endsWith(QLatin1String("simulator.md")));
  EXPECT_EQ(pages->currentItem()->text(), all.last().title);
  emit window.browser().anchorClicked(QUrl(QStringLiteral("../../app/no_page.cpp")));
  EXPECT_TRUE(window.browser().source().path().endsWith(QLatin1String("simulator.md")));
}

TEST(Guide, APictureFitsTheColumn) {
  GuideBrowser browser;
  browser.showPage(QUrl(QStringLiteral("qrc:/tactus/docs/guide/nurse.md")));
  const QVariant picture =
      browser.document()->resource(QTextDocument::ImageResource, QUrl(QStringLiteral("pictures/nurse-welcome.png")));
  const auto pixmap = picture.value<QPixmap>();
  ASSERT_FALSE(pixmap.isNull());
  EXPECT_LE(pixmap.deviceIndependentSize().width(), 640);
}

}  // namespace
}  // namespace tactus::workbench
