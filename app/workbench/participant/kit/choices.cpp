#include "app/workbench/participant/kit/choices.h"

#include <algorithm>
#include <iterator>

#include "app/workbench/participant/kit/ring.h"

namespace tactus::workbench::nurse {
namespace {

constexpr double kChoiceWidestMm = 80;  // of a card
constexpr double kChoiceGapMm = 3;

std::vector<Answer> words(std::initializer_list<const char*> apart) {
  std::vector<Answer> answers;
  int level = 0;
  for (const char* id : {"very_small", "small", "medium", "large", "very_large"}) {
    answers.push_back(
        {QString::fromLatin1(id), phrase(QStringLiteral("w.") + QString::fromLatin1(id)), strengthPicture(++level)});
  }
  for (const char* id : apart) {
    const QString text = QString::fromLatin1(id) == QStringLiteral("beyond_practice") ? QStringLiteral("beyond")
                                                                                      : QString::fromLatin1(id);
    answers.push_back({QString::fromLatin1(id), phrase(QStringLiteral("w.") + text), {}, true});
  }
  return answers;
}

}  // namespace

std::vector<Answer> forceWords() { return words({"not_felt", "beyond_practice"}); }
std::vector<Answer> questionWords() { return words({"cant_tell"}); }

Choices::Choices(const Look& look, QWidget* parent) : QWidget(parent), look_(look) {
  QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
  connect(&look, &Look::changed, this, [this] {
    updateGeometry();
    arrange(width(), true);
  });
}

void Choices::setAnswers(std::vector<Answer> answers) {
  const bool same = std::equal(answers.begin(), answers.end(), cards_.begin(), cards_.end(),
                               [](const Answer& answer, const AnswerCard* card) { return answer.id == card->id(); });
  if (same) return;
  giveKeyboardBack(*this);
  qDeleteAll(cards_);
  cards_.clear();
  const auto on_scale = static_cast<int>(
      std::count_if(answers.begin(), answers.end(), [](const Answer& answer) { return !answer.apart; }));
  int place = 0;
  for (Answer& answer : answers) {
    const bool apart = answer.apart;
    auto* card = new AnswerCard(look_, std::move(answer), apart ? 0 : ++place, apart ? 0 : on_scale, this);
    connect(card, &QAbstractButton::clicked, this, [this, card] { emit picked(card->id()); });
    card->show();
    cards_.push_back(card);
  }
  updateGeometry();
  arrange(width(), true);
}

void Choices::choose(const QString& id) {
  if (id != chosen()) giveKeyboardBack(*this);
  for (AnswerCard* card : cards_) {
    if (card->isChecked() == (card->id() == id)) continue;
    card->setAutoExclusive(false);
    card->setChecked(card->id() == id);
    card->setAutoExclusive(true);
  }
}

void Choices::light(const QString& id) {
  for (AnswerCard* card : cards_) card->setLit(card->id() == id);
}

QString Choices::chosen() const {
  const auto found =
      std::find_if(cards_.begin(), cards_.end(), [](const AnswerCard* card) { return card->isChecked(); });
  return found == cards_.end() ? QString() : (*found)->id();
}

QString Choices::onScale(int place) const {
  const std::vector<AnswerCard*> scale = row(false);
  return place >= 1 && place <= static_cast<int>(scale.size()) ? scale[static_cast<std::size_t>(place - 1)]->id()
                                                               : QString();
}

bool Choices::offers(const QString& id) const {
  return std::any_of(cards_.begin(), cards_.end(), [&id](const AnswerCard* card) { return card->id() == id; });
}

std::vector<AnswerCard*> Choices::row(bool apart) const {
  std::vector<AnswerCard*> cards;
  std::copy_if(cards_.begin(), cards_.end(), std::back_inserter(cards),
               [apart](const AnswerCard* card) { return card->isApart() == apart; });
  return cards;
}

int Choices::columnWidth(int width) const {
  const auto count = static_cast<int>(row(false).size());
  if (count == 0) return 0;
  return std::min(look_.mm(kChoiceWidestMm), (width - (count - 1) * look_.mm(kChoiceGapMm)) / count);
}

int Choices::arrange(int width, bool set) const {
  const int gap = look_.mm(kChoiceGapMm);
  const std::vector<AnswerCard*> scale = row(false);
  int y = 0;
  if (!scale.empty()) {
    const int column = columnWidth(width);
    int high = 0;
    for (const AnswerCard* card : scale) high = std::max(high, card->heightForWidth(column));
    int x = 0;
    for (AnswerCard* card : scale) {
      if (set) card->setGeometry(x, y, column, high);
      x += column + gap;
    }
    y += high;
  }
  const std::vector<AnswerCard*> apart = row(true);
  if (!apart.empty()) {
    int x = 0;
    if (y > 0) y += gap;
    int high = 0;
    for (AnswerCard* card : apart) {
      const QSize size = card->sizeHint();
      if (set) card->setGeometry(x, y, size.width(), size.height());
      x += size.width() + gap;
      high = std::max(high, size.height());
    }
    y += high;
  }
  return y;
}

QSize Choices::sizeHint() const {
  int wide = 0;
  for (const AnswerCard* card : row(false)) wide += card->sizeHint().width() + look_.mm(kChoiceGapMm);
  return {wide, arrange(std::max(width(), 1), false)};
}

int Choices::heightForWidth(int width) const { return arrange(width, false); }

void Choices::resizeEvent(QResizeEvent* /*event*/) { arrange(width(), true); }

}  // namespace tactus::workbench::nurse
