#include "app/workbench/participant/kit/choices.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include "app/workbench/base/display_text.h"
#include "app/workbench/participant/kit/button.h"
#include "app/workbench/participant/kit/look.h"

namespace tactus::workbench::nurse {
namespace {

constexpr double kWidthMm = 30;
constexpr double kHeightMm = 25;
constexpr double kApartHeightMm = 20;
constexpr double kCardPaddingMm = 2.5;
constexpr double kPictureMm = 9;
constexpr double kCornerMm = 2;
constexpr double kTickMm = 6;
constexpr int kTextFlags = Qt::AlignCenter | Qt::TextWordWrap;

}  // namespace

AnswerCard::AnswerCard(const Look& look, Answer answer, int place, int count, QWidget* parent)
    : QAbstractButton(parent), look_(look), answer_(std::move(answer)), place_(place), count_(count) {
  setCheckable(true);
  // Reads as one of several, none of them chosen at the start; arrow keys move the focus without choosing.
  setAutoExclusive(true);
  setFocusPolicy(Qt::StrongFocus);
  connect(&look, &Look::changed, this, &AnswerCard::refreshState);
  connect(this, &QAbstractButton::toggled, this, &AnswerCard::refreshState);
  refreshState();
}

void AnswerCard::refreshState() {
  const QString word = look_.say(answer_.word, answer_.language.value_or(look_.language()));
  setText(word);
  QString name = word;
  if (count_ > 0)
    name = look_.say(phrase(QStringLiteral("acc.of"), {word, QString::number(place_), QString::number(count_)}));
  if (isChecked()) name = look_.say(phrase(QStringLiteral("acc.chosen"), {name}));
  setAccessibleName(name);
  updateGeometry();
  update();
}

QFont AnswerCard::font(bool bold) const { return look_.font(answer_.language.value_or(look_.language()), 1, bold); }

void AnswerCard::setLit(bool lit) {
  if (lit == lit_) return;
  lit_ = lit;
  update();
}

QSize AnswerCard::sizeHint() const {
  const double text_width = QFontMetricsF(font(true)).horizontalAdvance(text());
  const int padding = look_.mm(kCardPaddingMm) + (answer_.apart ? look_.mm(kTickMm) : 0);
  const int wide = std::max(look_.mm(kWidthMm), static_cast<int>(std::ceil(text_width)) + 2 * padding) + 2 * kRingRoom;
  return {wide, heightForWidth(wide)};
}

int AnswerCard::heightForWidth(int width) const {
  const int padding = look_.mm(kCardPaddingMm);
  const QRectF room(0, 0, std::max(1, width - 2 * kRingRoom - 2 * padding), 1e6);
  const double text_height = QFontMetricsF(font(true)).boundingRect(room, kTextFlags, text()).height();
  const int picture = answer_.picture ? look_.mm(kPictureMm) + padding / 2 : 0;
  const int least = look_.mm(answer_.apart ? kApartHeightMm : kHeightMm);
  return std::max(least, static_cast<int>(std::ceil(text_height)) + picture + 2 * padding) + 2 * kRingRoom;
}

bool AnswerCard::hitButton(const QPoint& at) const {
  return isDown() ? endsNear(look_, *this, at) : rect().contains(at);
}

void AnswerCard::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF face = faceOf(size());
  const double corner = look_.mm(kCornerMm);
  const double padding = look_.mm(kCardPaddingMm);
  const bool marked = isChecked() || isDown();
  const double edge = isChecked() ? 4 : 1.5;
  painter.setPen(QPen(isChecked() ? colors::kInk : colors::kEdge, edge,
                      answer_.apart && !isChecked() ? Qt::DashLine : Qt::SolidLine));
  painter.setBrush(marked ? colors::kChosen : colors::kCard);
  painter.drawRoundedRect(face.adjusted(edge / 2, edge / 2, -edge / 2, -edge / 2), corner, corner);

  QRectF text_area = face.adjusted(padding, padding, -padding, -padding);
  if (answer_.picture) {
    const double high = look_.mm(kPictureMm);
    // What the text does not need is shared above and below.
    const double used =
        high + padding / 2 +
        QFontMetricsF(font(true)).boundingRect(QRectF(0, 0, text_area.width(), 1e6), kTextFlags, text()).height();
    const double above = std::max(0.0, (text_area.height() - used) / 2);
    painter.save();
    answer_.picture(painter, QRectF(text_area.left(), text_area.top() + above, text_area.width(), high));
    painter.restore();
    text_area.setTop(text_area.top() + above + high + padding / 2);
    text_area.setBottom(text_area.bottom() - above);
  }
  painter.setFont(font(isChecked()));
  painter.setPen(colors::kInk);
  painter.drawText(text_area, kTextFlags, text());

  if (isChecked()) {
    const double tick = look_.mm(kTickMm);
    const QRectF badge(face.right() - tick - padding / 2, face.top() + padding / 2, tick, tick);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colors::kInk);
    painter.drawEllipse(badge);
    painter.setPen(Qt::white);
    drawTick(painter, badge, tick / 8);
  }
  if (isRinged(*this) || lit_) drawRing(painter, face, corner);
}

namespace {

constexpr double kChoiceWidestMm = 80;  // of a card
constexpr double kChoiceGapMm = 3;

/// The words `ids` on the scale, from the smallest force to the largest, and those apart from it.
std::vector<Answer> words(const std::vector<std::string>& ids, std::initializer_list<const char*> apart) {
  std::vector<Answer> answers;
  for (const std::string& term : ids) {
    const QString id = QString::fromStdString(term);
    const int level = static_cast<int>(answers.size()) + 1;
    answers.push_back({id, phrase(QStringLiteral("w.") + id), strengthPicture(level, static_cast<int>(ids.size()))});
  }
  for (const char* id : apart) {
    const QString text = QString::fromLatin1(id) == QStringLiteral("beyond_practice") ? QStringLiteral("beyond")
                                                                                      : QString::fromLatin1(id);
    answers.push_back({QString::fromLatin1(id), phrase(QStringLiteral("w.") + text), {}, true});
  }
  return answers;
}

}  // namespace

std::vector<Answer> forceWords(const Look& look) {
  std::vector<std::string> ids;
  for (const fuzzy::Term& term : look.about()->output.terms) ids.push_back(term.id);
  return words(ids, {"not_felt", "beyond_practice"});
}

std::vector<Answer> questionWords(const Look& look) {
  std::vector<std::string> ids;
  for (const study::AnswerWord& answer : look.form().answers) ids.push_back(answer.term);
  return words(ids, {"cant_tell"});
}

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

QString Choices::apart() const {
  const std::vector<AnswerCard*> cards = row(true);
  return cards.empty() ? QString() : cards.front()->id();
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

namespace {

constexpr int kTextPercents[] = {100, 125, 150};

}  // namespace

std::vector<Answer> languageAnswers(const std::vector<QString>& offered) {
  std::vector<Answer> answers;
  for (const QString& id : offered) answers.push_back({id, plain(languageName(id)), {}, false, Language{id}});
  return answers;
}

std::vector<Answer> sizeAnswers() {
  std::vector<Answer> answers;
  for (const int percent : kTextPercents) {
    const QString id = QString::number(percent);
    answers.push_back({id, phrase(QStringLiteral("wel.size_") + id), textSizePicture(percent)});
  }
  return answers;
}

}  // namespace tactus::workbench::nurse
