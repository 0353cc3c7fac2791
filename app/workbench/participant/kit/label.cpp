#include "app/workbench/participant/kit/label.h"

#include "app/workbench/participant/kit/colors.h"

namespace tactus::workbench::nurse {
namespace {

constexpr double kLeadFactor = 1.2;

}  // namespace

Label::Label(const Look& look, TextRole role, QWidget* parent) : Label(look, role, Phrase{}, parent) {}

Label::Label(const Look& look, TextRole role, const Phrase& text, QWidget* parent)
    : QLabel(parent), look_(look), role_(role), text_(text) {
  setTextFormat(Qt::PlainText);
  setWordWrap(true);
  const bool muted = role == TextRole::kTitle || role == TextRole::kMuted;
  QPalette colors = palette();
  colors.setColor(QPalette::WindowText, muted ? colors::kMutedInk : colors::kInk);
  setPalette(colors);
  connect(&look, &Look::changed, this, &Label::follow);
  follow();
}

void Label::setPhrase(const Phrase& text) {
  if (text == text_) return;
  text_ = text;
  follow();
}

void Label::follow() {
  const bool bold = role_ == TextRole::kLead || role_ == TextRole::kTitle;
  setFont(look_.font(role_ == TextRole::kLead ? kLeadFactor : 1, bold));
  setText(look_.say(text_));
}

}  // namespace tactus::workbench::nurse
