#include "app/workbench/participant/screens/stopped_screen.h"

namespace tactus::workbench::nurse {
namespace {

Phrase sentenceOf(const StoppedState& state) {
  switch (state.reason) {
    case StopReason::kForToday:
      return phrase(QStringLiteral("off.stop_kept"), {state.code});
    case StopReason::kWithdrawn:
      return phrase(QStringLiteral("off.deleted"));
    case StopReason::kNoConsent:
      return phrase(QStringLiteral("con.declined"));
    case StopReason::kPaused:
      return phrase(QStringLiteral("err.paused"));
    case StopReason::kNotSaved:
      return phrase(QStringLiteral("err.save"));
    case StopReason::kDeviceLost:
      break;
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

}  // namespace tactus::workbench::nurse
