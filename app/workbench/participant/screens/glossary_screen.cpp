#include "app/workbench/participant/screens/glossary_screen.h"

#include <QVBoxLayout>
#include <algorithm>

#include "app/workbench/participant/kit/choices.h"
#include "app/workbench/participant/kit/look.h"
#include "app/workbench/participant/kit/pictures.h"

namespace tactus::workbench::nurse {
namespace {

constexpr double kPosePictureMm = 20;
constexpr int kRegionsShare = 3;  // of the width; an inset has 1

}  // namespace

GlossaryPage::GlossaryPage(const Look& look, TextRole role, const Phrase& sentence, QWidget* parent)
    : QWidget(parent), look_(look), row_(new QHBoxLayout) {
  auto* column = new QVBoxLayout(this);
  keepSpacing(look, *column, 3);
  column->addWidget(new Label(look, role, sentence, this));
  keepSpacing(look, *row_, 3);
  column->addLayout(row_, 1);
  connect(&look, &Look::changed, this, &GlossaryPage::alignCaptions);
}

void GlossaryPage::addColumn(const Phrase& word, QWidget* picture, bool grows) {
  auto* column = new QVBoxLayout;
  keepSpacing(look_, *column, 1.5);
  if (!grows) column->addStretch(1);
  column->addWidget(picture, grows ? 1 : 0, grows ? Qt::Alignment() : Qt::AlignHCenter);
  if (!word.isEmpty()) {
    auto* label = new Label(look_, TextRole::kBody, word, this);
    label->setAlignment(Qt::AlignHCenter | Qt::AlignTop);
    column->addWidget(label);
    if (grows) captions_.push_back(label);
  }
  if (!grows) column->addStretch(2);
  row_->addLayout(column, 1);
}

void GlossaryPage::alignCaptions() {
  const int count = static_cast<int>(captions_.size());
  if (count < 2) return;
  const int wide = (width() - (count - 1) * row_->spacing()) / count;
  int high = 0;
  for (const Label* caption : captions_) high = std::max(high, caption->heightForWidth(wide));
  for (Label* caption : captions_) caption->setMinimumHeight(high);
}

void GlossaryPage::resizeEvent(QResizeEvent* /*event*/) { alignCaptions(); }

void GlossaryPage::addPicture(const Phrase& word, Picture picture) {
  auto* box = new PictureBox(look_, 1.5 * kPosePictureMm, kPosePictureMm, this);
  box->setPicture(std::move(picture));
  addColumn(word, box, false);
}

anatomy::BodyView* GlossaryPage::newBody() { return anatomy::makeBodyView(look_.about(), this); }

void GlossaryPage::addPose(const Phrase& word, const study::ItemCondition& condition) {
  anatomy::BodyView* const view = newBody();
  view->showWhole();
  view->setDepth(std::nullopt);
  view->setPose(condition);
  addColumn(word, view, true);
}

void GlossaryPage::addRegions() {
  anatomy::BodyView* const view = newBody();
  const auto name = [this, view] {
    view->setFont(look_.font());
    view->setRegionNames(regionNames(look_));
    view->showNames();
    view->setAccessibleName(look_.say(phrase(QStringLiteral("acc.way"))));
  };
  connect(&look_, &Look::changed, view, name);
  name();
  row_->addWidget(view, kRegionsShare);
}

void GlossaryPage::addWay(const Phrase& word) {
  anatomy::BodyView* const view = newBody();
  view->showWhole();
  addColumn(word, view, true);
}

void GlossaryPage::addOtherViews(bool of_regions) {
  const procedure::Procedure& about = *look_.about();
  for (const procedure::OtherView& view : about.other_views) {
    if (view.of_regions != of_regions) continue;
    addColumn(phrase(QString::fromStdString(view.word)),
              new anatomy::InsetView(QByteArray::fromStdString(about.files.at(view.file)), this), true);
  }
}

GlossaryScreen::GlossaryScreen(const Look& look, QWidget* parent)
    : ScreenFrame(look, parent), pages_(new QStackedWidget(this)) {
  const procedure::Procedure& about = *look.about();
  // The picture says from where it is, where others stand beside it.
  const bool has_others = std::any_of(about.other_views.begin(), about.other_views.end(),
                                      [](const procedure::OtherView& view) { return !view.of_regions; });
  GlossaryPage* start = addPage(phrase(QStringLiteral("q.instructions")), TextRole::kBody);
  start->addWay(has_others ? phrase(QStringLiteral("glo.from_side")) : Phrase{});
  start->addOtherViews(false);
  GlossaryPage* force = addPage(phrase(QStringLiteral("glo.force")));
  for (const Answer& word : questionWords(look)) {
    if (!word.apart) force->addPicture(word.word, word.picture);
  }
  GlossaryPage* way = addPage(phrase(QStringLiteral("glo.way")));
  way->addRegions();
  way->addOtherViews(true);
  for (std::size_t i = 0; i < about.inputs.size(); ++i) {
    if (i != about.way()) addWords(about.inputs[i]);
  }
  setTitle(phrase(QStringLiteral("glo.title")));
  setMain(pages_);
}

GlossaryPage* GlossaryScreen::addPage(const Phrase& sentence, TextRole role) {
  auto* page = new GlossaryPage(look(), role, sentence, pages_);
  pages_->addWidget(page);
  return page;
}

void GlossaryScreen::addWords(const fuzzy::Variable& input) {
  const procedure::Procedure& about = *look().about();
  const QString id = QString::fromStdString(input.id);
  GlossaryPage* const page = addPage(phrase(QStringLiteral("glo.") + id));
  for (const fuzzy::Term& term : input.terms) {
    const QString word = QStringLiteral("%1.%2").arg(id, QString::fromStdString(term.id));
    const study::ItemCondition condition{input.id, term.id};
    if (anatomy::showsPose(about, input.id)) {
      const QString pose = QStringLiteral("glo.") + word;
      page->addPose(phrase(look().knows(pose) ? pose : QStringLiteral("s.") + word), condition);
    } else {
      page->addPicture(phrase(QStringLiteral("s.") + word), conditionPicture(about, condition));
    }
  }
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
