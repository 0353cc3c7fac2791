#include "app/workbench/participant/kit/answer_card.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "app/workbench/participant/kit/button.h"
#include "app/workbench/participant/kit/colors.h"
#include "app/workbench/participant/kit/ring.h"

namespace tactus::workbench::nurse {
namespace {

constexpr double kWidthMm = 30;
constexpr double kHeightMm = 25;
constexpr double kApartHeightMm = 20;
constexpr double kCardPaddingMm = 2.5;
constexpr double kPictureMm = 9;
constexpr double kCornerMm = 2;
constexpr double kTickMm = 6;
constexpr int kTextFlags = Qt::AlignCenter | Qt::TextWordWrap;

}  // namespace

AnswerCard::AnswerCard(const Look& look, Answer answer, int place, int count, QWidget* parent)
    : QAbstractButton(parent), look_(look), answer_(std::move(answer)), place_(place), count_(count) {
  setCheckable(true);
  // Reads as one of several, none of them chosen at the start; arrow keys move the focus without choosing.
  setAutoExclusive(true);
  setFocusPolicy(Qt::StrongFocus);
  connect(&look, &Look::changed, this, &AnswerCard::follow);
  connect(this, &QAbstractButton::toggled, this, &AnswerCard::follow);
  follow();
}

void AnswerCard::follow() {
  const QString word = look_.say(answer_.word, answer_.language.value_or(look_.language()));
  setText(word);
  QString name = word;
  if (count_ > 0)
    name = look_.say(phrase(QStringLiteral("acc.of"), {word, QString::number(place_), QString::number(count_)}));
  if (isChecked()) name = look_.say(phrase(QStringLiteral("acc.chosen"), {name}));
  setAccessibleName(name);
  updateGeometry();
  update();
}

QFont AnswerCard::font(bool bold) const { return look_.font(answer_.language.value_or(look_.language()), 1, bold); }

void AnswerCard::setLit(bool lit) {
  if (lit == lit_) return;
  lit_ = lit;
  update();
}

QSize AnswerCard::sizeHint() const {
  const double text_width = QFontMetricsF(font(true)).horizontalAdvance(text());
  const int padding = look_.mm(kCardPaddingMm) + (answer_.apart ? look_.mm(kTickMm) : 0);
  const int wide = std::max(look_.mm(kWidthMm), static_cast<int>(std::ceil(text_width)) + 2 * padding) + 2 * kRingRoom;
  return {wide, heightForWidth(wide)};
}

int AnswerCard::heightForWidth(int width) const {
  const int padding = look_.mm(kCardPaddingMm);
  const QRectF room(0, 0, std::max(1, width - 2 * kRingRoom - 2 * padding), 1e6);
  const double text_height = QFontMetricsF(font(true)).boundingRect(room, kTextFlags, text()).height();
  const int picture = answer_.picture ? look_.mm(kPictureMm) + padding / 2 : 0;
  const int least = look_.mm(answer_.apart ? kApartHeightMm : kHeightMm);
  return std::max(least, static_cast<int>(std::ceil(text_height)) + picture + 2 * padding) + 2 * kRingRoom;
}

bool AnswerCard::hitButton(const QPoint& at) const {
  return isDown() ? endsNear(look_, *this, at) : rect().contains(at);
}

void AnswerCard::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF face = faceOf(size());
  const double corner = look_.mm(kCornerMm);
  const double padding = look_.mm(kCardPaddingMm);
  const bool marked = isChecked() || isDown();
  const double edge = isChecked() ? 4 : 1.5;
  painter.setPen(QPen(isChecked() ? colors::kInk : colors::kEdge, edge,
                      answer_.apart && !isChecked() ? Qt::DashLine : Qt::SolidLine));
  painter.setBrush(marked ? colors::kChosen : colors::kCard);
  painter.drawRoundedRect(face.adjusted(edge / 2, edge / 2, -edge / 2, -edge / 2), corner, corner);

  QRectF text_area = face.adjusted(padding, padding, -padding, -padding);
  if (answer_.picture) {
    const double high = look_.mm(kPictureMm);
    // What the text does not need is shared above and below.
    const double used =
        high + padding / 2 +
        QFontMetricsF(font(true)).boundingRect(QRectF(0, 0, text_area.width(), 1e6), kTextFlags, text()).height();
    const double above = std::max(0.0, (text_area.height() - used) / 2);
    painter.save();
    answer_.picture(painter, QRectF(text_area.left(), text_area.top() + above, text_area.width(), high));
    painter.restore();
    text_area.setTop(text_area.top() + above + high + padding / 2);
    text_area.setBottom(text_area.bottom() - above);
  }
  painter.setFont(font(isChecked()));
  painter.setPen(colors::kInk);
  painter.drawText(text_area, kTextFlags, text());

  if (isChecked()) {
    const double tick = look_.mm(kTickMm);
    const QRectF badge(face.right() - tick - padding / 2, face.top() + padding / 2, tick, tick);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colors::kInk);
    painter.drawEllipse(badge);
    painter.setPen(Qt::white);
    drawTick(painter, badge, tick / 8);
  }
  if (isRinged(*this) || lit_) drawRing(painter, face, corner);
}

}  // namespace tactus::workbench::nurse
