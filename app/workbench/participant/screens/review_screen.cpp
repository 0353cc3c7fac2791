#include "app/workbench/participant/screens/review_screen.h"

#include <QPainter>
#include <algorithm>
#include <array>

#include "app/workbench/participant/kit/button.h"
#include "app/workbench/participant/kit/look.h"
#include "app/workbench/participant/kit/pictures.h"

namespace tactus::workbench::nurse {
namespace {

constexpr int kPulseMs = 1600;
constexpr double kCellPictureMm = 10;
constexpr double kCellPaddingMm = 2.5;
constexpr double kCellCornerMm = 1.5;

int strengthOf(const QString& word) {
  int level = 0;
  for (const char* id : {"very_small", "small", "medium", "large", "very_large"}) {
    ++level;
    if (word == QLatin1String(id)) return level;
  }
  return 0;
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
  const int level = strengthOf(word_);
  QRectF text_area = face.adjusted(padding, 0, -padding, 0);
  if (level > 0) {
    const double wide = look_.mm(kCellPictureMm);
    strengthPicture(level)(painter, QRectF(text_area.left(), face.center().y() - wide / 3, wide, wide * 2 / 3));
    text_area.setLeft(text_area.left() + wide + padding);
  }
  painter.setFont(look_.font());
  painter.setPen(colors::kInk);
  painter.drawText(text_area, (level > 0 ? Qt::AlignLeft : Qt::AlignHCenter) | Qt::AlignVCenter, text());
  if (isRinged(*this)) drawRing(painter, face, corner);
}

namespace {

struct Condition {
  const char* id;
  std::array<const char*, 3> terms;
};

constexpr std::array kConditions = {Condition{"lubrication", {"poor", "medium", "well"}},
                                    Condition{"neck_flexion", {"small", "medium", "large"}},
                                    Condition{"speed", {"slow", "medium", "fast"}}};
constexpr std::array kRegionIds = {"nasal_cavity", "nasopharynx", "oropharynx", "laryngopharynx", "esophagus"};
constexpr int kPages = static_cast<int>(kConditions.size());

QString text(const char* id) { return QString::fromLatin1(id); }

}  // namespace

ReviewScreen::ReviewScreen(const Look& look, QWidget* parent) : ScreenFrame(look, parent) {
  setTitle(phrase(QStringLiteral("rev.title")));
  primaryButton().reserve(phrase(QStringLiteral("nav.seal")));
  setState({});
}

void ReviewScreen::setState(const ParticipantState& state) {
  state_ = state.review;
  build();
  ScreenFrame::setState(state);
}

void ReviewScreen::setPage(int page) {
  page_ = std::clamp(page, 0, kPages - 1);
  build();
}

bool ReviewScreen::turnPage(int by) {
  if (state_.sealed || page_ + by < 0 || page_ + by >= kPages) return false;
  setPage(page_ + by);
  return true;
}

void ReviewScreen::build() {
  const bool last = page_ + 1 == kPages;
  setHint(state_.sealed ? Phrase{} : phrase(QStringLiteral("rev.tap")));
  showBack();
  primaryButton().setPhrase(phrase(last && !state_.sealed ? QStringLiteral("nav.seal") : QStringLiteral("nav.next")));
  const bool waits = last && !state_.sealed && state_.gaps > 0;
  primaryButton().waitFor(waits ? std::optional(counted(QStringLiteral("rev.gaps"), state_.gaps)) : std::nullopt);

  delete page_widget_;
  page_widget_ = new QWidget(this);
  auto* grid = new QGridLayout(page_widget_);
  keepSpacing(look(), *grid, 0);
  if (state_.sealed) {
    grid->addWidget(new Label(look(), TextRole::kLead, phrase(QStringLiteral("rev.sealed")), page_widget_));
  } else {
    const Condition& condition = kConditions[static_cast<std::size_t>(page_)];
    const QString id = text(condition.id);
    grid->addWidget(new Label(look(), TextRole::kLead, phrase(QStringLiteral("s.") + id), page_widget_), 0, 0, 1, 1);
    for (int column = 0; column < 3; ++column) {
      const QString term = text(condition.terms[static_cast<std::size_t>(column)]);
      auto* head = new Label(look(), TextRole::kTitle, phrase(QStringLiteral("s.%1.%2").arg(id, term)), page_widget_);
      head->setAlignment(Qt::AlignCenter);
      grid->addWidget(head, 0, column + 1);
      grid->setColumnStretch(column + 1, 1);
      for (int row = 0; row < static_cast<int>(kRegionIds.size()); ++row) {
        const QString region = text(kRegionIds[static_cast<std::size_t>(row)]);
        const auto found = std::find_if(state_.answers.begin(), state_.answers.end(), [&](const ReviewAnswer& answer) {
          return answer.condition == id && answer.term == term && answer.region == region;
        });
        if (column == 0) {
          auto* name = new Label(look(), TextRole::kBody, phrase(QStringLiteral("a.") + region), page_widget_);
          name->setWordWrap(false);
          name->setContentsMargins(0, 0, look().gap(2), 0);
          grid->addWidget(name, row + 1, 0);
          grid->setRowStretch(row + 1, 1);
        }
        if (found == state_.answers.end()) continue;
        auto* cell = new ReviewCell(look(), found->item, page_widget_);
        cell->setAnswer(found->word, look().say(phrase(QStringLiteral("s.%1.%2").arg(id, term))) +
                                         QStringLiteral(", ") + look().say(phrase(QStringLiteral("a.") + region)));
        connect(cell, &QAbstractButton::clicked, this, [this, cell] { emit cellPicked(cell->item()); });
        grid->addWidget(cell, row + 1, column + 1);
      }
    }
  }
  setMain(page_widget_);
  page_widget_->show();
}

}  // namespace tactus::workbench::nurse
