// The answers to one question: those on the scale in one row of equal cards, from left to right in their order, those
// apart from it in a second row. Nothing is chosen at the start.
#pragma once

#include <QAbstractButton>
#include <QWidget>
#include <optional>
#include <vector>

#include "app/workbench/participant/kit/look.h"
#include "app/workbench/participant/kit/pictures.h"

namespace tactus::workbench::nurse {

/// One answer as a card: a picture and a word. The whole card reacts. Chosen: a thick dark border, a tick and bold, not
/// color alone.
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
  void refreshState();

  const Look& look_;
  Answer answer_;
  int place_;
  int count_;
  bool lit_ = false;
};

class Choices : public QWidget {
  Q_OBJECT

 public:
  explicit Choices(const Look& look, QWidget* parent = nullptr);

  /// Makes new cards only if the ids differ.
  void setAnswers(std::vector<Answer> answers);
  /// Shows `id` as chosen; empty or unknown: none.
  void choose(const QString& id);
  QString chosen() const;
  /// Marks `id` as the one that the device's button would choose; empty: none.
  void light(const QString& id);
  /// The id of answer `place` on the scale, from 1; empty if there is none.
  QString onScale(int place) const;
  /// The id of the first answer apart from the scale; empty if there is none.
  QString apart() const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;

 signals:
  void picked(const QString& id);  ///< by the person

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  /// Sets the cards into `width` px if `set`; the height that they take.
  int arrange(int width, bool set) const;
  int columnWidth(int width) const;
  std::vector<AnswerCard*> row(bool apart) const;

  const Look& look_;
  std::vector<AnswerCard*> cards_;
};

/// The words of force of the procedure, `not_felt` and `beyond_practice` apart, as the vote knows them.
std::vector<Answer> forceWords(const Look& look);
/// The words that the form offers, and "I can't tell".
std::vector<Answer> questionWords(const Look& look);
/// The languages with the ids `offered`, each in its own words.
std::vector<Answer> languageAnswers(const std::vector<QString>& offered);
/// The sizes of text, by their percent.
std::vector<Answer> sizeAnswers();

}  // namespace tactus::workbench::nurse
