#include "app/workbench/participant/screens/scale_screen.h"

#include <QGridLayout>
#include <QKeyEvent>

#include "app/workbench/participant/kit/button.h"
#include "app/workbench/participant/kit/look.h"

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
  setAnswers(scale);
  primaryButton().setPhrase(phrase(QStringLiteral("nav.confirm")));
  primaryButton().reserve(phrase(QStringLiteral("err.points")));
  connect(choices_, &Choices::picked, this, &ScaleScreen::picked);
  connect(this, &ScreenFrame::primary, this, &ScaleScreen::confirmed);
  setState({});
}

void ScaleScreen::setState(const ScaleState& state) {
  setTitle(state.title);
  instructions_->setPhrase(state.instructions);
  instructions_->setVisible(!state.instructions.isEmpty());
  lead_->setPhrase(state.sentence);
  low_->setPhrase(state.low);
  high_->setPhrase(state.high);
  choices_->setAnswers(pointAnswers(state.may_not_say));
  choices_->choose(state.chosen);
  primaryButton().setPhrase(phrase(state.is_last ? QStringLiteral("nav.seal") : QStringLiteral("nav.confirm")));
  primaryButton().waitFor(state.chosen.isEmpty() ? std::optional(phrase(QStringLiteral("err.points"))) : std::nullopt);
  setSimulated(state.simulated);
}

void ScaleScreen::keyPressEvent(QKeyEvent* event) {
  if (event->isAutoRepeat()) return;
  QString points;
  if (event->key() >= Qt::Key_1 && event->key() < Qt::Key_1 + kMostPoints) {
    points = QString::number(event->key() - Qt::Key_0);
  }
  if (event->key() == Qt::Key_0) points = QStringLiteral("not_say");
  if (points.isEmpty() || !choices_->offers(points)) return ScreenFrame::keyPressEvent(event);
  emit picked(points);
}

}  // namespace tactus::workbench::nurse
