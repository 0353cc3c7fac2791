#include "app/workbench/participant/screens/arrival_screens.h"

#include <QPainter>

#include "app/workbench/participant/kit/button.h"
#include "app/workbench/participant/kit/look.h"
#include "app/workbench/participant/kit/participant_state.h"

namespace tactus::workbench::nurse {
namespace {

constexpr double kCardWidthMm = 130;
constexpr double kCardHeightMm = 20;
constexpr double kCardCornerMm = 2;
constexpr double kCardPaddingMm = 4;
constexpr int kLongest = 40;  // characters of a code

}  // namespace

CodeField::CodeField(const Look& look, QWidget* parent) : QWidget(parent), look_(look), edit_(new QLineEdit(this)) {
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  setFocusProxy(edit_);
  edit_->setFrame(false);
  edit_->setMaxLength(kLongest);
  // Menus are windows of their own, above the button that stops the force.
  edit_->setContextMenuPolicy(Qt::NoContextMenu);
  edit_->setInputMethodHints(Qt::ImhNoPredictiveText | Qt::ImhLatinOnly | Qt::ImhNoAutoUppercase);
  connect(edit_, &QLineEdit::textEdited, this, &CodeField::edited);
  connect(edit_, &QLineEdit::returnPressed, this, &CodeField::entered);
  connect(&look, &Look::changed, this, &CodeField::refreshState);
  refreshState();
}

void CodeField::refreshState() {
  edit_->setFont(look_.font());
  edit_->setAccessibleName(look_.say(phrase(QStringLiteral("code.field"))));
  updateGeometry();
}

QSize CodeField::sizeHint() const {
  return QSize(look_.mm(kCardWidthMm), look_.mm(kCardHeightMm)) + QSize(2 * kRingRoom, 2 * kRingRoom);
}

void CodeField::resizeEvent(QResizeEvent* /*event*/) {
  const int padding = kRingRoom + look_.mm(kCardPaddingMm);
  edit_->setGeometry(rect().adjusted(padding, kRingRoom + 3, -padding, -kRingRoom - 3));
}

void CodeField::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF face = faceOf(size());
  painter.setPen(QPen(colors::kEdge, 1.5));
  painter.setBrush(colors::kCard);
  painter.drawRoundedRect(face, look_.mm(kCardCornerMm), look_.mm(kCardCornerMm));
  if (edit_->hasFocus()) drawRing(painter, face, look_.mm(kCardCornerMm));
}

namespace {

/// What is kept of an earlier visit, in the words of the part in which it ended.
Phrase keptOf(const WelcomeState& welcome) {
  if (welcome.kept_forces > 0)
    return phrase(QStringLiteral("code.back_forces"), {QString::number(welcome.kept_forces)});
  if (welcome.kept_strokes > 0 && welcome.all_strokes > 0) {
    return phrase(QStringLiteral("code.back_strokes"),
                  {QString::number(welcome.kept_strokes), QString::number(welcome.all_strokes)});
  }
  return counted(QStringLiteral("code.back"), welcome.kept_answers);
}

}  // namespace

WelcomeScreen::WelcomeScreen(const Look& look, QWidget* parent)
    : ScreenFrame(look, parent),
      texts_(new TextBlock(look, this)),
      line_(
          texts_->add(TextRole::kBody, phrase(QStringLiteral("wel.line"), {QString::number(state_.welcome.minutes)}))),
      language_title_(texts_->add(TextRole::kTitle, phrase(QStringLiteral("wel.language")))),
      languages_(new Choices(look, texts_)),
      size_title_(nullptr),
      sizes_(new Choices(look, texts_)),
      lead_(nullptr),
      field_(new CodeField(look, texts_)),
      unknown_(nullptr),
      meant_(new Button(look, ButtonKind::kPlain, plain(QStringLiteral(" ")), this)),
      have_code_(new Button(look, ButtonKind::kPlain, phrase(QStringLiteral("code.have")), this)),
      teach_(new Button(look, ButtonKind::kPlain, phrase(QStringLiteral("u.begin")), this)) {
  setTitle(phrase(QStringLiteral("wel.title")));
  texts_->add(languages_);
  size_title_ = texts_->add(TextRole::kTitle, phrase(QStringLiteral("wel.text_size")));
  texts_->add(sizes_);
  lead_ = texts_->add(TextRole::kLead, phrase(QStringLiteral("code.enter")));
  texts_->add(field_);
  unknown_ = texts_->add(TextRole::kBody, phrase(QStringLiteral("code.unknown")));
  texts_->center();
  setMain(texts_);
  for (Button* button : {have_code_, teach_, meant_}) addExtra(button);
  sizes_->setAnswers(sizeAnswers());

  connect(languages_, &Choices::picked, this, &WelcomeScreen::languagePicked);
  connect(sizes_, &Choices::picked, this, [this](const QString& id) { emit textSizePicked(id.toInt()); });
  connect(have_code_, &QAbstractButton::clicked, this, &WelcomeScreen::enterCode);
  connect(teach_, &QAbstractButton::clicked, this, &WelcomeScreen::teacherHere);
  connect(meant_, &QAbstractButton::clicked, this, [this] { emit codeEntered(state_.welcome.meant); });
  connect(field_, &CodeField::entered, this, [this] { turnPage(1); });
  connect(&look, &Look::changed, this, &WelcomeScreen::showChoices);
  setState({});
}

void WelcomeScreen::showChoices() {
  languages_->choose(look().language().id);
  sizes_->choose(QString::number(look().textPercent()));
}

void WelcomeScreen::setState(const ParticipantState& state) {
  state_ = state;
  ScreenFrame::setState(state);
  show();
}

void WelcomeScreen::enterCode() {
  has_code_ = true;
  show();
  field_->takeFocus();
}

void WelcomeScreen::show() {
  using Step = WelcomeState::Step;
  const WelcomeState& welcome = state_.welcome;
  const bool start = welcome.step == Step::kStart && !has_code_;
  // Who is prepared by the researcher, or comes back, chooses here how she reads.
  const bool reads = start || welcome.prepared || welcome.step == Step::kWelcomeBack;
  line_->setPhrase(phrase(QStringLiteral("wel.line"), {QString::number(welcome.minutes)}));
  line_->setVisible(start);
  for (QWidget* widget : std::initializer_list<QWidget*>{size_title_, sizes_}) widget->setVisible(reads);
  for (QWidget* widget : std::initializer_list<QWidget*>{have_code_, teach_})
    widget->setVisible(start && !welcome.prepared);
  languages_->setAnswers(languageAnswers(state_.languages));
  // With one alone nothing is to be chosen.
  for (QWidget* widget : std::initializer_list<QWidget*>{language_title_, languages_})
    widget->setVisible(reads && state_.languages.size() > 1);
  showChoices();
  lead_->setVisible(!start);
  if (welcome.step == Step::kNewCode) lead_->setPhrase(phrase(QStringLiteral("code.yours"), {state_.code}));
  if (asksForCode()) lead_->setPhrase(phrase(QStringLiteral("code.enter")));
  if (welcome.step == Step::kNewCode && welcome.prepared)
    lead_->setPhrase(phrase(QStringLiteral("code.part"), {state_.code}));
  if (welcome.step == Step::kWelcomeBack) lead_->setPhrase(keptOf(welcome));
  field_->setVisible(asksForCode());
  unknown_->setVisible(asksForCode() && welcome.code_unknown);
  meant_->setPhrase(phrase(QStringLiteral("code.meant"), {welcome.meant}));
  meant_->setVisible(!welcome.meant.isEmpty() && !unknown_->isHidden());
  primaryButton().setPhrase(
      phrase(start && !welcome.prepared ? QStringLiteral("code.new") : QStringLiteral("nav.next")));
  // The prepared participant is being looked up.
  primaryButton().setVisible(!(start && welcome.prepared));
  showBack();
}

bool WelcomeScreen::turnPage(int by) {
  const bool asks = asksForCode();
  if (by < 0) {
    has_code_ = false;
    if (asks) show();
    return asks;
  }
  if (asks) {
    if (!field_->code().isEmpty()) emit codeEntered(field_->code());
    return true;
  }
  if (state_.welcome.step != WelcomeState::Step::kStart) return false;
  emit newHere();
  return true;
}

ConsentScreen::ConsentScreen(const Look& look, QWidget* parent)
    : ScreenFrame(look, parent), text_(new PagedText(look, this)) {
  setTitle(phrase(QStringLiteral("con.title")));
  setMain(text_);
  // The room for the text is the same on each page.
  primaryButton().reserve(phrase(QStringLiteral("con.agree")));
  auto* decline = new Button(look, ButtonKind::kPlain, phrase(QStringLiteral("con.decline")), this);
  addExtra(decline);
  connect(decline, &QAbstractButton::clicked, this, &ConsentScreen::declined);
  connect(text_, &PagedText::paged, this, &ConsentScreen::showPage);
  setState({});
}

void ConsentScreen::setState(const ParticipantState& state) {
  text_->setParagraphs(state.consent.paragraphs);
  ScreenFrame::setState(state);
}

bool ConsentScreen::turnPage(int by) {
  const int page = text_->page() + by;
  if (page < 0 || page >= text_->pages()) return false;
  text_->setPage(page);
  return true;
}

void ConsentScreen::showPage() {
  const bool last = text_->page() + 1 >= text_->pages();
  showBack();
  primaryButton().setPhrase(phrase(last ? QStringLiteral("con.agree") : QStringLiteral("nav.next")));
}

}  // namespace tactus::workbench::nurse
