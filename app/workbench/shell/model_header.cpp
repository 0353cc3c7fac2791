#include "app/workbench/shell/model_header.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <algorithm>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/buttons.h"
#include "app/workbench/kit/cards.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/kit/notes.h"
#include "app/workbench/model/scene_controller.h"

namespace tactus::workbench {
namespace {

constexpr int kLeastName = 200;  // px: with less for the model's name the numbers of experts and rules give way

}  // namespace

ModelHeader::ModelHeader(SceneController& scene, QWidget* parent)
    : QWidget(parent),
      scene_(scene),
      name_(new ElidedLabel(this)),
      summary_(new QLabel(this)),
      lock_(new QLabel(this)),
      study_(new ElidedLabel(this)),
      notices_(new NotesButton(this)),
      data_(new NotesButton(this)),
      notes_(new NotesButton(this)),
      all_(new NotesButton(this)),
      buttons_(new QHBoxLayout),
      simulated_(new Card(this)),
      terms_label_(new QLabel(tr("Te&rms:"), this)),
      terms_of_(new QComboBox(this)) {
  name_->setFont(theme::titleFont());
  summary_->setTextFormat(Qt::PlainText);
  setInk(*summary_, theme::mutedInk());
  lock_->hide();
  study_->hide();
  terms_label_->setBuddy(terms_of_);
  terms_of_->setAccessibleName(tr("Whose terms are shown"));
  terms_of_->setSizeAdjustPolicy(QComboBox::AdjustToContents);

  auto* badge_text = new QLabel(tr("Contains simulated data"), simulated_);
  QFont bold = theme::smallFont();
  bold.setWeight(QFont::DemiBold);
  badge_text->setFont(bold);
  setInk(*badge_text, theme::warningInk());
  simulated_->setColors(theme::warningFill(), theme::warningFill());
  makeRow(simulated_, {badge_text}, theme::kGrid, inset(theme::kGrid, 4));

  // What a number is trusted for stands together, closer than the rest.
  buttons_->setSpacing(theme::kGrid / 2);
  for (NotesButton* button : {notices_, data_, notes_, all_}) buttons_->addWidget(button);
  makeRow(
      this,
      {name_, {simulated_, 0, Qt::AlignVCenter}, summary_, lock_, study_, buttons_, spring(1), terms_label_, terms_of_},
      theme::kGrid + 4, {4, 0, 0, 0});

  connect(&scene_, &SceneController::modelChanged, this, &ModelHeader::adoptModel);
  connect(&scene_, &SceneController::modelEdited, this, &ModelHeader::countRules);
  connect(terms_of_, &QComboBox::activated, this, &ModelHeader::onTermsChosen);
}

void ModelHeader::showNotes(const BuildNotes& notes) {
  data_->setNotes(tr("Look at the data first: %1").arg(notes.data.size()), {dataGroup(notes)}, true);
  notes_->setNotes(NotesButton::counted(static_cast<qsizetype>(notes.build.size())), {buildGroup(notes)});
  fitButtons();
}

void ModelHeader::showNotices(const StudyNotices& notices) {
  const QVector<NoteGroup> groups = noticeGroups(notices);
  const qsizetype count = countOf(groups);
  notices_->setNotes(tr("%n notice(s)", nullptr, static_cast<int>(count)), groups, true);
  fitButtons();
}

void ModelHeader::showStudy(const QString& name, const QString& read_only) {
  const bool locked = !name.isEmpty() && !read_only.isEmpty();
  lock_->setVisible(locked);
  if (locked) lock_->setPixmap(lockPicture(theme::ink(), devicePixelRatioF()));
  lock_->setAccessibleName(locked ? tr("Read-only") : QString());
  lock_->setToolTip(locked ? tr("Open for reading only, because %1. Study, Save a copy of the study").arg(read_only)
                           : QString());
  study_->setVisible(!name.isEmpty());
  study_->setFullText(locked ? tr("Study %1, read-only").arg(name) : tr("Study %1").arg(name));
  // The model's name gives way first.
  study_->setMinimumWidth(std::min(study_->sizeHint().width(), 24 * theme::kGrid));
  study_->setToolTip(locked ? lock_->toolTip()
                            : tr("The study that is open: placements, recordings and versions of its model go there"));
  fitButtons();
}

QSize ModelHeader::minimumSizeHint() const {
  const QSize minimum = QWidget::minimumSizeHint();
  if (!hasSeveralKinds() || !all_->isHidden()) return minimum;
  return minimum - QSize(std::max(0, buttonsWidth() - all_->sizeHint().width()), 0);
}

void ModelHeader::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fitButtons();
}

int ModelHeader::buttonsWidth() const {
  int width = 0;
  for (const NotesButton* button : {notices_, data_, notes_}) {
    if (button->hasNotes()) width += button->sizeHint().width() + (width > 0 ? buttons_->spacing() : 0);
  }
  return width;
}

int ModelHeader::widthOfOthers() const {
  buttons_->invalidate();  // what is shown of them changed
  layout()->invalidate();
  return layout()->sizeHint().width() - buttons_->sizeHint().width();
}

bool ModelHeader::hasSeveralKinds() const {
  return int{notices_->hasNotes()} + int{data_->hasNotes()} + int{notes_->hasNotes()} > 1;
}

void ModelHeader::fitButtons() {
  // The name is needed more than the numbers.
  summary_->setVisible(true);
  const int others = widthOfOthers() + buttonsWidth() - name_->sizeHint().width();
  summary_->setVisible(width() - others >= std::min(name_->sizeHint().width(), kLeastName));
  const QVector<NoteGroup> groups = notices_->notes() + data_->notes() + notes_->notes();
  all_->setNotes(NotesButton::counted(countOf(groups)), groups, notices_->hasNotes() || data_->hasNotes());
  const bool merged = hasSeveralKinds() && widthOfOthers() + buttonsWidth() > width();
  for (NotesButton* button : {notices_, data_, notes_}) button->setVisible(button->hasNotes() && !merged);
  all_->setVisible(merged);
}

void ModelHeader::adoptModel() {
  const OpenModel& open = *scene_.model();
  name_->setFullText(text(open.model.name));
  countRules();
  simulated_->setVisible(open.simulated);
  simulated_->setToolTip(open.model.provenance ? text(open.model.provenance->notes) : QString());

  terms_of_->clear();
  choices_ = {std::nullopt};
  terms_of_->addItem(tr("Shared"));
  for (std::size_t i = 0; i < open.model.experts.size(); ++i) {
    if (open.model.experts[i].overrides.empty()) continue;
    choices_.emplace_back(i);
    terms_of_->addItem(labelOf(open.model.experts[i]));
    if (scene_.termsOf() == i) terms_of_->setCurrentIndex(terms_of_->count() - 1);
  }
  terms_label_->setVisible(choices_.size() > 1);
  terms_of_->setVisible(choices_.size() > 1);
  fitButtons();
}

void ModelHeader::countRules() {
  const fuzzy::ForceModel& model = scene_.model()->model;
  const std::size_t experts = model.experts.size();
  std::size_t rules = 0;
  for (const fuzzy::Expert& expert : model.experts) rules += expert.rules.size();
  summary_->setText(tr("%n expert(s)", nullptr, static_cast<int>(experts)) + QStringLiteral(" · ") +
                    tr("%n rule(s)", nullptr, static_cast<int>(rules)));
}

void ModelHeader::onTermsChosen(int index) { scene_.setTermsOf(choices_[static_cast<std::size_t>(index)]); }

}  // namespace tactus::workbench
