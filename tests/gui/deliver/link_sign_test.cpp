// The lasting sign of the live link in the window: in the strip, and in stage Deliver.

#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QTest>
#include <gtest/gtest.h>
#include <optional>

#include "app/workbench/deliver/link/link_dialog.h"
#include "app/workbench/kit/notes.h"
#include "app/workbench/shell/operating_strip.h"

#include "tests/app/link/test_client.h"
#include "tests/gui/shown_bench.h"

namespace tactus::workbench {
namespace {

using link::TestClient;
using tests::kPatience;

class LinkSignTest : public tests::ShownBench {
 protected:
  LinkSignTest() : ShownBench(Stage::kDeliver) {}

  LinkSign& sign() { return *bench.window.findChild<LinkSign*>(); }
  LinkRow& row() { return *bench.window.findChild<LinkRow*>(); }
  QString inDeliver() { return row().findChildren<QLabel*>().first()->text(); }
  QString serving(const char* connected) {
    return QStringLiteral("Serving %1 · %2").arg(bench.link.address(), QString::fromLatin1(connected));
  }
  TestClient connect() {
    QFile file(bench.link.tokenFile());
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    TestClient client(static_cast<std::uint16_t>(bench.link.address().section(QLatin1Char(':'), 1).toUInt()));
    EXPECT_TRUE(client.send(link::helloOf(file.readLine().trimmed().toStdString(), R"("want":[])")));
    return client;
  }
  bool becomes(std::size_t clients) {
    return QTest::qWaitFor([&] { return bench.link.clients().size() == clients; }, kPatience);
  }
};

TEST_F(LinkSignTest, StandsInTheStripAndInDeliverWhileTheModelIsServed) {
  const int before_width = bench.window.minimumSizeHint().width();
  EXPECT_FALSE(sign().isVisible());
  EXPECT_TRUE(inDeliver().startsWith(QStringLiteral("Off.")));
  bench.link.start();
  settle();
  EXPECT_TRUE(sign().isVisible());
  EXPECT_EQ(sign().text(), serving("none connected"));
  EXPECT_EQ(bench.window.minimumSizeHint().width(), before_width) << "the window gets no wider by it";
  EXPECT_EQ(inDeliver(), serving("none connected"));
  {
    const TestClient first = connect();
    ASSERT_TRUE(becomes(1));
    EXPECT_EQ(sign().text(), serving("1 connected"));
    const TestClient second = connect();
    ASSERT_TRUE(becomes(2));
    EXPECT_EQ(sign().text(), serving("2 connected"));
    EXPECT_EQ(inDeliver(), serving("2 connected"));
    EXPECT_EQ(sign().accessibleName(), serving("2 connected"));
  }
  ASSERT_TRUE(becomes(0));
  const QString left = bench.link.allLeftAt()->toString(QStringLiteral("HH:mm"));
  EXPECT_EQ(sign().text(), serving("the last left at ") + left);
  EXPECT_EQ(bench.window.strip().message(), QStringLiteral("The last simulator has left."));
  bench.link.stop();
  settle();
  EXPECT_FALSE(sign().isVisible());
  EXPECT_TRUE(inDeliver().startsWith(QStringLiteral("Off.")));
  bench.link.start();
  EXPECT_EQ(inDeliver(), serving("none connected")) << "a new beginning";
}

TEST_F(LinkSignTest, LeadsToThePanelOfTheLink) {
  bench.link.start();
  settle();
  ASSERT_FALSE(bench.views.link->isVisible());
  QTest::mouseClick(&sign(), Qt::LeftButton);
  EXPECT_TRUE(bench.views.link->isVisible());
  bench.views.link->close();
  QTest::mouseClick(row().findChild<QPushButton*>(), Qt::LeftButton);
  EXPECT_TRUE(bench.views.link->isVisible());
}

TEST_F(LinkSignTest, IsShorterWhereThereIsNoRoom) {
  bench.link.start();
  settle();
  QWidget narrow;
  LinkSign one(bench.link, &narrow);
  narrow.show();
  one.resize(one.minimumSizeHint());
  EXPECT_EQ(one.text(), QStringLiteral("Serving · 0"));
  one.resize(one.sizeHint());
  EXPECT_EQ(one.text(), serving("none connected"));
}

TEST_F(LinkSignTest, APortThatIsTakenIsSaidAndAFreeOneIsOffered) {
  ModelController others;
  others.open(folder.write(tests::twoExperts(), QStringLiteral("other.tactus.json")));
  LinkController other(others);
  other.start();
  ASSERT_TRUE(other.isServing());
  LinkDialog dialog(bench.link);
  dialog.show();
  dialog.findChild<QSpinBox*>()->setValue(other.address().section(QLatin1Char(':'), 1).toInt());
  bench.link.start();
  const auto* const banner = dialog.findChild<MessageBanner*>();
  ASSERT_TRUE(banner->isVisible());
  EXPECT_TRUE(banner->message().startsWith(QStringLiteral("No simulator is served. ")))
      << banner->message().toStdString();
  QPushButton* act = nullptr;
  for (QPushButton* one : banner->findChildren<QPushButton*>()) {
    if (one->isVisible() && one->text() == QLatin1String("Take any free port")) act = one;
  }
  ASSERT_NE(act, nullptr);
  act->click();
  EXPECT_TRUE(bench.link.isServing());
  EXPECT_FALSE(banner->isVisible());
  bench.link.stop();
}

}  // namespace
}  // namespace tactus::workbench
