#include "app/workbench/kit/wrapped_label.h"

namespace tactus::workbench {

WrappedLabel::WrappedLabel(QWidget* parent) : QLabel(parent) {
  setTextFormat(Qt::PlainText);
  setWordWrap(true);
  setAlignment(Qt::AlignLeft | Qt::AlignTop);
}

}  // namespace tactus::workbench
