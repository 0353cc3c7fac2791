#include "app/workbench/participant/screens/glossary_screen.h"

#include <QVBoxLayout>
#include <algorithm>

#include "app/workbench/anatomy/anatomy_view.h"
#include "app/workbench/participant/kit/choices.h"
#include "app/workbench/participant/kit/look.h"
#include "app/workbench/participant/kit/pictures.h"

namespace tactus::workbench::nurse {
namespace {

constexpr double kPictureMm = 20;
constexpr int kRegionsShare = 3;      // of the width; an inset has 1
constexpr double kInStomachMm = 490;  // depth of the tip

}  // namespace

GlossaryPage::GlossaryPage(const Look& look, TextRole role, const Phrase& sentence, QWidget* parent)
    : QWidget(parent), look_(look), row_(new QHBoxLayout) {
  auto* column = new QVBoxLayout(this);
  keepSpacing(look, *column, 3);
  column->addWidget(new Label(look, role, sentence, this));
  keepSpacing(look, *row_, 3);
  column->addLayout(row_, 1);
}

void GlossaryPage::addColumn(const Phrase& word, QWidget* picture, bool grows) {
  auto* column = new QVBoxLayout;
  keepSpacing(look_, *column, 1.5);
  if (!grows) column->addStretch(1);
  column->addWidget(picture, grows ? 1 : 0, grows ? Qt::Alignment() : Qt::AlignHCenter);
  auto* label = new Label(look_, TextRole::kBody, word, this);
  label->setAlignment(Qt::AlignHCenter | Qt::AlignTop);
  column->addWidget(label);
  if (!grows) column->addStretch(2);
  row_->addLayout(column, 1);
}

void GlossaryPage::addPicture(const Phrase& word, Picture picture) {
  auto* box = new PictureBox(look_, 1.5 * kPictureMm, kPictureMm, this);
  box->setPicture(std::move(picture));
  addColumn(word, box, false);
}

void GlossaryPage::addPosture(const Phrase& word, anatomy::Posture posture) {
  auto* view = new anatomy::AnatomyView(this);
  view->setFraming(anatomy::Framing::kWhole);
  view->setPosture(posture);
  addColumn(word, view, true);
}

void GlossaryPage::addRegions() {
  auto* view = new anatomy::AnatomyView(this);
  const auto name = [this, view] {
    std::vector<anatomy::NamedStructure> names;
    for (const anatomy::Region region : anatomy::kRegions) {
      if (region == anatomy::Region::kStomach) continue;
      const auto id = QString::fromLatin1(anatomy::idOf(region).data());
      names.push_back({anatomy::structureOf(region), look_.say(phrase(QStringLiteral("a.") + id))});
    }
    view->setNames(std::move(names));
    view->setFont(look_.font());
    view->setAccessibleName(look_.say(phrase(QStringLiteral("acc.way"))));
  };
  connect(&look_, &Look::changed, view, name);
  name();
  row_->addWidget(view, kRegionsShare);
}

void GlossaryPage::addWay(const Phrase& word) {
  auto* view = new anatomy::AnatomyView(this);
  view->setFraming(anatomy::Framing::kWhole);
  view->setDepth(kInStomachMm);
  addColumn(word, view, true);
}

void GlossaryPage::addInset(const Phrase& word, anatomy::Inset inset) {
  addColumn(word, new anatomy::InsetView(inset, this), true);
}

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
}

void GlossaryScreen::setPage(int page) {
  pages_->setCurrentIndex(std::clamp(page, 0, pages() - 1));
  showBack();
}

bool GlossaryScreen::turnPage(int by) {
  const int page = pages_->currentIndex() + by;
  if (page < 0 || page >= pages()) return false;
  setPage(page);
  return true;
}

}  // namespace tactus::workbench::nurse
