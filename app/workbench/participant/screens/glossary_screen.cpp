#include "app/workbench/participant/screens/glossary_screen.h"

#include <algorithm>

#include "app/workbench/participant/kit/choices.h"
#include "app/workbench/participant/screens/glossary_page.h"

namespace tactus::workbench::nurse {

GlossaryScreen::GlossaryScreen(const Look& look, QWidget* parent)
    : ScreenFrame(look, parent), pages_(new QStackedWidget(this)) {
  const auto add = [&](const char* sentence, TextRole role = TextRole::kLead) {
    auto* page = new GlossaryPage(look, role, phrase(QString::fromLatin1(sentence)), pages_);
    pages_->addWidget(page);
    return page;
  };
  GlossaryPage* start = add("q.instructions", TextRole::kBody);
  start->addWay(phrase(QStringLiteral("glo.from_side")));
  start->addInset(phrase(QStringLiteral("glo.from_front")), anatomy::Inset::kFront);
  GlossaryPage* force = add("glo.force");
  for (const Answer& word : forceWords()) {
    if (!word.apart) force->addPicture(word.word, word.picture);
  }
  GlossaryPage* way = add("glo.way");
  way->addRegions();
  way->addInset(phrase(QStringLiteral("glo.from_behind")), anatomy::Inset::kBehind);
  GlossaryPage* lubrication = add("glo.lubrication");
  int level = 0;
  for (const char* id : {"s.lubrication.poor", "s.lubrication.medium", "s.lubrication.well"})
    lubrication->addPicture(phrase(QString::fromLatin1(id)), lubricationPicture(++level));
  GlossaryPage* neck = add("glo.neck");
  neck->addPosture(phrase(QStringLiteral("glo.neck_0")), anatomy::Posture::kUpright);
  neck->addPosture(phrase(QStringLiteral("glo.neck_1")), anatomy::Posture::kHalfFlexed);
  neck->addPosture(phrase(QStringLiteral("glo.neck_2")), anatomy::Posture::kChinOnChest);
  GlossaryPage* speed = add("glo.speed");
  level = 0;
  for (const char* id : {"s.speed.slow", "s.speed.medium", "s.speed.fast"})
    speed->addPicture(phrase(QString::fromLatin1(id)), speedPicture(++level));

  setTitle(phrase(QStringLiteral("glo.title")));
  setMain(pages_);
  connect(this, &ScreenFrame::back, this, [this] {
    if (pages_->currentIndex() == 0) {
      emit left();
    } else {
      setPage(pages_->currentIndex() - 1);
    }
  });
  connect(this, &ScreenFrame::primary, this, [this] {
    if (pages_->currentIndex() + 1 == pages()) {
      emit finished();
    } else {
      setPage(pages_->currentIndex() + 1);
    }
  });
}

void GlossaryScreen::setPage(int page) {
  pages_->setCurrentIndex(std::clamp(page, 0, pages() - 1));
  setMayGoBack(may_leave_);
}

void GlossaryScreen::setMayGoBack(bool may) {
  may_leave_ = may;
  ScreenFrame::setMayGoBack(may || pages_->currentIndex() > 0);
}

}  // namespace tactus::workbench::nurse
