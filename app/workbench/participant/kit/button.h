// A large button of the nurse's screens. A touch counts where it began if it ends within 10 mm, however long it lasts.
#pragma once

#include <QAbstractButton>
#include <optional>

#include "app/workbench/participant/kit/look.h"

namespace tactus::workbench::nurse {

enum class ButtonKind {
  kPrimary,   ///< the one action of the screen
  kPlain,     ///< everything else
  kForceOff,  ///< red and larger; act on `pressed`, not on `clicked`
};

class Button : public QAbstractButton {
  Q_OBJECT

 public:
  Button(const Look& look, ButtonKind kind, const Phrase& text, QWidget* parent = nullptr);

  void setPhrase(const Phrase& text);
  /// The button waits and says what for; nothing: it can be used. It keeps its place and size.
  void waitFor(const std::optional<Phrase>& reason);
  /// Room for this text too, which it will say later.
  void reserve(const Phrase& text);
  /// Where there is room for the longest text.
  void keepOneLine();

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool hitButton(const QPoint& at) const override;

 private:
  void follow();
  QColor fill() const;
  /// What `text` takes, on two lines if it is long, px.
  QSize room(const QString& text) const;

  const Look& look_;
  ButtonKind kind_;
  Phrase text_;
  std::optional<Phrase> reason_;
  Phrase reserved_;
  bool one_line_ = false;
};

/// Where a touch may end that began inside `control`.
bool endsNear(const Look& look, const QWidget& control, const QPoint& at);

}  // namespace tactus::workbench::nurse
