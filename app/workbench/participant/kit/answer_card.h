// One answer as a card: a picture and a word. The whole card reacts. Chosen: a thick dark border, a tick and bold, not
// color alone.
#pragma once

#include <QAbstractButton>

#include "app/workbench/participant/kit/look.h"
#include "app/workbench/participant/kit/pictures.h"

namespace tactus::workbench::nurse {

struct Answer {
  QString id;  ///< a term, `not_felt`, …
  Phrase word;
  Picture picture = {};
  bool apart = false;  ///< not on the scale: stands in a row of its own
  /// Its own language for the name of a language.
  std::optional<Language> language = std::nullopt;
};

class AnswerCard : public QAbstractButton {
  Q_OBJECT

 public:
  /// The card is number `place` of `count` on its scale; a count of 0: on no scale.
  AnswerCard(const Look& look, Answer answer, int place, int count, QWidget* parent = nullptr);

  const QString& id() const { return answer_.id; }
  /// The device's button would choose it: a ring, as around what has the keyboard.
  void setLit(bool lit);
  bool isApart() const { return answer_.apart; }

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool hitButton(const QPoint& at) const override;

 private:
  QFont font(bool bold) const;
  void follow();

  const Look& look_;
  Answer answer_;
  int place_;
  int count_;
  bool lit_ = false;
};

}  // namespace tactus::workbench::nurse
