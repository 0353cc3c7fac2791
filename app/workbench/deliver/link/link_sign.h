// The sign in the strip while the live link serves: address and number of clients. A click asks for its panel.
#pragma once

#include <QToolButton>

namespace tactus::workbench {

class LinkController;

/// Hidden while nothing is served.
class LinkSign : public QToolButton {
  Q_OBJECT

 public:
  explicit LinkSign(const LinkController& link, QWidget* parent = nullptr);

  QSize sizeHint() const override;
  /// Room for the short text.
  QSize minimumSizeHint() const override;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void showState();
  void fit();
  QSize sizeFor(const QString& text) const;

  const LinkController& link_;
  QString full_;
  QString brief_;
};

}  // namespace tactus::workbench
