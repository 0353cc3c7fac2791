#include "app/workbench/participant/screens/scale_screen.h"

#include <QGridLayout>

#include "app/workbench/participant/kit/button.h"
#include "app/workbench/participant/kit/look.h"
#include "app/workbench/participant/kit/participant_state.h"

namespace tactus::workbench::nurse {
namespace {

constexpr int kMostPoints = 7;

std::vector<Answer> pointAnswers(bool may_not_say) {
  std::vector<Answer> answers;
  for (int points = 1; points <= kMostPoints; ++points) {
    const QString id = QString::number(points);
    answers.push_back({id, plain(id)});
  }
  if (may_not_say) answers.push_back({QStringLiteral("not_say"), phrase(QStringLiteral("you.not_say")), {}, true});
  return answers;
}

}  // namespace

ScaleScreen::ScaleScreen(const Look& look, QWidget* parent)
    : ScreenFrame(look, parent),
      texts_(new TextBlock(look, this)),
      instructions_(texts_->add(TextRole::kBody, plain(QStringLiteral(" ")))),
      lead_(texts_->add(TextRole::kLead, plain(QStringLiteral(" ")))),
      low_(new Label(look, TextRole::kMuted, plain(QStringLiteral(" ")))),
      high_(new Label(look, TextRole::kMuted, plain(QStringLiteral(" ")))),
      choices_(new Choices(look)) {
  setMain(texts_);
  auto* scale = new QWidget(this);
  auto* grid = new QGridLayout(scale);
  keepSpacing(look, *grid, 0.5);
  for (Label* end : {low_, high_}) {
    end->setWordWrap(false);
    end->setContentsMargins(kRingRoom, 0, kRingRoom, 0);
  }
  grid->addWidget(low_, 0, 0, Qt::AlignLeft);
  grid->addWidget(high_, 0, 1, Qt::AlignRight);
  grid->addWidget(choices_, 1, 0, 1, 2);
  setAnswers(choices_, scale);
  primaryButton().setPhrase(phrase(QStringLiteral("nav.confirm")));
  primaryButton().reserve(phrase(QStringLiteral("err.points")));
}

void ScaleScreen::setState(const ParticipantState& state) {
  const ScaleState& asked = state.scale;
  const bool rating = state.screen == ParticipantScreen::kRating;
  setTitle(rating ? phrase(QStringLiteral("rate.title"))
                  : phrase(QStringLiteral("u.title"), {QString::number(asked.position), QString::number(asked.count)}));
  instructions_->setPhrase(rating ? Phrase{} : phrase(QStringLiteral("u.instructions")));
  instructions_->setVisible(!rating);
  lead_->setPhrase(phrase(asked.sentence));
  const QString ends = rating ? asked.sentence : QStringLiteral("u");
  low_->setPhrase(phrase(ends + QStringLiteral(".low")));
  high_->setPhrase(phrase(ends + QStringLiteral(".high")));
  choices_->setAnswers(pointAnswers(asked.may_not_say));
  choices_->choose(asked.chosen);
  // The last statement locks the answers.
  const bool seals = !rating && asked.position == asked.count;
  primaryButton().setPhrase(phrase(seals ? QStringLiteral("nav.seal") : QStringLiteral("nav.confirm")));
  primaryButton().waitFor(asked.chosen.isEmpty() ? std::optional(phrase(QStringLiteral("err.points"))) : std::nullopt);
  ScreenFrame::setState(state);
}

QString ScaleScreen::idOfKey(int key) const {
  QString points;
  if (key >= Qt::Key_1 && key < Qt::Key_1 + kMostPoints) points = QString::number(key - Qt::Key_0);
  if (key == Qt::Key_0) points = QStringLiteral("not_say");
  return choices_->offers(points) ? points : QString();
}

}  // namespace tactus::workbench::nurse
