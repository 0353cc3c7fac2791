#include "app/workbench/deliver/link/link_sign.h"

#include "app/workbench/base/theme.h"
#include "app/workbench/deliver/link/link_controller.h"
#include "app/workbench/deliver/link/link_text.h"

namespace tactus::workbench {

LinkSign::LinkSign(const LinkController& link, QWidget* parent) : QToolButton(parent), link_(link) {
  setFont(theme::smallFont());
  setAutoRaise(true);
  setFocusPolicy(Qt::TabFocus);
  setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
  QPalette colors = palette();
  colors.setColor(QPalette::ButtonText, theme::accent());
  setPalette(colors);
  connect(&link_, &LinkController::changed, this, &LinkSign::showState);
  showState();
}

QSize LinkSign::sizeFor(const QString& text) const {
  const QFontMetrics metrics = fontMetrics();
  const int more = metrics.horizontalAdvance(text) - metrics.horizontalAdvance(this->text());
  return QToolButton::sizeHint() + QSize(more, 0);
}

QSize LinkSign::sizeHint() const { return sizeFor(full_); }

QSize LinkSign::minimumSizeHint() const { return sizeFor(brief_); }

void LinkSign::resizeEvent(QResizeEvent* event) {
  QToolButton::resizeEvent(event);
  fit();
}

void LinkSign::fit() { setText(sizeHint().width() <= width() ? full_ : brief_); }

void LinkSign::showState() {
  // The place becomes known with the next size; until then the text stays as long as it is.
  const bool short_now = !brief_.isEmpty() && text() == brief_;
  setVisible(link_.isServing());
  full_ = servingText(link_);
  brief_ = shortServingText(link_);
  setAccessibleName(full_);
  setToolTip(full_ + QLatin1Char('\n') + tr("Click to see who is connected, or to stop"));
  setText(short_now ? brief_ : full_);
  updateGeometry();
}

}  // namespace tactus::workbench
