#include "app/workbench/shell/operating_strip.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QTimer>
#include <algorithm>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/kit/number_box.h"
#include "app/workbench/model/model_controller.h"
#include "app/workbench/model/scene_controller.h"

namespace tactus::workbench {
namespace {

constexpr int kMessageMs = 15'000;  // long enough to read two sentences
constexpr int kSavedShare = 6;      // at most this part of the strip for where edits are kept
constexpr int kLeastSaved = 160;    // px
constexpr int kAway = 1;            // px: of what gives way
constexpr int kRoomy = 1600;        // px: from this width on the labels of the model fit beside everything else

}  // namespace

OperatingStrip::OperatingStrip(const ModelController& models, SceneController& scene, QWidget* parent)
    : QWidget(parent),
      models_(models),
      scene_(scene),
      layout_(new QHBoxLayout(this)),
      point_(new QWidget(this)),
      said_(new ElidedLabel(this)),
      latency_(new QLabel(this)),
      saved_(new QLabel(this)),
      message_time_(new QTimer(this)) {
  for (QLabel* label : {latency_, saved_}) {
    label->setTextFormat(Qt::PlainText);
    label->setFont(theme::smallFont());
  }
  said_->setAccessibleName(tr("Message"));
  said_->keepEnd();  // newtons stand there
  said_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  message_time_->setSingleShot(true);
  message_time_->setInterval(kMessageMs);
  setInk(*latency_, theme::mutedInk());
  latency_->setToolTip(tr("From the last edit to the first force that uses it"));
  latency_->hide();
  layout_->setContentsMargins(4, 0, 4, 0);
  layout_->setSpacing(2 * theme::kGrid);
  layout_->addWidget(point_);
  layout_->addWidget(said_, 1);
  layout_->addWidget(latency_);
  layout_->addWidget(saved_);

  connect(message_time_, &QTimer::timeout, this, [this] { showMessage({}); });
  connect(&scene_, &SceneController::modelChanged, this, &OperatingStrip::build);
  connect(&scene_, &SceneController::valueChanged, this, &OperatingStrip::showValue);
  connect(&models_, &ModelController::modifiedChanged, this, &OperatingStrip::showSaved);
  connect(&models_, &ModelController::saved, this, &OperatingStrip::showSaved);
}

void OperatingStrip::addState(QWidget* state) { layout_->insertWidget(layout_->indexOf(latency_), state); }

void OperatingStrip::setFrameTime(QWidget* time) {
  frame_time_ = time;
  frame_time_->setMinimumWidth(kAway);
  layout_->insertWidget(layout_->indexOf(saved_), time);
}

void OperatingStrip::setCorner(QWidget* corner) { layout_->addWidget(corner); }

void OperatingStrip::showLatency(const QString& latency) {
  latency_->setText(latency);
  latency_->setVisible(!latency.isEmpty());
}

void OperatingStrip::showPoint(bool shown) {
  point_shown_ = shown;
  point_->setVisible(shown);
}

void OperatingStrip::showMessage(const QString& sentence) {
  message_ = sentence;
  said_->setFullText(sentence);
  if (sentence.isEmpty()) {
    message_time_->stop();
  } else {
    message_time_->start();
  }
}

bool OperatingStrip::event(QEvent* event) {
  const bool handled = QWidget::event(event);
  if (event->type() == QEvent::LayoutRequest || event->type() == QEvent::Resize) makeRoom();
  return handled;
}

/// The time of a picture gives way to the operating point, which would be squeezed.
void OperatingStrip::makeRoom() {
  if (frame_time_ == nullptr || frame_time_->isHidden()) return;
  const bool away = frame_time_->maximumWidth() == kAway;
  const int wanted = layout_->sizeHint().width() + (away ? frame_time_->sizeHint().width() : 0);
  frame_time_->setMaximumWidth(wanted <= width() ? QWIDGETSIZE_MAX : kAway);
}

void OperatingStrip::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  nameInputs();
  if (models_.current()) showSaved();
}

void OperatingStrip::build() {
  delete point_;
  point_ = new QWidget(this);
  if (!point_shown_) point_->hide();
  layout_->insertWidget(0, point_);
  names_.clear();
  numbers_.clear();
  auto* row = makeRow(point_, {});
  const std::vector<fuzzy::Variable>& inputs = scene_.model()->model.inputs;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    auto* label = new QLabel(point_);
    label->setTextFormat(Qt::PlainText);
    label->setFont(theme::smallFont());
    setInk(*label, theme::mutedInk());
    auto* number = new NumberBox(inputs[i], stepOf(inputs[i]), point_);
    // Findings lead to places with two decimals.
    number->setRoomFor(QLatin1Char('0') + number->roomFor());
    number->setAccessibleName(tr("%1 of the operating point").arg(labelOf(inputs[i])));
    number->setToolTip(tr("Type a value of %1, or change it with the arrow keys").arg(labelOf(inputs[i])));
    connect(number, &NumberBox::valueChanged, &scene_, [this, i](double value) { scene_.setValue(i, value); });
    label->setBuddy(number);
    row->addWidget(label);
    row->addWidget(number);
    if (i + 1 < inputs.size()) row->addSpacing(theme::kGrid);
    names_.push_back(label);
    numbers_.push_back(number);
    showValue(i);
  }
  nameInputs();
  showSaved();
}

void OperatingStrip::nameInputs() {
  for (std::size_t i = 0; i < names_.size(); ++i) {
    const fuzzy::Variable& input = scene_.model()->model.inputs[i];
    const QString name = width() < kRoomy ? shortLabelOf(input) : labelOf(input);
    if (name != names_[i]->text()) names_[i]->setText(name);
    names_[i]->setToolTip(axisText(input));
  }
}

void OperatingStrip::showValue(std::size_t input) {
  const QSignalBlocker no_signal(numbers_[input]);
  numbers_[input]->setValue(scene_.value(input));
}

void OperatingStrip::showStored(const QString& stored, bool bad) {
  stored_ = stored;
  stored_bad_ = bad;
  if (models_.current()) showSaved();
}

void OperatingStrip::showSaved() {
  const bool in_study = !stored_.isEmpty();
  const bool modified = models_.isModified();
  const QString state = in_study ? stored_ : modified ? tr("● Changes not saved") : tr("Saved");
  // A study may have a long name; its end and the tool tip tell it.
  const int room = std::max(width() / kSavedShare, kLeastSaved);
  const QString shown = saved_->fontMetrics().elidedText(state, Qt::ElideMiddle, room);
  saved_->setText(shown);
  const QString& path = models_.current()->path;
  saved_->setToolTip(shown == state ? path : state + QLatin1Char('\n') + path);
  setInk(*saved_, (in_study ? stored_bad_ : modified) ? theme::warningInk() : theme::mutedInk());
}

}  // namespace tactus::workbench
