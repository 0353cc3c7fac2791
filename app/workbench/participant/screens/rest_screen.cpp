#include "app/workbench/participant/screens/rest_screen.h"

#include "app/workbench/participant/kit/picture_box.h"

namespace tactus::workbench::nurse {
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
