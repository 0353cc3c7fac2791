#include "app/workbench/labs/frame/lab_screen.h"

#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QTabBar>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "app/workbench/base/theme.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/labs/data/lab_data.h"
#include "app/workbench/labs/data/settings_price.h"

namespace tactus::workbench {
namespace {

constexpr int kPatienceMs = 300;  // shorter work would only flicker

}  // namespace

LabScreen::LabScreen(LabData& lab_data, QWidget* parent)
    : QWidget(parent),
      data_(lab_data),
      tabs_(new QTabBar(this)),
      state_(new QLabel(this)),
      cancel_(new QPushButton(tr("Cancel"), this)),
      undo_(new QToolButton(this)),
      redo_(new QToolButton(this)),
      price_(new QLabel(this)),
      failure_(new QLabel(this)),
      read_again_(new QPushButton(tr("Read it again"), this)),
      pages_(new PageStack(this)) {
  setFocusPolicy(Qt::ClickFocus);
  new TabLook(*tabs_);
  tabs_->setExpanding(false);
  tabs_->setFont(theme::headingFont());
  tabs_->setAccessibleName(tr("Labs"));
  setMuted(*state_);
  state_->setTextFormat(Qt::PlainText);
  failure_->setTextFormat(Qt::PlainText);
  failure_->setWordWrap(true);
  setInk(*failure_, theme::errorInk());
  undo_->setText(tr("Undo"));
  redo_->setText(tr("Redo"));
  auto* head = makeRow({tabs_, spring(1), state_, cancel_});
  for (QToolButton* button : {undo_, redo_}) {
    button->setMinimumHeight(3 * theme::kGrid + 4);
    head->addWidget(button);
  }
  makeColumn(this, {head, price_, makeRow({{failure_, 1}, read_again_}), {pages_, 1}});
  price_->setTextFormat(Qt::PlainText);
  price_->setWordWrap(true);
  price_->hide();

  connect(tabs_, &QTabBar::currentChanged, this, [this](int index) {
    pages_->setCurrentIndex(index);
    followUndo();
    followWork();
  });
  connect(undo_, &QToolButton::clicked, this, [this] {
    if (UndoSource* const source = undo()) source->undo();
  });
  connect(redo_, &QToolButton::clicked, this, [this] {
    if (UndoSource* const source = undo()) source->redo();
  });
  connect(read_again_, &QPushButton::clicked, &data_, &LabData::refresh);
  connect(cancel_, &QPushButton::clicked, this, [this] {
    for (const Watched& one : watched_) one.work->cancel();
  });
  connect(&data_, &LabData::studyChanged, this, [this] {
    followStudy();
    followWork();
  });
  patience_.setSingleShot(true);
  patience_.setInterval(kPatienceMs);
  connect(&patience_, &QTimer::timeout, this, [this] {
    said_ = true;
    followWork();
  });
  followUndo();
  followStudy();
  followWork();
}

void LabScreen::addLab(const QString& title, QWidget* lab, UndoSource* undo) {
  pages_->addWidget(lab);
  if (undo != nullptr) {
    undo_of_.insert(lab, undo);
    connect(undo, &UndoSource::changed, this, &LabScreen::followUndo);
  }
  tabs_->addTab(title);
  followUndo();
}

void LabScreen::watch(Computation& work, const QString& doing) {
  watched_.push_back({&work, doing});
  connect(&work, &Computation::changed, this, &LabScreen::followWork);
}

void LabScreen::showPrice(SettingsPrice& price) {
  settings_price_ = &price;
  const auto show = [this] {
    const QString sentence = settings_price_->sentence();
    price_->setText(sentence);
    price_->setVisible(!sentence.isEmpty());
  };
  connect(&price, &SettingsPrice::changed, this, show);
  connect(&data_, &LabData::settingsChanged, this, show);
  price.setSeen(isVisible());
}

void LabScreen::reveal(QWidget* lab) { tabs_->setCurrentIndex(std::max(0, pages_->indexOf(lab))); }

QList<QWidget*> LabScreen::labs() const {
  QList<QWidget*> out;
  for (int i = 0; i < pages_->count(); ++i) out << pages_->widget(i);
  return out;
}

bool LabScreen::isBusy() const {
  const auto runs = [](const Watched& one) { return one.work->isBusy(); };
  return data_.isReading() || std::any_of(watched_.begin(), watched_.end(), runs) ||
         std::any_of(short_work_.begin(), short_work_.end(), [](const auto& busy) { return busy(); });
}

UndoSource* LabScreen::undo() const { return undo_of_.value(pages_->currentWidget(), nullptr); }

void LabScreen::followUndo() {
  const UndoSource* const source = undo();
  undo_->setVisible(source != nullptr);
  redo_->setVisible(source != nullptr);
  undo_->setEnabled(source != nullptr && source->canUndo());
  redo_->setEnabled(source != nullptr && source->canRedo());
  if (source == nullptr) return;
  const QString back = source->undoText();
  const QString again = source->redoText();
  undo_->setToolTip(back.isEmpty() ? tr("Undo: nothing was changed here") : tr("Undo: %1 (Ctrl+Z)").arg(back));
  redo_->setToolTip(again.isEmpty() ? tr("Redo: nothing was undone here") : tr("Redo: %1 (Ctrl+Shift+Z)").arg(again));
}

void LabScreen::followWork() {
  const auto busy =
      std::find_if(watched_.begin(), watched_.end(), [](const Watched& one) { return one.work->isBusy(); });
  const bool busy_now = busy != watched_.end() || data_.isReading();
  if (!busy_now) {
    patience_.stop();
  } else if (!patience_.isActive() && !said_) {
    patience_.start();
  }
  said_ = said_ && busy_now;
  const bool works = busy != watched_.end() && said_;
  // What the lab in front shows: the others say it when they are in front.
  const bool canceled = std::any_of(watched_.begin(), watched_.end(),
                                    [](const Watched& one) { return one.work->isHeld() && one.work->isCanceled(); });
  cancel_->setVisible(works);
  if (works) {
    const double share = busy->work->progress();
    const QString doing = busy->work->doing().isEmpty() ? busy->doing : busy->work->doing();
    state_->setText(share > 0 ? tr("%1… %2 %").arg(doing).arg(std::lround(100 * share)) : tr("%1…").arg(doing));
  } else if (data_.isReading() && said_) {
    state_->setText(tr("Reading the study…"));
  } else {
    state_->setText(canceled ? tr("Canceled: what you see is not complete. The next change computes again.")
                             : QString());
  }
}

void LabScreen::followStudy() {
  const bool failed = !data_.failure().isEmpty();
  failure_->setText(failed ? tr("The labs show nothing of this study. %1").arg(data_.failure()) : QString());
  failure_->setVisible(failed);
  read_again_->setVisible(failed);
}

// So that keys are for the lab, not for the model, from the beginning.
void LabScreen::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (settings_price_ != nullptr) settings_price_->setSeen(true);
  const QWidget* const focus = focusWidget();
  if (focus == nullptr || !focus->hasFocus()) setFocus(Qt::OtherFocusReason);
}

void LabScreen::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  if (settings_price_ != nullptr) settings_price_->setSeen(false);
}

// The window's own undo is of the model: inside a lab, the keys belong to the lab.
bool LabScreen::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && undo() != nullptr) {
    const auto* const key = static_cast<QKeyEvent*>(event);
    if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) event->accept();
  }
  return QWidget::event(event);
}

void LabScreen::keyPressEvent(QKeyEvent* event) {
  UndoSource* const source = undo();
  if (source != nullptr && event->matches(QKeySequence::Undo)) {
    source->undo();
  } else if (source != nullptr && event->matches(QKeySequence::Redo)) {
    source->redo();
  } else {
    QWidget::keyPressEvent(event);
  }
}

}  // namespace tactus::workbench
