// Text in as many lines as it needs, in a place whose height somebody else gives: unlike a QLabel it does not make the
// height of everything around it depend on the width, which would let a scroll area scroll where all fits.
#pragma once

#include <QLabel>

namespace tactus::workbench {

class WrappedLabel : public QLabel {
  Q_OBJECT

 public:
  explicit WrappedLabel(QWidget* parent = nullptr);

  bool hasHeightForWidth() const override { return false; }
};

}  // namespace tactus::workbench
