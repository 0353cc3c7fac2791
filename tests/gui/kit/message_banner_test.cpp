#include <QPushButton>
#include <QVBoxLayout>
#include <gtest/gtest.h>

#include "app/workbench/kit/notes.h"

namespace tactus::workbench {
namespace {

/// A window that shows messages in a banner, and a view inside it.
class Place : public QWidget, public MessagePlace {
 public:
  Place() {
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(banner);
    layout->addWidget(view);
    show();
  }
  void showError(const QString& sentence, MessageAct act, const QObject& from) override {
    banner->showRemedy(sentence, std::move(act), &from);
  }
  void takeBackError(const QObject& from) override { banner->takeBack(from); }
  void say(const QString& /*sentence*/) override {}

  QPushButton* button(const QString& text) const {
    for (QPushButton* one : banner->findChildren<QPushButton*>()) {
      if (one->isVisible() && one->text() == text) return one;
    }
    return nullptr;
  }

  MessageBanner* banner = new MessageBanner;
  QWidget* view = new QWidget;
};

TEST(MessageBannerTest, AnOfferCanHaveTwoActsAndEachEndsTheMessage) {
  const Place place;
  int copied = 0;
  int built = 0;
  const auto offer = [&] {
    place.banner->showOffer(QStringLiteral("Open for reading only."),
                            {QStringLiteral("Save a copy…"), [&copied] { ++copied; }},
                            {QStringLiteral("Build"), [&built] { ++built; }});
  };
  offer();
  ASSERT_NE(place.button(QStringLiteral("Build")), nullptr);
  place.button(QStringLiteral("Build"))->click();
  EXPECT_FALSE(place.banner->isVisible());
  offer();
  place.button(QStringLiteral("Save a copy…"))->click();
  EXPECT_EQ(copied, 1);
  EXPECT_EQ(built, 1);
  place.banner->showNote(QStringLiteral("Saved."));
  EXPECT_EQ(place.button(QStringLiteral("Build")), nullptr);
  EXPECT_EQ(place.button(QStringLiteral("Save a copy…")), nullptr);
}

TEST(MessageBannerTest, AViewOffersWhatHelpsBesideItsError) {
  Place place;
  int again = 0;
  sayError(*place.view, QStringLiteral("a.png was not saved."), {QStringLiteral("Save elsewhere…"), [&] { ++again; }});
  EXPECT_EQ(place.banner->message(), QStringLiteral("a.png was not saved."));
  ASSERT_NE(place.button(QStringLiteral("Save elsewhere…")), nullptr);
  place.button(QStringLiteral("Save elsewhere…"))->click();
  EXPECT_EQ(again, 1);
}

TEST(MessageBannerTest, AnErrorEndsWithALaterSuccessOfItsViewAlone) {
  Place place;
  QWidget other(&place);
  sayError(*place.view, QStringLiteral("a.png was not loaded."));
  ASSERT_TRUE(place.banner->isVisible());
  sayDone(other, QStringLiteral("Saved."));
  EXPECT_TRUE(place.banner->isVisible());
  sayDone(*place.view, QStringLiteral("The study has a copy of b.png."));
  EXPECT_FALSE(place.banner->isVisible());
  // What others have said since stays.
  sayError(*place.view, QStringLiteral("a.png was not loaded."));
  place.banner->showNote(QStringLiteral("Built from the answers."));
  takeBackError(*place.view);
  EXPECT_TRUE(place.banner->isVisible());
}

}  // namespace
}  // namespace tactus::workbench
