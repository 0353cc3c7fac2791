#include "app/workbench/participant/screens/consent_screen.h"

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
  connect(this, &ScreenFrame::back, this, [this] {
    if (text_->page() == 0) {
      emit left();
    } else {
      text_->setPage(text_->page() - 1);
    }
  });
  connect(this, &ScreenFrame::primary, this, [this] {
    if (text_->page() + 1 >= text_->pages()) {
      emit agreed();
    } else {
      text_->setPage(text_->page() + 1);
    }
  });
  setState({});
}

void ConsentScreen::setState(const ConsentState& state) {
  text_->setParagraphs(state.paragraphs);
  setSimulated(state.simulated);
}

void ConsentScreen::showPage() {
  const bool last = text_->page() + 1 >= text_->pages();
  setMayGoBack(may_leave_);
  primaryButton().setPhrase(phrase(last ? QStringLiteral("con.agree") : QStringLiteral("nav.next")));
}

void ConsentScreen::setMayGoBack(bool may) {
  may_leave_ = may;
  ScreenFrame::setMayGoBack(may || text_->page() > 0);
}

}  // namespace tactus::workbench::nurse
