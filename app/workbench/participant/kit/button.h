// A large button of the nurse's screens. A touch counts where it began if it ends within 10 mm, however long it lasts.
#pragma once

#include <QAbstractButton>
#include <QRectF>
#include <optional>

#include "app/workbench/participant/kit/look.h"

class QPainter;
class QWidget;

namespace tactus::workbench::nurse {

// The ring around what the keyboard has reached, and the room that every control leaves for it.

/// px between the edge of a control and its face: a ring of 3 px, 2 px away from the face.
inline constexpr int kRingRoom = 6;

/// The face of a control of `size` px.
inline QRectF faceOf(const QSizeF& size) {
  return QRectF(QPointF(), size).adjusted(kRingRoom, kRingRoom, -kRingRoom, -kRingRoom);
}

/// Whether `control` has the keyboard and somebody moves it there by keys: after Tab or an arrow in its window, until a
/// press of the mouse, of a finger or of a pen. Whoever never moves by keys sees no ring, which would look like a
/// choice.
bool isRinged(const QWidget& control);

/// Gives the keyboard of `within`, or of a part of it, back to its screen. A next question begins so: the card that was
/// chosen before must not stand out.
void giveKeyboardBack(const QWidget& within);

void drawRing(QPainter& painter, const QRectF& face, double corner_radius);

enum class ButtonKind {
  kPrimary,   ///< the one action of the screen
  kPlain,     ///< everything else
  kQuiet,     ///< small, for the researcher beside her
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
  void refreshState();
  QColor fill() const;
  /// A checked button has a tick before its text.
  QString shown(const QString& text) const;
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
