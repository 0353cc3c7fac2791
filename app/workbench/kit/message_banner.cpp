#include "app/workbench/kit/message_banner.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "core/base/error.h"

namespace tactus::workbench {

MessageBanner::MessageBanner(QWidget* parent) : Card(parent), label_(new QLabel(this)), close_(new QToolButton(this)) {
  label_->setWordWrap(true);
  label_->setTextFormat(Qt::PlainText);
  label_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  close_->setText(QStringLiteral("✕"));
  close_->setAutoRaise(true);
  close_->setToolTip(tr("Close this message"));
  close_->setAccessibleName(tr("Close this message"));

  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(2 * theme::kGrid, theme::kGrid, theme::kGrid, theme::kGrid);
  layout->setSpacing(theme::kGrid);
  layout->addWidget(label_, 1);
  layout->addWidget(close_, 0, Qt::AlignTop);
  hide();

  connect(close_, &QToolButton::clicked, this, &QWidget::hide);
}

void MessageBanner::showError(const QString& sentence) { show(sentence, theme::errorInk(), theme::errorFill()); }

void MessageBanner::showNote(const QString& sentence) { show(sentence, theme::warningInk(), theme::warningFill()); }

QString MessageBanner::message() const { return label_->text(); }

void MessageBanner::show(const QString& sentence, const QColor& ink, const QColor& fill) {
  QPalette colors = label_->palette();
  colors.setColor(QPalette::WindowText, ink);
  label_->setPalette(colors);
  close_->setPalette(colors);
  label_->setText(text(base::plainLines(sentence.toStdString())));
  setColors(fill, fill);
  setVisible(true);
}

}  // namespace tactus::workbench
