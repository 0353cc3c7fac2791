#include "app/workbench/participant/screens/review_screen.h"

#include <algorithm>
#include <array>

#include "app/workbench/participant/kit/column.h"

namespace tactus::workbench::nurse {
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
  connect(this, &ScreenFrame::primary, this, &ReviewScreen::press);
  connect(this, &ScreenFrame::back, this, [this] {
    if (page_ == 0) {
      emit left();
    } else {
      setPage(page_ - 1);
    }
  });
  setState({});
}

void ReviewScreen::setState(const ReviewState& state) {
  state_ = state;
  setSimulated(state.simulated);
  build();
}

void ReviewScreen::setPage(int page) {
  page_ = std::clamp(page, 0, kPages - 1);
  build();
}

int ReviewScreen::gaps() const {
  return static_cast<int>(std::count_if(state_.answers.begin(), state_.answers.end(),
                                        [](const ReviewAnswer& answer) { return answer.word.isEmpty(); }));
}

void ReviewScreen::press() {
  if (state_.sealed) {
    emit goOn();
  } else if (page_ + 1 < kPages) {
    setPage(page_ + 1);
  } else {
    emit seal();
  }
}

void ReviewScreen::build() {
  const bool last = page_ + 1 == kPages;
  setHint(state_.sealed ? Phrase{} : phrase(QStringLiteral("rev.tap")));
  ScreenFrame::setMayGoBack(!state_.sealed && (may_leave_ || page_ > 0));
  primaryButton().setPhrase(phrase(last && !state_.sealed ? QStringLiteral("nav.seal") : QStringLiteral("nav.next")));
  const bool waits = last && !state_.sealed && gaps() > 0;
  primaryButton().waitFor(waits ? std::optional(counted(QStringLiteral("rev.gaps"), gaps())) : std::nullopt);

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

void ReviewScreen::setMayGoBack(bool may) {
  may_leave_ = may;
  ScreenFrame::setMayGoBack(may || page_ > 0);
}

}  // namespace tactus::workbench::nurse
