#include "app/workbench/participant/screens/own_model_screen.h"

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
      picture_(anatomy::makeBodyView(look.about(), this)) {
  do_ = texts_->add(TextRole::kBody, phrase(QStringLiteral("for.do")));
  line_ = texts_->add(TextRole::kBody, phrase(QStringLiteral("own.line")));
  texts_->center();
  setTitle(phrase(QStringLiteral("own.title")));
  setMain(texts_, picture_, kOwnPictureShare);
  setAnswers(choices_);
  std::vector<Answer> answers;
  for (const char* id : {"lighter", "right", "heavier", "cant_tell"})
    answers.push_back({QString::fromLatin1(id),
                       phrase(QStringLiteral("own.") + QString::fromLatin1(id)),
                       {},
                       qstrcmp(id, "cant_tell") == 0});
  choices_->setAnswers(std::move(answers));
  mark_ = new Button(look, ButtonKind::kPlain, phrase(QStringLiteral("own.mark")), this);
  addExtra(mark_);
  primaryButton().reserve(phrase(QStringLiteral("own.push")));
  connect(mark_, &QAbstractButton::clicked, this, &OwnModelScreen::marked);
  connect(&look, &Look::changed, this, &OwnModelScreen::show);
}

void OwnModelScreen::setState(const ParticipantState& state) {
  state_ = state.own;
  const bool unavailable = !state_.unavailable.isEmpty();
  choices_->choose(state_.chosen);
  const bool feels = state_.ready && !unavailable;
  for (QWidget* widget : std::initializer_list<QWidget*>{do_, line_, choices_, mark_}) widget->setVisible(feels);
  primaryButton().setVisible(feels || unavailable);
  const QString missing = state_.felt ? QStringLiteral("err.choose") : QStringLiteral("own.push");
  primaryButton().waitFor(feels && state_.chosen.isEmpty() ? std::optional(phrase(missing)) : std::nullopt);
  picture_->setMirrored(state.left_handed);
  setFreeHandLeft(!state.left_handed);
  show();
  ScreenFrame::setState(state);
}

void OwnModelScreen::setDepth(std::optional<double> depth_mm) { picture_->setDepth(depth_mm); }

void OwnModelScreen::show() {
  if (!state_.unavailable.isEmpty() || !state_.ready) {
    region_->setPhrase(phrase(!state_.unavailable.isEmpty() ? QStringLiteral("own.none") : QStringLiteral("dev.wait")));
    picture_->lightRegion({});
    return;
  }
  region_->setPhrase(phrase(QStringLiteral("a.") + state_.region));
  picture_->setFont(look().font());
  picture_->setRegionNames(regionNames(look()));
  picture_->lightRegion(state_.region);
  picture_->setAccessibleName(look().say(phrase(QStringLiteral("acc.way"))));
}

QString OwnModelScreen::idOfKey(int key) const {
  if (key == Qt::Key_0) return QStringLiteral("cant_tell");
  return key >= Qt::Key_1 && key <= Qt::Key_3 ? choices_->onScale(key - Qt::Key_0) : QString();
}

}  // namespace tactus::workbench::nurse
