#include "app/workbench/participant/screens/text_block.h"

#include "app/workbench/participant/kit/look.h"

namespace tactus::workbench::nurse {

TextBlock::TextBlock(const Look& look, QWidget* parent) : QWidget(parent), look_(look), layout_(new QVBoxLayout(this)) {
  keepSpacing(look, *layout_, 2);
}

Label* TextBlock::add(TextRole role, const Phrase& text) {
  auto* label = new Label(look_, role, text, this);
  label->setVisible(!text.isEmpty());
  layout_->addWidget(label);
  return label;
}

void TextBlock::add(QWidget* widget, Qt::Alignment alignment) { layout_->addWidget(widget, 0, alignment); }

void TextBlock::center() {
  layout_->insertStretch(0, 2);
  layout_->addStretch(3);
}

void showOrHide(Label& label, const Phrase& text) {
  label.setPhrase(text);
  label.setVisible(!text.isEmpty());
}

}  // namespace tactus::workbench::nurse
