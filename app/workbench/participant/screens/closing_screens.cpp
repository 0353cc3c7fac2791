#include "app/workbench/participant/screens/closing_screens.h"

#include <QPainter>
#include <QPrinter>
#include <QPrinterInfo>
#include <QVBoxLayout>

#include "app/workbench/participant/kit/look.h"
#include "app/workbench/participant/kit/participant_state.h"
#include "app/workbench/participant/kit/pictures.h"

namespace tactus::workbench::nurse {

namespace {

constexpr double kHeightShare = 0.6;  // of the width of the page
constexpr double kTextShare = 0.018;

/// On the default printer, without a dialog: a page with the curve.
void print(const ForceCurve& curve) {
  if (!canPrint()) return;
  QPrinter printer(QPrinterInfo::defaultPrinter(), QPrinter::HighResolution);
  printer.setPageOrientation(QPageLayout::Landscape);
  QPainter painter;
  if (!painter.begin(&printer)) return;
  const QRectF page(QPointF(), printer.pageRect(QPrinter::DevicePixel).size());
  QFont font = curve.font();
  font.setPixelSize(static_cast<int>(page.width() * kTextShare));
  painter.setFont(font);
  curve.draw(painter, QRectF(0, 0, page.width(), page.width() * kHeightShare));
}

Phrase sentenceOf(const ParticipantState& state) {
  switch (state.stop) {
    case StopReason::kForToday: return phrase(QStringLiteral("off.stop_kept"), {state.code});
    case StopReason::kWithdrawn: return phrase(QStringLiteral("off.deleted"));
    case StopReason::kNoConsent: break;
  }
  return phrase(QStringLiteral("con.declined"));
}

}  // namespace

bool canPrint() { return !QPrinterInfo::defaultPrinterName().isEmpty(); }

ThanksScreen::ThanksScreen(const Look& look, bool may_print)
    : ScreenFrame(look),
      may_print_(may_print),
      curve_title_(new Label(look, TextRole::kTitle, phrase(QStringLiteral("thx.curve")))),
      curve_(new ForceCurve(look)),
      print_(new Button(look, ButtonKind::kPlain, phrase(QStringLiteral("thx.print")), this)) {
  auto* main = new QWidget(this);
  auto* column = new QVBoxLayout(main);
  keepSpacing(look, *column, 1);
  column->addWidget(curve_title_);
  column->addWidget(curve_, 1);
  setTitle(phrase(QStringLiteral("thx.title")));
  setHint(phrase(QStringLiteral("thx.line")));
  setMain(main);
  addExtra(print_);
  primaryButton().setPhrase(phrase(QStringLiteral("thx.done")));
  connect(print_, &QAbstractButton::clicked, this, [this] { print(*curve_); });
  setState({});
}

void ThanksScreen::setState(const ParticipantState& state) {
  const bool drawn = !state.thanks.curve.empty();
  curve_->setCurve(state.thanks.curve);
  curve_->setVisible(drawn);
  curve_title_->setVisible(drawn);
  print_->setVisible(may_print_ && drawn);
  ScreenFrame::setState(state);
}

StoppedScreen::StoppedScreen(const Look& look, QWidget* parent)
    : ScreenFrame(look, parent),
      texts_(new TextBlock(look, this)),
      lead_(texts_->add(TextRole::kLead, plain(QStringLiteral(" ")))) {
  texts_->center();
  setTitle(phrase(QStringLiteral("thx.title")));
  setMain(texts_);
  primaryButton().setPhrase(phrase(QStringLiteral("nav.continue")));
  setState({});
}

void StoppedScreen::setState(const ParticipantState& state) {
  lead_->setPhrase(sentenceOf(state));
  primaryButton().setVisible(state.can_go_on);
  ScreenFrame::setState(state);
}

namespace {

constexpr double kCupMm = 34;

}  // namespace

RestScreen::RestScreen(const Look& look, QWidget* parent)
    : ScreenFrame(look, parent),
      texts_(new TextBlock(look, this)),
      picture_(new PictureBox(look, kCupMm, kCupMm, texts_)),
      lead_(nullptr),
      body_(nullptr) {
  texts_->add(picture_);
  lead_ = texts_->add(TextRole::kLead, phrase(QStringLiteral("rest.line")));
  body_ = texts_->add(TextRole::kBody, phrase(QStringLiteral("rest.ready")));
  texts_->center();
  setMain(texts_);
  primaryButton().setPhrase(phrase(QStringLiteral("nav.continue")));
  setState({});
}

void RestScreen::setState(const ParticipantState& state) {
  const bool counts = state.begins_to_count;
  picture_->setPicture(counts ? pushPicture() : cupPicture());
  setTitle(phrase(counts ? QStringLiteral("cnt.title") : QStringLiteral("nav.rest")));
  lead_->setPhrase(phrase(counts ? QStringLiteral("cnt.line") : QStringLiteral("rest.line")));
  body_->setPhrase(phrase(counts ? QStringLiteral("for.nothing") : QStringLiteral("rest.ready")));
  ScreenFrame::setState(state);
}

}  // namespace tactus::workbench::nurse
