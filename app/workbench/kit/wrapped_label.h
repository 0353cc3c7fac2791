// Text on as many lines as it needs, in a place whose height the layout sets. With a QLabel the height of the whole
// layout would depend on the width, and a scroll area could scroll although everything fits.
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
