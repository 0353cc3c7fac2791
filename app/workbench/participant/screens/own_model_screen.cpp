#include "app/workbench/participant/screens/own_model_screen.h"

#include <QKeyEvent>

namespace tactus::workbench::nurse {
namespace {

constexpr double kOwnPictureShare = 0.4;

}  // namespace

OwnModelScreen::OwnModelScreen(const Look& look, QWidget* parent)
    : ScreenFrame(look, parent),
      texts_(new TextBlock(look, this)),
      region_(texts_->add(TextRole::kLead, plain(QStringLiteral(" ")))),
      do_(nullptr),
      line_(nullptr),
      mark_(nullptr),
      choices_(new Choices(look, this)),
      picture_(new anatomy::AnatomyView(this)) {
  do_ = texts_->add(TextRole::kBody, phrase(QStringLiteral("for.do")));
  line_ = texts_->add(TextRole::kBody, phrase(QStringLiteral("own.line")));
  texts_->center();
  setTitle(phrase(QStringLiteral("own.title")));
  setMain(texts_, picture_, kOwnPictureShare);
  setAnswers(choices_);
  std::vector<Answer> answers;
  for (const char* id : {"lighter", "right", "heavier"})
    answers.push_back({QString::fromLatin1(id), phrase(QStringLiteral("own.") + QString::fromLatin1(id))});
  choices_->setAnswers(std::move(answers));
  mark_ = new Button(look, ButtonKind::kPlain, phrase(QStringLiteral("own.mark")), this);
  addExtra(mark_);
  primaryButton().reserve(phrase(QStringLiteral("err.choose")));
  connect(mark_, &QAbstractButton::clicked, this, &OwnModelScreen::marked);
  connect(choices_, &Choices::picked, this, &OwnModelScreen::picked);
  connect(this, &ScreenFrame::primary, this, [this] { emit confirmed(state_.region); });
  connect(&look, &Look::changed, this, &OwnModelScreen::show);
}

void OwnModelScreen::setState(const OwnModelState& state) {
  state_ = state;
  choices_->choose(state.chosen);
  const bool feels = state.ready && !state.unavailable;
  for (QWidget* widget : std::initializer_list<QWidget*>{do_, line_, choices_, mark_}) widget->setVisible(feels);
  primaryButton().setVisible(feels || state.unavailable);
  primaryButton().waitFor(feels && state.chosen.isEmpty() ? std::optional(phrase(QStringLiteral("err.choose")))
                                                          : std::nullopt);
  picture_->setMirrored(state.left_handed);
  setFreeHandLeft(!state.left_handed);
  setSimulated(state.simulated);
  show();
}

void OwnModelScreen::setDepth(std::optional<double> depth_mm) { picture_->setDepth(depth_mm); }

void OwnModelScreen::show() {
  if (state_.unavailable || !state_.ready) {
    region_->setPhrase(phrase(state_.unavailable ? QStringLiteral("own.none") : QStringLiteral("dev.wait")));
    picture_->light(std::nullopt);
    return;
  }
  const auto region = anatomy::regionWithId(state_.region.toStdString());
  if (!region) return;
  region_->setPhrase(phrase(QStringLiteral("a.") + state_.region));
  picture_->setFont(look().font());
  picture_->setFraming(*region == anatomy::Region::kEsophagus ? anatomy::Framing::kWhole : anatomy::Framing::kThroat);
  picture_->light(*region, region_->text());
  picture_->setAccessibleName(look().say(phrase(QStringLiteral("acc.way"))));
}

void OwnModelScreen::keyPressEvent(QKeyEvent* event) {
  if (event->isAutoRepeat()) return;
  const QString comparison =
      event->key() >= Qt::Key_1 && event->key() <= Qt::Key_3 ? choices_->onScale(event->key() - Qt::Key_0) : QString();
  if (comparison.isEmpty()) return ScreenFrame::keyPressEvent(event);
  emit picked(comparison);
}

}  // namespace tactus::workbench::nurse
