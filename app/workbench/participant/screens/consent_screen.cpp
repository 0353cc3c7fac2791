#include "app/workbench/participant/screens/consent_screen.h"

#include "app/workbench/participant/kit/participant_state.h"

namespace tactus::workbench::nurse {

ConsentScreen::ConsentScreen(const Look& look, QWidget* parent)
    : ScreenFrame(look, parent), text_(new PagedText(look, this)) {
  setTitle(phrase(QStringLiteral("con.title")));
  setMain(text_);
  // The room for the text is the same on each page.
  primaryButton().reserve(phrase(QStringLiteral("con.agree")));
  auto* decline = new Button(look, ButtonKind::kPlain, phrase(QStringLiteral("con.decline")), this);
  addExtra(decline);
  connect(decline, &QAbstractButton::clicked, this, &ConsentScreen::declined);
  connect(text_, &PagedText::paged, this, &ConsentScreen::showPage);
  setState({});
}

void ConsentScreen::setState(const ParticipantState& state) {
  text_->setParagraphs(state.consent.paragraphs);
  ScreenFrame::setState(state);
}

bool ConsentScreen::turnPage(int by) {
  const int page = text_->page() + by;
  if (page < 0 || page >= text_->pages()) return false;
  text_->setPage(page);
  return true;
}

void ConsentScreen::showPage() {
  const bool last = text_->page() + 1 >= text_->pages();
  showBack();
  primaryButton().setPhrase(phrase(last ? QStringLiteral("con.agree") : QStringLiteral("nav.next")));
}

}  // namespace tactus::workbench::nurse
