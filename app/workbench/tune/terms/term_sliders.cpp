#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QStyle>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/editing/edit.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/tune/terms/membership_editor.h"
#include "app/workbench/tune/terms/term_controller.h"

namespace tactus::workbench {
namespace {

constexpr int kPositions = 10'000;  // finer than any screen

}  // namespace

VertexSlider::VertexSlider(QWidget* parent) : QSlider(Qt::Horizontal, parent) {
  setRange(0, kPositions);
  setFocusPolicy(Qt::StrongFocus);
}

void VertexSlider::setEnds(double from, double to) {
  from_ = from;
  to_ = to;
}

void VertexSlider::setPlace(double place) {
  const double share = std::clamp((place - from_) / (to_ - from_), 0.0, 1.0);
  setValue(static_cast<int>(std::lround(share * kPositions)));
}

double VertexSlider::perPixel() const {
  const int room = width() - style()->pixelMetric(QStyle::PM_SliderLength, nullptr, this);
  return (to_ - from_) / std::max(1, room);
}

bool VertexSlider::event(QEvent* event) {
  // A shortcut of the window must not take the key that cancels a drag.
  if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape &&
      (dragging_ || stepping_)) {
    event->accept();
    return true;
  }
  return QSlider::event(event);
}

// The vertex follows the hand from where it is: a click beside the handle moves nothing.
void VertexSlider::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  press_x_ = event->position().x();
  pressed_ = true;
  event->accept();
}

void VertexSlider::mouseMoveEvent(QMouseEvent* event) {
  if (!pressed_) return;
  if (!std::exchange(dragging_, true)) emit moveBegun();
  emit moved((event->position().x() - press_x_) * perPixel());
}

void VertexSlider::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  pressed_ = false;
  if (std::exchange(dragging_, false)) emit moveEnded();
}

// The wheel scrolls the panel; it must not change the model by accident.
void VertexSlider::wheelEvent(QWheelEvent* event) { event->ignore(); }

void VertexSlider::keyPressEvent(QKeyEvent* event) {
  const int key = event->key();
  if (key == Qt::Key_Escape && (dragging_ || stepping_)) {
    pressed_ = dragging_ = stepping_ = false;
    emit moveCancelled();
  } else if ((key == Qt::Key_Left || key == Qt::Key_Right) && !dragging_) {
    stepping_ = true;
    emit stepped(key == Qt::Key_Right ? 1 : -1, event->modifiers().testFlag(Qt::ShiftModifier));
  } else if ((key == Qt::Key_PageUp || key == Qt::Key_PageDown) && !dragging_) {
    stepping_ = true;
    emit stepped(key == Qt::Key_PageUp ? 1 : -1, true);
  } else {
    QWidget::keyPressEvent(event);
  }
}

void VertexSlider::keyReleaseEvent(QKeyEvent* event) {
  if (!event->isAutoRepeat() && std::exchange(stepping_, false)) emit stepsEnded();
}

void VertexSlider::focusOutEvent(QFocusEvent* event) {
  // Whatever takes the keyboard away ends what it was moving.
  if (std::exchange(stepping_, false)) emit stepsEnded();
  QSlider::focusOutEvent(event);
}

namespace {

constexpr int kWidestTitle = 14 * theme::kGrid;  // px
constexpr int kRoomyHeight = 480;                // px at 100 %, of the editor

}  // namespace

TermSliders::TermSliders(TermController& terms, QWidget* parent)
    : QWidget(parent), terms_(terms), layout_(new QHBoxLayout(this)), title_(new ElidedLabel(this)) {
  QFont font = theme::smallFont();
  font.setWeight(QFont::DemiBold);
  title_->setFont(font);
  keepFitted(*title_, [this] {
    const int whole = title_->fontMetrics().horizontalAdvance(QStringLiteral("Laryngopharynx")) + 4;
    title_->setFixedWidth(std::min(whole, kWidestTitle));
  });
  layout_->setContentsMargins(6, 0, 0, 0);
  layout_->setSpacing(theme::kGrid);
  layout_->addWidget(title_);
  connect(&terms_, &TermController::listChanged, this, &TermSliders::refreshState);
  connect(&terms_, &TermController::termsChanged, this, &TermSliders::refreshState);
  connect(&terms_, &TermController::selectionChanged, this, &TermSliders::refreshState);
  connect(&terms_, &TermController::locksChanged, this, &TermSliders::refreshState);
}

void TermSliders::showEvent(QShowEvent* event) {
  // Hidden, it followed nothing.
  refreshState();
  QWidget::showEvent(event);
}

void TermSliders::fitInto(int height) { setVisible(height >= appearance::scaled(kRoomyHeight)); }

void TermSliders::refreshState() {
  if (!isVisible() || !terms_.isOpen() || terms_.terms().empty()) return;
  if (const auto selected = terms_.selected()) term_ = selected->term;
  term_ = std::min(term_, terms_.terms().size() - 1);
  const fuzzy::Term& term = terms_.terms()[term_];
  if (parts_.size() != term.points.size() || shape_ != term.shape) build(term);
  show(term);
}

void TermSliders::build(const fuzzy::Term& term) {
  // One of them may be in the middle of a signal of its own.
  for (const Part& part : parts_) {
    part.cell->hide();
    part.cell->deleteLater();
  }
  parts_.clear();
  shape_ = term.shape;
  for (std::size_t p = 0; p < term.points.size(); ++p) {
    Part part{new QWidget(this), nullptr, nullptr};
    part.name = new ElidedLabel(part.cell);
    part.name->setFont(theme::smallFont());
    part.slider = new VertexSlider(part.cell);
    makeColumn(part.cell, {part.name, part.slider}, 0);
    layout_->addWidget(part.cell, 1);
    const auto grip = [this, p] { return Grip{term_, Grip::Part::kVertex, p, false}; };
    connect(part.slider, &VertexSlider::moveBegun, this, [this, grip] {
      terms_.select(grip());
      terms_.beginMove(grip());
    });
    connect(part.slider, &VertexSlider::moved, &terms_, &TermController::moveBy);
    connect(part.slider, &VertexSlider::moveEnded, &terms_, &TermController::endMove);
    connect(part.slider, &VertexSlider::moveCancelled, &terms_, &TermController::cancelMove);
    connect(part.slider, &VertexSlider::stepped, this, [this, grip](int count, bool coarse) {
      terms_.select(grip());
      terms_.step(count, coarse);
    });
    connect(part.slider, &VertexSlider::stepsEnded, &terms_, &TermController::endSteps);
    parts_.push_back(part);
  }
}

void TermSliders::show(const fuzzy::Term& term) {
  title_->setFullText(labelOf(term));
  const fuzzy::Variable& variable = terms_.variable();
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    const QString name = text(editing::pointName(term.shape, p));
    QString sentence = name;
    if (!sentence.isEmpty()) sentence[0] = sentence[0].toUpper();
    parts_[p].name->setFullText(sentence);
    parts_[p].slider->setAccessibleName(tr("%1 of %2").arg(sentence, labelOf(term)));
    parts_[p].slider->setToolTip(tr("Move the %1 from %2: drag, or use the arrow keys, with Shift farther")
                                     .arg(name, placeText(variable, term.points[p])));
    const bool width = term.shape == fuzzy::Shape::kGaussian && p == 1;
    parts_[p].slider->setEnds(width ? 0 : variable.min, width ? variable.max - variable.min : variable.max);
    parts_[p].slider->setEnabled(!terms_.isLocked(term.id, p));
    parts_[p].slider->setPlace(term.points[p]);
  }
}

}  // namespace tactus::workbench
