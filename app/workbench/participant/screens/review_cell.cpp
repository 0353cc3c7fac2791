#include "app/workbench/participant/screens/review_cell.h"

#include <QPainter>

#include "app/workbench/participant/kit/button.h"
#include "app/workbench/participant/kit/colors.h"
#include "app/workbench/participant/kit/pictures.h"
#include "app/workbench/participant/kit/ring.h"

namespace tactus::workbench::nurse {
namespace {

constexpr int kPulseMs = 1600;
constexpr double kCellPictureMm = 10;
constexpr double kCellPaddingMm = 2.5;
constexpr double kCellCornerMm = 1.5;

int strengthOf(const QString& word) {
  int level = 0;
  for (const char* id : {"very_small", "small", "medium", "large", "very_large"}) {
    ++level;
    if (word == QLatin1String(id)) return level;
  }
  return 0;
}

}  // namespace

ReviewCell::ReviewCell(const Look& look, int item, QWidget* parent)
    : QAbstractButton(parent), look_(look), item_(item) {
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  pulse_.setDuration(kPulseMs);
  pulse_.setKeyValueAt(0, 0.0);
  pulse_.setKeyValueAt(0.5, 1.0);
  pulse_.setKeyValueAt(1, 0.0);
  pulse_.setLoopCount(-1);
  connect(&pulse_, &QVariantAnimation::valueChanged, this, [this](const QVariant& value) {
    glow_ = value.toDouble();
    update();
  });
  connect(&look, &Look::changed, this, &ReviewCell::follow);
}

void ReviewCell::setAnswer(const QString& word, const QString& situation) {
  word_ = word;
  situation_ = situation;
  follow();
}

void ReviewCell::follow() {
  setText(word_.isEmpty() ? QString() : look_.say(phrase(QStringLiteral("w.") + word_)));
  setAccessibleName(word_.isEmpty() ? look_.say(phrase(QStringLiteral("acc.open"), {situation_}))
                                    : situation_ + QStringLiteral(": ") + text());
  const bool pulses = word_.isEmpty() && isVisible();
  if (pulses && pulse_.state() != QAbstractAnimation::Running) pulse_.start();
  if (!pulses) pulse_.stop();
  updateGeometry();
  update();
}

void ReviewCell::showEvent(QShowEvent* /*event*/) { follow(); }
void ReviewCell::hideEvent(QHideEvent* /*event*/) { pulse_.stop(); }

QSize ReviewCell::sizeHint() const {
  const QFontMetrics metrics(look_.font());
  return {look_.mm(30), metrics.height() + 2 * kRingRoom + look_.mm(1)};
}

bool ReviewCell::hitButton(const QPoint& at) const {
  return isDown() ? endsNear(look_, *this, at) : rect().contains(at);
}

void ReviewCell::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF face = faceOf(size());
  const double corner = look_.mm(kCellCornerMm);
  const double padding = look_.mm(kCellPaddingMm);
  const bool open = word_.isEmpty();
  painter.setPen(open ? QPen(colors::kInk, 2 + 2 * glow_, Qt::DashLine) : QPen(colors::kEdge, 1.5));
  painter.setBrush(isDown() ? colors::kChosen : colors::kCard);
  painter.drawRoundedRect(face.adjusted(1, 1, -1, -1), corner, corner);
  const int level = strengthOf(word_);
  QRectF text_area = face.adjusted(padding, 0, -padding, 0);
  if (level > 0) {
    const double wide = look_.mm(kCellPictureMm);
    strengthPicture(level)(painter, QRectF(text_area.left(), face.center().y() - wide / 3, wide, wide * 2 / 3));
    text_area.setLeft(text_area.left() + wide + padding);
  }
  painter.setFont(look_.font());
  painter.setPen(colors::kInk);
  painter.drawText(text_area, (level > 0 ? Qt::AlignLeft : Qt::AlignHCenter) | Qt::AlignVCenter, text());
  if (isRinged(*this)) drawRing(painter, face, corner);
}

}  // namespace tactus::workbench::nurse
