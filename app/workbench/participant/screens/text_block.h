// Texts of a screen, one below the other: the one sentence in large letters, what belongs to it below.
#pragma once

#include <QVBoxLayout>
#include <QWidget>
#include <vector>

#include "app/workbench/participant/kit/label.h"

namespace tactus::workbench::nurse {

class TextBlock : public QWidget {
  Q_OBJECT

 public:
  explicit TextBlock(const Look& look, QWidget* parent = nullptr);

  Label* add(TextRole role, const Phrase& text = {});
  void add(QWidget* widget, Qt::Alignment alignment = {});
  /// The texts stand in the middle of the height instead of at the top. Call last.
  void center();

  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override { return layout_->heightForWidth(width); }

 private:
  const Look& look_;
  QVBoxLayout* layout_;
};

/// Shows `label` with `text`, or hides it if there is none.
void showOrHide(Label& label, const Phrase& text);

}  // namespace tactus::workbench::nurse
