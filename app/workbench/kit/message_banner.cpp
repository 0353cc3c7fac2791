#include "app/workbench/kit/message_banner.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "core/base/error.h"

namespace tactus::workbench {

MessageBanner::MessageBanner(QWidget* parent)
    : Card(parent), label_(new QLabel(this)), act_button_(new QPushButton(this)), close_(new QToolButton(this)) {
  label_->setWordWrap(true);
  label_->setTextFormat(Qt::PlainText);
  label_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  close_->setText(QStringLiteral("✕"));
  close_->setAutoRaise(true);
  close_->setToolTip(tr("Close this message"));
  close_->setAccessibleName(tr("Close this message"));

  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(2 * theme::kGrid, theme::kGrid / 2, theme::kGrid, theme::kGrid / 2);
  layout->setSpacing(theme::kGrid);
  layout->addWidget(label_, 1);
  layout->addWidget(act_button_, 0, Qt::AlignVCenter);
  layout->addWidget(close_, 0, Qt::AlignVCenter);
  hide();

  connect(close_, &QToolButton::clicked, this, &QWidget::hide);
  connect(act_button_, &QPushButton::clicked, this, [this] {
    hide();
    // The act may show the next message.
    if (const auto run = act_.run) run();
  });
}

void MessageBanner::showError(const QString& sentence) { show(sentence, theme::errorInk(), theme::errorFill()); }

void MessageBanner::showRemedy(const QString& sentence, MessageAct act) {
  show(sentence, theme::errorInk(), theme::errorFill(), std::move(act));
}

void MessageBanner::showOffer(const QString& sentence, MessageAct act) {
  show(sentence, theme::warningInk(), theme::warningFill(), std::move(act));
}

void MessageBanner::showNote(const QString& sentence) { show(sentence, theme::warningInk(), theme::warningFill()); }

QString MessageBanner::message() const { return label_->text(); }

void MessageBanner::show(const QString& sentence, const QColor& ink, const QColor& fill, MessageAct act) {
  QPalette colors = label_->palette();
  colors.setColor(QPalette::WindowText, ink);
  label_->setPalette(colors);
  close_->setPalette(colors);
  label_->setText(text(base::plainLines(sentence.toStdString())));
  act_ = std::move(act);
  act_button_->setText(act_.text);
  act_button_->setVisible(!act_.text.isEmpty());
  setColors(fill, fill);
  setVisible(true);
}

}  // namespace tactus::workbench
