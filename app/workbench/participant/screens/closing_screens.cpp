#include "app/workbench/participant/screens/closing_screens.h"

#include <QVBoxLayout>

#include "app/workbench/participant/kit/look.h"
#include "app/workbench/participant/kit/pictures.h"

namespace tactus::workbench::nurse {

ThanksScreen::ThanksScreen(const Look& look, QWidget* parent)
    : ScreenFrame(look, parent),
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
  backButton().hide();
  primaryButton().setPhrase(phrase(QStringLiteral("thx.done")));
  connect(print_, &QAbstractButton::clicked, this, &ThanksScreen::print);
  connect(this, &ScreenFrame::primary, this, &ThanksScreen::done);
  setState({});
}

void ThanksScreen::setState(const ThanksState& state) {
  curve_->setCurve(state.curve);
  curve_->setVisible(!state.curve.empty());
  curve_title_->setVisible(!state.curve.empty());
  print_->setVisible(state.may_print && !state.curve.empty());
  setSimulated(state.simulated);
}

namespace {

Phrase sentenceOf(const StoppedState& state) {
  switch (state.reason) {
    case StopReason::kForToday: return phrase(QStringLiteral("off.stop_kept"), {state.code});
    case StopReason::kWithdrawn: return phrase(QStringLiteral("off.deleted"));
    case StopReason::kNoConsent: return phrase(QStringLiteral("con.declined"));
    case StopReason::kPaused: return phrase(QStringLiteral("err.paused"));
    case StopReason::kNotSaved: return phrase(QStringLiteral("err.save"));
    case StopReason::kDeviceLost: break;
  }
  return phrase(QStringLiteral("dev.lost"));
}

}  // namespace

StoppedScreen::StoppedScreen(const Look& look, QWidget* parent)
    : ScreenFrame(look, parent),
      texts_(new TextBlock(look, this)),
      lead_(texts_->add(TextRole::kLead, plain(QStringLiteral(" ")))) {
  texts_->center();
  setMain(texts_);
  backButton().hide();
  primaryButton().setPhrase(phrase(QStringLiteral("nav.continue")));
  setState({});
}

void StoppedScreen::setState(const StoppedState& state) {
  const bool over = state.reason == StopReason::kForToday || state.reason == StopReason::kWithdrawn ||
                    state.reason == StopReason::kNoConsent;
  setTitle(over ? phrase(QStringLiteral("thx.title")) : Phrase{});
  lead_->setPhrase(sentenceOf(state));
  primaryButton().setVisible(state.may_go_on);
  setSimulated(state.simulated);
}

namespace {

constexpr double kCupMm = 34;

}  // namespace

RestScreen::RestScreen(const Look& look, QWidget* parent)
    : ScreenFrame(look, parent), texts_(new TextBlock(look, this)) {
  auto* cup = new PictureBox(look, kCupMm, kCupMm, texts_);
  cup->setPicture(cupPicture());
  texts_->add(cup);
  texts_->add(TextRole::kLead, phrase(QStringLiteral("rest.line")));
  texts_->add(TextRole::kBody, phrase(QStringLiteral("rest.ready")));
  texts_->center();
  setTitle(phrase(QStringLiteral("nav.rest")));
  setMain(texts_);
  backButton().hide();
  primaryButton().setPhrase(phrase(QStringLiteral("nav.continue")));
}

}  // namespace tactus::workbench::nurse
