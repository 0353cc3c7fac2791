#include "app/workbench/participant/kit/screen_frame.h"

#include <QKeyEvent>
#include <QPainter>
#include <algorithm>

#include "app/workbench/participant/kit/button.h"
#include "app/workbench/participant/kit/choices.h"
#include "app/workbench/participant/kit/look.h"
#include "app/workbench/participant/kit/participant_state.h"
#include "core/procedure/procedure.h"

namespace tactus::workbench::nurse {
namespace {

constexpr double kMarginSteps = 2.5;
constexpr double kSideSteps = 4;
constexpr double kGapSteps = 1.5;
// A line is read easily up to this length; wider windows keep the rest free.
constexpr double kWidestMm = 330;
constexpr int kWidestTexts = 32;  // heights of text

void place(QWidget* widget, const QRect& area) {
  if (widget != nullptr) widget->setGeometry(area);
}

}  // namespace

QSize forceOffCorner(const Look& look) {
  const Button button(look, ButtonKind::kForceOff, phrase(QStringLiteral("off.button")));
  return button.sizeHint();
}

int frameMargin(const Look& look) { return look.gap(kMarginSteps); }

ScreenFrame::ScreenFrame(const Look& look, QWidget* parent)
    : QWidget(parent),
      look_(look),
      title_(new Label(look, TextRole::kTitle, this)),
      hint_(new Label(look, TextRole::kMuted, this)),
      simulated_(new Label(look, TextRole::kTitle, phrase(QStringLiteral("sim.mark")), this)),
      scale_(new Label(look, TextRole::kMuted, this)),
      back_(new Button(look, ButtonKind::kPlain, phrase(QStringLiteral("nav.back")), this)),
      primary_(new Button(look, ButtonKind::kPrimary, phrase(QStringLiteral("nav.next")), this)) {
  setFocusPolicy(Qt::StrongFocus);
  title_->setWordWrap(false);
  hint_->setWordWrap(false);
  hint_->hide();
  for (Label* const mark : {simulated_, scale_}) {
    mark->setWordWrap(false);
    mark->hide();
  }
  connect(back_, &QAbstractButton::clicked, this, [this] {
    if (!turnPage(-1)) emit back();
  });
  connect(primary_, &QAbstractButton::clicked, this, [this] {
    if (!turnPage(1)) emit primary();
  });
  connect(&look, &Look::changed, this, &ScreenFrame::arrange);
}

void ScreenFrame::setFreeHandLeft(bool left) {
  free_hand_left_ = left;
  arrange();
}

void ScreenFrame::setState(const ParticipantState& state) {
  simulated_->setVisible(state.simulated);
  const double scale = procedure::orDefault(state.procedure).device_scale;
  if (scale != 1) scale_->setPhrase(phrase(QStringLiteral("sim.scale"), {QString::number(scale)}));
  scale_->setVisible(scale != 1);
  arrange();
  may_go_back_ = state.can_go_back;
  showBack();
}

void ScreenFrame::showBack() {
  back_->setVisible(may_go_back_ || hasPageBefore());
  arrange();
}

bool ScreenFrame::turnPage(int /*by*/) { return false; }

QString ScreenFrame::idOfKey(int /*key*/) const { return {}; }

void ScreenFrame::setTitle(const Phrase& title) {
  title_->setPhrase(title);
  setAccessibleName(title_->text());
  arrange();
}

void ScreenFrame::setHint(const Phrase& hint) {
  hint_->setPhrase(hint);
  hint_->setVisible(!hint.isEmpty());
  arrange();
}

void ScreenFrame::setMain(QWidget* main, QWidget* side, double share) {
  main_ = main;
  side_ = side;
  share_ = share;
  for (QWidget* each : {main, side}) {
    if (each != nullptr) each->setParent(this);
  }
  arrange();
}

void ScreenFrame::setAnswers(Choices* cards, QWidget* around) {
  answers_ = around != nullptr ? around : cards;
  answers_->setParent(this);
  connect(cards, &Choices::picked, this, &ScreenFrame::picked);
  arrange();
}

void ScreenFrame::addExtra(Button* button) {
  button->setParent(this);
  extras_.push_back(button);
  arrange();
}

void ScreenFrame::resizeEvent(QResizeEvent* /*event*/) { arrange(); }

bool ScreenFrame::event(QEvent* event) {
  // A part needs another size.
  if (event->type() == QEvent::LayoutRequest) arrange();
  return QWidget::event(event);
}

void ScreenFrame::arrange() {
  const int margin = frameMargin(look_);
  const int gap = look_.gap(kGapSteps);
  const int widest = std::max(look_.mm(kWidestMm), kWidestTexts * look_.textPx());
  const int wide = std::min(width() - 2 * look_.gap(kSideSteps), widest);
  const QRect all((width() - wide) / 2, margin, wide, height() - 2 * margin);
  const QSize corner = forceOffCorner(look_);

  const int title_height = title_->sizeHint().height();
  title_->setGeometry(all.left(), all.top(), std::min(title_->sizeHint().width(), all.width()), title_height);
  int mark_left = title_->geometry().right() + 3 * gap;
  for (Label* const mark : {simulated_, scale_}) {
    if (mark->isHidden()) continue;
    mark->setGeometry(mark_left, all.top(), mark->sizeHint().width(), title_height);
    mark_left = mark->geometry().right() + 2 * gap;
  }

  // The row of buttons; Back stands at the other side of the primary button.
  int buttons_height = 0;
  for (const Button* button : findChildren<Button*>(QString(), Qt::FindDirectChildrenOnly)) {
    if (!button->isHidden()) buttons_height = std::max(buttons_height, button->sizeHint().height());
  }
  const int buttons_top = all.bottom() + 1 - buttons_height + kRingRoom;
  std::vector<QWidget*> row;
  if (!back_->isHidden()) row.push_back(back_);
  for (Button* extra : extras_) {
    if (!extra->isHidden()) row.push_back(extra);
  }
  int row_width = primary_->isHidden() ? 0 : primary_->sizeHint().width();
  for (const QWidget* widget : row) row_width += widget->sizeHint().width() + gap;
  // In a narrow window the others stand above the primary button.
  const bool two_rows = row_width > all.width() + 2 * kRingRoom && !row.empty();
  const int row_top = two_rows ? buttons_top - buttons_height : buttons_top;
  int x = -kRingRoom;
  const auto put = [&](QWidget* widget, int at) {
    const int width = widget->sizeHint().width();
    const int left = free_hand_left_ ? all.right() + 1 - at - width : all.left() + at;
    widget->setGeometry(left, widget == primary_ ? buttons_top : row_top, width, buttons_height);
  };
  for (QWidget* widget : row) {
    put(widget, x);
    x += widget->sizeHint().width() + gap;
  }
  if (!primary_->isHidden()) put(primary_, all.width() - primary_->sizeHint().width() + kRingRoom);

  const bool has_side = side_ != nullptr && !side_->isHidden();
  const int below_title = all.top() + title_height + gap;
  int header = corner.height() - kRingRoom;
  if (!hint_->isHidden()) {
    const QSize hint = hint_->sizeHint();
    hint_->setGeometry(all.left(), all.top() + title_height, std::min(hint.width(), all.width() - corner.width()),
                       hint.height());
    header = std::max(header, title_height + hint.height());
  }
  const int below_corner = all.top() + header + gap;
  const int bottom = row_top + kRingRoom - gap;
  const int answers_width = wide + 2 * kRingRoom;
  int answers_height = 0;
  if (answers_ != nullptr && !answers_->isHidden()) {
    answers_height =
        answers_->hasHeightForWidth() ? answers_->heightForWidth(answers_width) : answers_->sizeHint().height();
  }
  const int above_answers = bottom - (answers_height > 0 ? answers_height - 2 * kRingRoom + gap : 0);
  if (has_side) {
    // Beside a picture the text begins right under the title, and the picture under the corner.
    const int side_width = std::max(static_cast<int>(wide * share_), corner.width() - kRingRoom);
    place(main_, QRect(all.left(), below_title, wide - side_width - 2 * gap, above_answers - below_title));
    place(side_, QRect(all.right() + 1 - side_width, below_corner, side_width, above_answers - below_corner));
    place(answers_, QRect(all.left() - kRingRoom, above_answers + gap - kRingRoom, answers_width, answers_height));
    return;
  }
  if (answers_height == 0 || main_ == nullptr) {
    place(main_, QRect(all.left(), below_corner, wide, bottom - below_corner));
    place(answers_, QRect(all.left() - kRingRoom, below_corner, answers_width, bottom - below_corner));
    return;
  }
  // Question and answers stand together in the middle.
  const int wanted = main_->hasHeightForWidth() ? main_->heightForWidth(wide) : main_->sizeHint().height();
  const int main_height = std::min(wanted, above_answers - below_corner);
  const int free = above_answers - below_corner - main_height;
  const int between = std::min(free / 3, 3 * gap);
  const int top = below_corner + (free - between) / 3;
  place(main_, QRect(all.left(), top, wide, main_height));
  place(answers_,
        QRect(all.left() - kRingRoom, top + main_height + gap + between - kRingRoom, answers_width, answers_height));
}

void ScreenFrame::showEvent(QShowEvent* /*event*/) {
  // Keys reach the screen; no control has the ring before she asks for it.
  if (focusWidget() == nullptr || !focusWidget()->inherits("QLineEdit")) setFocus();
}

void ScreenFrame::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.fillRect(rect(), colors::kGround);
}

void ScreenFrame::keyPressEvent(QKeyEvent* event) {
  if (event->isAutoRepeat()) return;
  if (const QString id = idOfKey(event->key()); !id.isEmpty()) return emit picked(id);
  switch (event->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Space:
      if (primary_->isVisible() && primary_->isEnabled()) primary_->click();
      return;
    case Qt::Key_Backspace:
      if (back_->isVisible() && back_->isEnabled()) back_->click();
      return;
    default: QWidget::keyPressEvent(event);
  }
}

}  // namespace tactus::workbench::nurse
