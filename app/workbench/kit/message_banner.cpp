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
    : Card(parent),
      label_(new QLabel(this)),
      buttons_{new QPushButton(this), new QPushButton(this)},
      close_(new QToolButton(this)) {
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
  for (QPushButton* button : buttons_) layout->addWidget(button, 0, Qt::AlignVCenter);
  layout->addWidget(close_, 0, Qt::AlignVCenter);
  hide();

  connect(close_, &QToolButton::clicked, this, &QWidget::hide);
  for (int i = 0; i < 2; ++i) {
    connect(buttons_[i], &QPushButton::clicked, this, [this, i] {
      hide();
      // The act may show the next message.
      if (const auto run = acts_[i].run) run();
    });
  }
}

void MessageBanner::showRemedy(const QString& sentence, MessageAct act, const QObject* from, MessageAct other) {
  show(sentence, theme::errorInk(), theme::errorFill(), std::move(act), std::move(other));
  from_ = from;
}

void MessageBanner::takeBack(const QObject& from) {
  if (from_ == &from) hide();
}

void MessageBanner::showOffer(const QString& sentence, MessageAct act, MessageAct other) {
  show(sentence, theme::warningInk(), theme::warningFill(), std::move(act), std::move(other));
}

void MessageBanner::showNote(const QString& sentence) { show(sentence, theme::warningInk(), theme::warningFill()); }

QString MessageBanner::message() const { return label_->text(); }

void MessageBanner::show(const QString& sentence, const QColor& ink, const QColor& fill, MessageAct act,
                         MessageAct other) {
  from_ = nullptr;
  QPalette colors = label_->palette();
  colors.setColor(QPalette::WindowText, ink);
  label_->setPalette(colors);
  close_->setPalette(colors);
  label_->setText(text(base::plainLines(sentence.toStdString())));
  acts_[0] = std::move(act);
  acts_[1] = std::move(other);
  for (int i = 0; i < 2; ++i) {
    buttons_[i]->setText(acts_[i].text);
    buttons_[i]->setVisible(!acts_[i].text.isEmpty());
  }
  setColors(fill, fill);
  setVisible(true);
}

}  // namespace tactus::workbench
