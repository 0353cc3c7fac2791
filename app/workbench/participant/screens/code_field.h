// Where a participant types her code.
#pragma once

#include <QLineEdit>
#include <QWidget>

#include "app/workbench/participant/kit/look.h"

namespace tactus::workbench::nurse {

class CodeField : public QWidget {
  Q_OBJECT

 public:
  explicit CodeField(const Look& look, QWidget* parent = nullptr);

  QString code() const { return edit_->text().simplified(); }
  void takeFocus() { edit_->setFocus(); }

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 signals:
  void edited();
  void entered();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void follow();

  const Look& look_;
  QLineEdit* edit_;
};

}  // namespace tactus::workbench::nurse
