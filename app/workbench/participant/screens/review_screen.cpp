#include "app/workbench/participant/screens/review_screen.h"

#include <QPainter>
#include <algorithm>
#include <cstddef>
#include <utility>

#include "app/workbench/participant/kit/button.h"
#include "app/workbench/participant/kit/look.h"
#include "app/workbench/participant/kit/pictures.h"

namespace tactus::workbench::nurse {
namespace {

constexpr int kPulseMs = 1600;
constexpr double kCellPictureMm = 10;
constexpr double kCellPaddingMm = 2.5;
constexpr double kCellCornerMm = 1.5;

/// The place of a word of the force on its scale, from 1; 0: not on it.
int strengthOf(const std::vector<fuzzy::Term>& words, const QString& word) {
  const auto found =
      std::find_if(words.begin(), words.end(), [&](const auto& one) { return word == QString::fromStdString(one.id); });
  return found == words.end() ? 0 : static_cast<int>(found - words.begin()) + 1;
}

}  // namespace

ReviewCell::ReviewCell(const Look& look, int item, QWidget* parent)
    : QAbstractButton(parent), look_(look), item_(item) {
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  pulse_.setDuration(kPulseMs);
  pulse_.setKeyValueAt(0, 0.0);
  pulse_.setKeyValueAt(0.5, 1.0);
  pulse_.setKeyValueAt(1, 0.0);
  pulse_.setLoopCount(-1);
  connect(&pulse_, &QVariantAnimation::valueChanged, this, [this](const QVariant& value) {
    glow_ = value.toDouble();
    update();
  });
  connect(&look, &Look::changed, this, &ReviewCell::refreshState);
}

void ReviewCell::setAnswer(const QString& word, const QString& situation) {
  word_ = word;
  situation_ = situation;
  refreshState();
}

void ReviewCell::refreshState() {
  setText(word_.isEmpty() ? QString() : look_.say(phrase(QStringLiteral("w.") + word_)));
  setAccessibleName(word_.isEmpty() ? look_.say(phrase(QStringLiteral("acc.open"), {situation_}))
                                    : situation_ + QStringLiteral(": ") + text());
  const bool pulses = word_.isEmpty() && isVisible();
  if (pulses && pulse_.state() != QAbstractAnimation::Running) pulse_.start();
  if (!pulses) pulse_.stop();
  updateGeometry();
  update();
}

void ReviewCell::showEvent(QShowEvent* /*event*/) { refreshState(); }
void ReviewCell::hideEvent(QHideEvent* /*event*/) { pulse_.stop(); }

QSize ReviewCell::sizeHint() const {
  const QFontMetrics metrics(look_.font());
  return {look_.mm(30), metrics.height() + 2 * kRingRoom + look_.mm(1)};
}

bool ReviewCell::hitButton(const QPoint& at) const {
  return isDown() ? endsNear(look_, *this, at) : rect().contains(at);
}

void ReviewCell::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF face = faceOf(size());
  const double corner = look_.mm(kCellCornerMm);
  const double padding = look_.mm(kCellPaddingMm);
  const bool open = word_.isEmpty();
  painter.setPen(open ? QPen(colors::kInk, 2 + 2 * glow_, Qt::DashLine) : QPen(colors::kEdge, 1.5));
  painter.setBrush(isDown() ? colors::kChosen : colors::kCard);
  painter.drawRoundedRect(face.adjusted(1, 1, -1, -1), corner, corner);
  const auto& words = look_.about()->output.terms;
  const int level = strengthOf(words, word_);
  QRectF text_area = face.adjusted(padding, 0, -padding, 0);
  const double wide = look_.mm(kCellPictureMm);
  // In a narrow cell the word stands alone.
  const bool drawn =
      level > 0 && wide + padding + QFontMetricsF(look_.font()).horizontalAdvance(text()) <= text_area.width();
  if (drawn) {
    strengthPicture(level, static_cast<int>(words.size()))(
        painter, QRectF(text_area.left(), face.center().y() - wide / 3, wide, wide * 2 / 3));
    text_area.setLeft(text_area.left() + wide + padding);
  }
  painter.setFont(look_.font());
  painter.setPen(colors::kInk);
  painter.drawText(text_area, (drawn ? Qt::AlignLeft : Qt::AlignHCenter) | Qt::AlignVCenter | Qt::TextWordWrap, text());
  if (isRinged(*this)) drawRing(painter, face, corner);
}

namespace {

constexpr int kMostRows = 7;

/// The order of the inputs and of their words is that of the procedure.
std::size_t placeOf(const procedure::Procedure& procedure, const std::string& input) {
  const auto& inputs = procedure.inputs;
  return static_cast<std::size_t>(
      std::find_if(inputs.begin(), inputs.end(), [&](const auto& one) { return one.id == input; }) - inputs.begin());
}

std::vector<study::ItemCondition> inOrder(const procedure::Procedure& procedure,
                                          std::vector<study::ItemCondition> conditions) {
  std::stable_sort(conditions.begin(), conditions.end(), [&](const auto& a, const auto& b) {
    return placeOf(procedure, a.input) < placeOf(procedure, b.input);
  });
  return conditions;
}

/// What an answer has in common with those on its page, and its column.
struct Place {
  std::vector<study::ItemCondition> fixed;
  study::ItemCondition column;
};

Place placeOf(const procedure::Procedure& procedure, const ReviewAnswer& answer) {
  Place out{inOrder(procedure, answer.conditions), {}};
  if (out.fixed.empty()) return out;
  out.column = out.fixed.back();
  out.fixed.pop_back();
  return out;
}

template <class Value>
void addOnce(std::vector<Value>& all, const Value& value) {
  if (std::find(all.begin(), all.end(), value) == all.end()) all.push_back(value);
}

/// The values of `all` in the order of `terms`; what is none of them comes first.
template <class Value, class Name>
void sortBy(std::vector<Value>& all, const std::vector<fuzzy::Term>& terms, const Name& name) {
  const auto place = [&](const Value& value) {
    const auto found = std::find_if(terms.begin(), terms.end(), [&](const auto& term) { return name(term) == value; });
    return found == terms.end() ? std::ptrdiff_t{-1} : found - terms.begin();
  };
  std::stable_sort(all.begin(), all.end(), [&](const Value& a, const Value& b) { return place(a) < place(b); });
}

/// `page` with as many rows as there is room for, again and again.
void addInParts(ReviewPage page, std::vector<ReviewPage>& out) {
  const std::vector<QString> rows = std::move(page.regions);
  const std::size_t parts = (rows.size() + kMostRows - 1) / kMostRows;
  for (std::size_t part = 0; part < parts; ++part) {
    const auto from = static_cast<std::ptrdiff_t>(rows.size() * part / parts);
    const auto to = static_cast<std::ptrdiff_t>(rows.size() * (part + 1) / parts);
    page.regions.assign(rows.begin() + from, rows.begin() + to);
    out.push_back(page);
  }
}

}  // namespace

const ReviewAnswer* ReviewPage::answer(const std::vector<ReviewAnswer>& answers, std::size_t row,
                                       std::size_t column) const {
  auto wanted = fixed;
  if (!input.empty()) wanted.push_back({input, terms[column]});
  const auto found = std::find_if(answers.begin(), answers.end(), [&](const ReviewAnswer& answer) {
    return answer.region == regions[row] &&
           std::is_permutation(answer.conditions.begin(), answer.conditions.end(), wanted.begin(), wanted.end());
  });
  return found == answers.end() ? nullptr : &*found;
}

std::vector<ReviewPage> reviewPages(const procedure::Procedure& procedure, const study::Form& form,
                                    const std::vector<ReviewAnswer>& answers) {
  std::vector<ReviewPage> whole;
  for (const ReviewAnswer& answer : answers) {
    const Place place = placeOf(procedure, answer);
    auto page = std::find_if(whole.begin(), whole.end(), [&](const ReviewPage& one) {
      return one.fixed == place.fixed && one.input == place.column.input;
    });
    if (page == whole.end()) page = whole.insert(page, ReviewPage{place.fixed, place.column.input, {}, {}});
    addOnce(page->terms, place.column.term);
    addOnce(page->regions, answer.region);
  }
  const procedure::TermSet* const regions = procedure.wayTerms(form.depth_terms);
  std::vector<ReviewPage> out;
  for (ReviewPage& page : whole) {
    if (const std::size_t at = placeOf(procedure, page.input); at < procedure.inputs.size())
      sortBy(page.terms, procedure.inputs[at].terms, [](const fuzzy::Term& term) { return term.id; });
    if (regions != nullptr)
      sortBy(page.regions, regions->terms, [](const fuzzy::Term& term) { return QString::fromStdString(term.id); });
    addInParts(std::move(page), out);
  }
  return out;
}

ReviewScreen::ReviewScreen(const Look& look, QWidget* parent) : ScreenFrame(look, parent) {
  setTitle(phrase(QStringLiteral("rev.title")));
  primaryButton().reserve(phrase(QStringLiteral("nav.seal")));
  setState({});
}

void ReviewScreen::setState(const ParticipantState& state) {
  state_ = state.review;
  pages_ = reviewPages(*look().about(), look().form(), state_.answers);
  if (!pages_.empty()) page_ = std::min(page_, static_cast<int>(pages_.size()) - 1);
  build();
  ScreenFrame::setState(state);
}

// Before the answers are there any page may be meant.
void ReviewScreen::setPage(int page) {
  const int last = static_cast<int>(pages_.size()) - 1;
  page_ = std::clamp(page, 0, pages_.empty() ? std::max(page, 0) : last);
  build();
}

bool ReviewScreen::turnPage(int by) {
  const int page = page_ + by;
  if (state_.sealed || page < 0 || page >= static_cast<int>(pages_.size())) return false;
  setPage(page);
  return true;
}

void ReviewScreen::build() {
  setHint(state_.sealed ? Phrase{} : phrase(QStringLiteral("rev.tap")));
  showBack();
  primaryButton().setPhrase(
      phrase(isLast() && !state_.sealed ? QStringLiteral("nav.seal") : QStringLiteral("nav.next")));
  const bool waits = isLast() && !state_.sealed && state_.gaps > 0;
  primaryButton().waitFor(waits ? std::optional(counted(QStringLiteral("rev.gaps"), state_.gaps)) : std::nullopt);

  delete page_widget_;
  page_widget_ = new QWidget(this);
  auto* grid = new QGridLayout(page_widget_);
  keepSpacing(look(), *grid, 0);
  if (state_.sealed) {
    grid->addWidget(new Label(look(), TextRole::kLead, phrase(QStringLiteral("rev.sealed")), page_widget_));
  } else if (page_ < static_cast<int>(pages_.size())) {
    fill(*grid, pages_[static_cast<std::size_t>(page_)]);
  }
  setMain(page_widget_);
  page_widget_->show();
}

// The condition, its words beside each other, and the regions below it.
void ReviewScreen::fill(QGridLayout& grid, const ReviewPage& page) {
  const auto termId = [](const std::string& input, const std::string& term) {
    return phrase(QStringLiteral("s.%1.%2").arg(QString::fromStdString(input), QString::fromStdString(term)));
  };
  QStringList title;
  for (const auto& [input, term] : page.fixed)
    title << look().say(phrase(QStringLiteral("s.") + QString::fromStdString(input))) + QStringLiteral(": ") +
                 look().say(termId(input, term));
  Phrase head = phrase(QStringLiteral("s.") + QString::fromStdString(page.input));
  if (page.input.empty()) head = plain(QStringLiteral(" "));
  if (!title.isEmpty()) head = plain(title.join(QStringLiteral(", ")) + QLatin1Char('\n') + look().say(head));
  grid.addWidget(new Label(look(), TextRole::kLead, head, page_widget_), 0, 0, 1, 1);
  for (std::size_t column = 0; column < page.terms.size(); ++column) {
    const int at = static_cast<int>(column) + 1;
    grid.setColumnStretch(at, 1);
    QString situation;
    if (!page.input.empty()) {
      const Phrase word = termId(page.input, page.terms[column]);
      auto* name = new Label(look(), TextRole::kTitle, word, page_widget_);
      name->setAlignment(Qt::AlignCenter);
      grid.addWidget(name, 0, at);
      situation = look().say(word) + QStringLiteral(", ");
    }
    for (std::size_t row = 0; row < page.regions.size(); ++row) {
      const ReviewAnswer* const answer = page.answer(state_.answers, row, column);
      if (answer == nullptr) continue;
      auto* cell = new ReviewCell(look(), answer->item, page_widget_);
      cell->setAnswer(answer->word, situation + nameOf(page.regions[row]));
      connect(cell, &QAbstractButton::clicked, this, [this, cell] { emit cellPicked(cell->item()); });
      grid.addWidget(cell, static_cast<int>(row) + 1, at);
    }
  }
  for (std::size_t row = 0; row < page.regions.size(); ++row) {
    auto* name = new Label(look(), TextRole::kBody, plain(nameOf(page.regions[row])), page_widget_);
    name->setWordWrap(false);
    name->setContentsMargins(0, 0, look().gap(2), 0);
    grid.addWidget(name, static_cast<int>(row) + 1, 0);
    grid.setRowStretch(static_cast<int>(row) + 1, 1);
  }
}

QString ReviewScreen::nameOf(const QString& region) const {
  return region.isEmpty() ? QString() : look().say(phrase(QStringLiteral("a.") + region));
}

}  // namespace tactus::workbench::nurse
