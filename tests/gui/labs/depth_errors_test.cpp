// What the depth lab says of an image that it did not load: what helps stands beside it, and it ends with a success.
#include <QImage>
#include <QPushButton>
#include <QTemporaryDir>
#include <QVBoxLayout>
#include <gtest/gtest.h>

#include "app/workbench/kit/notes.h"
#include "app/workbench/labs/data/settings_price.h"
#include "app/workbench/labs/depth/depth_lab.h"
#include "app/workbench/labs/depth/depth_lab_view.h"

#include "tests/gui/sample_study.h"

namespace tactus::workbench {
namespace {

using tests::comesTrue;

/// A window with its banner around the lab.
class LabWindow : public QWidget, public MessagePlace {
 public:
  LabWindow() {
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(banner);
  }
  void showError(const QString& sentence, MessageAct act, const QObject& from) override {
    banner->showRemedy(sentence, std::move(act), &from);
  }
  void takeBackError(const QObject& from) override { banner->takeBack(from); }
  void say(const QString& /*sentence*/) override {}

  MessageBanner* banner = new MessageBanner;
};

class DepthErrors : public testing::Test {
 protected:
  void SetUp() override {
    tests::makeStudyFile(path);
    study.open(path);
    ASSERT_TRUE(comesTrue([this] { return study.isOpen() && !study.isOpening(); }));
    window.layout()->addWidget(view);
    window.resize(1200, 700);
    window.show();
  }
  QString file(const QString& name, const QByteArray& bytes) const {
    QFile out(folder.filePath(name));
    EXPECT_TRUE(out.open(QIODevice::WriteOnly));
    out.write(bytes);
    return out.fileName();
  }
  QString imageFile() const {
    QImage image(300, 400, QImage::Format_Grayscale8);
    image.fill(Qt::lightGray);
    const QString name = folder.filePath(QStringLiteral("scan.png"));
    EXPECT_TRUE(image.save(name));
    return name;
  }
  QStringList acts() const {
    QStringList out;
    for (const QPushButton* button : window.banner->findChildren<QPushButton*>()) {
      if (button->isVisible()) out << button->text();
    }
    return out;
  }

  QTemporaryDir folder;
  QString path = folder.filePath(QStringLiteral("study.tactus"));
  StudyConnection study;
  LabData data{study};
  SettingsPrice price{data};
  DepthLab lab{data, [] { return QStringLiteral("tester"); }};
  LabWindow window;
  DepthLabView* view = new DepthLabView(lab, price);
};

TEST_F(DepthErrors, AFileThatIsNoImageOffersAnotherOneAndEndsWithIt) {
  for (const QString& bad : {file(QStringLiteral("notes.txt"), "no image"), folder.filePath(QStringLiteral("gone.png")),
                             file(QStringLiteral("scan.dcm"), QByteArray(128, '\0') + "DICM")}) {
    view->load(bad);
    ASSERT_TRUE(comesTrue([this] { return !view->isConverting(); }));
    EXPECT_TRUE(window.banner->isVisible());
    EXPECT_TRUE(window.banner->message().contains(QStringLiteral("was not loaded. ")))
        << window.banner->message().toStdString();
    EXPECT_EQ(acts(), QStringList{QStringLiteral("Choose another image…")});
    view->load(imageFile());
    EXPECT_FALSE(window.banner->isVisible()) << bad.toStdString();
    EXPECT_FALSE(lab.image().isEmpty());
  }
}

TEST_F(DepthErrors, TheExampleEndsTheErrorToo) {
  view->load(folder.filePath(QStringLiteral("gone.png")));
  ASSERT_TRUE(window.banner->isVisible());
  view->showExample();
  EXPECT_FALSE(window.banner->isVisible());
}

TEST_F(DepthErrors, AWriteThatWasOrderedBeforeDoesNotEndALaterError) {
  view->showExample();
  view->load(folder.filePath(QStringLiteral("gone.png")));
  ASSERT_TRUE(comesTrue([this] { return !study.isBusy(); }));
  EXPECT_TRUE(window.banner->isVisible());
}

}  // namespace
}  // namespace tactus::workbench
