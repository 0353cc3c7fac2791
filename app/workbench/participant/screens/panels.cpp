#include "app/workbench/participant/screens/panels.h"

#include <QEvent>
#include <QPainter>
#include <algorithm>

#include "app/workbench/participant/kit/look.h"
#include "app/workbench/participant/kit/participant_state.h"
#include "app/workbench/participant/kit/screen_frame.h"

namespace tactus::workbench::nurse {

ForceOffPanel::ForceOffPanel(const Look& look, const std::vector<QString>& languages, QWidget* parent)
    : PanelCard(look, parent), has_languages_(languages.size() > 1) {
  lead_ = addText(TextRole::kLead, phrase(QStringLiteral("off.done")));
  called_ = addText(TextRole::kBody, phrase(QStringLiteral("off.called")));
  Button* go_on = addButton(ButtonKind::kPrimary, phrase(QStringLiteral("nav.continue")));
  call_ = addButton(ButtonKind::kPlain, phrase(QStringLiteral("off.call")));
  Button* reading = addButton(ButtonKind::kPlain, phrase(QStringLiteral("off.reading")));
  Button* stop = addButton(ButtonKind::kPlain, phrase(QStringLiteral("off.stop")));
  Button* withdraw_button = addButton(ButtonKind::kPlain, phrase(QStringLiteral("off.withdraw")));
  acts_ = {go_on, reading, stop, withdraw_button};
  languages_ = new Choices(look);
  languages_->setAnswers(languageAnswers(languages));
  sizes_ = new Choices(look);
  sizes_->setAnswers(sizeAnswers());
  addWidget(languages_);
  addWidget(sizes_);
  back_ = addButton(ButtonKind::kPrimary, phrase(QStringLiteral("nav.back")));
  connect(languages_, &Choices::picked, this, &ForceOffPanel::languagePicked);
  connect(sizes_, &Choices::picked, this, [this](const QString& id) { emit textSizePicked(id.toInt()); });
  connect(reading, &QAbstractButton::clicked, this, [this] { turnToReading(true); });
  connect(back_, &QAbstractButton::clicked, this, [this] { turnToReading(false); });
  connect(go_on, &QAbstractButton::clicked, this, &ForceOffPanel::goOn);
  connect(call_, &QAbstractButton::clicked, this, &ForceOffPanel::callResearcher);
  connect(stop, &QAbstractButton::clicked, this, &ForceOffPanel::stopForToday);
  connect(withdraw_button, &QAbstractButton::clicked, this, &ForceOffPanel::withdraw);
  setState({});
}

void ForceOffPanel::setState(const ParticipantState& state) {
  called_now_ = state.overlay == ForceOffOverlay::kCalled;
  lead_->setPhrase(phrase(state.quiet_pause ? QStringLiteral("off.paused") : QStringLiteral("off.done")));
  called_->setPhrase(phrase(!state.monitored  ? QStringLiteral("off.hand")
                            : state.call_seen ? QStringLiteral("off.called")
                                              : QStringLiteral("off.calling")));
  languages_->choose(state.language);
  sizes_->choose(QString::number(state.text_percent));
  turnToReading(reading_);
}

void ForceOffPanel::turnToReading(bool reading) {
  reading_ = reading;
  for (Button* act : acts_) act->setVisible(!reading);
  called_->setVisible(called_now_ && !reading);
  call_->setVisible(!called_now_ && !reading);
  languages_->setVisible(reading && has_languages_);  // with one alone nothing is to be chosen
  sizes_->setVisible(reading);
  back_->setVisible(reading);
}

WithdrawPanel::WithdrawPanel(const Look& look, QWidget* parent) : PanelCard(look, parent) {
  addText(TextRole::kLead, phrase(QStringLiteral("off.withdraw")));
  addText(TextRole::kBody, phrase(QStringLiteral("off.withdraw_ask")));
  Button* keep_button = addButton(ButtonKind::kPrimary, phrase(QStringLiteral("off.keep")));
  Button* withdraw_button = addButton(ButtonKind::kPlain, phrase(QStringLiteral("off.withdraw")));
  connect(keep_button, &QAbstractButton::clicked, this, &WithdrawPanel::keep);
  connect(withdraw_button, &QAbstractButton::clicked, this, &WithdrawPanel::withdraw);
}

NoticePanel::NoticePanel(const Look& look, const Phrase& sentence, QWidget* parent) : PanelCard(look, parent) {
  addText(TextRole::kLead, sentence);
}

namespace {

constexpr QColor kDimmed(0x1F, 0x29, 0x33, 190);
constexpr double kPanelWidthMm = 210;
constexpr int kWidthTexts = 20;  // heights of text
constexpr double kPanelPaddingMm = 8;
constexpr double kPanelCornerMm = 3;

}  // namespace

PanelCard::PanelCard(const Look& look, QWidget* parent)
    : QWidget(parent), look_(look), card_(new QWidget(this)), column_(new QVBoxLayout(card_)) {
  setFocusPolicy(Qt::StrongFocus);
  keepSpacing(look, *column_, 1);
  connect(&look, &Look::changed, this, &PanelCard::arrange);
}

Label* PanelCard::addText(TextRole role, const Phrase& text) {
  auto* label = new Label(look_, role, text, card_);
  column_->addWidget(label);
  return label;
}

Button* PanelCard::addButton(ButtonKind kind, const Phrase& text) {
  auto* button = new Button(look_, kind, text, card_);
  button->keepOneLine();
  column_->addWidget(button);
  return button;
}

void PanelCard::addWidget(QWidget* widget) {
  widget->setParent(card_);
  column_->addWidget(widget);
}

bool PanelCard::event(QEvent* event) {
  if (event->type() == QEvent::LayoutRequest) arrange();
  return QWidget::event(event);
}

void PanelCard::resizeEvent(QResizeEvent* /*event*/) { arrange(); }

void PanelCard::arrange() {
  const int corner = forceOffCorner(look_).width();
  // Left of the corner, where the red button stays in view.
  const int least = std::max(look_.mm(kPanelWidthMm), kWidthTexts * look_.textPx());
  const int wide = std::min(least, width() - 2 * (corner + frameMargin(look_)));
  const int high = column_->heightForWidth(wide);
  card_->setGeometry((width() - wide) / 2, (height() - high) / 2, wide, high);
  update();
}

void PanelCard::showEvent(QShowEvent* /*event*/) { setFocus(); }

void PanelCard::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), kDimmed);
  const int padding = look_.mm(kPanelPaddingMm);
  painter.setPen(Qt::NoPen);
  painter.setBrush(colors::kCard);
  painter.drawRoundedRect(card_->geometry().adjusted(-padding, -padding, padding, padding), look_.mm(kPanelCornerMm),
                          look_.mm(kPanelCornerMm));
}

}  // namespace tactus::workbench::nurse
