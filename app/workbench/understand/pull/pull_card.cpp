#include "app/workbench/understand/pull/pull_card.h"

#include <QAbstractButton>
#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <functional>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/kit/buttons.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/kit/number_box.h"
#include "app/workbench/model/scene_controller.h"

namespace tactus::workbench {
namespace {

constexpr int kCharacters = 64;  // of a line of the card
constexpr int kBesidePull = 28;  // px between the place and the card
constexpr double kForceStep = 0.01;
constexpr int kMean = -1;   // in the place of an expert
constexpr int kAPoint = 0;  // entries of the choice of what is pulled
constexpr int kABand = 1;
constexpr int kReferences = 2;

QLabel* makeText(const QFont& font, bool muted) {
  auto* label = new QLabel;
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  label->setFont(font);
  if (muted) setInk(*label, theme::mutedInk());
  label->setForegroundRole(QPalette::WindowText);  // inside a button, too
  // A press belongs to the offer around it.
  label->setAttribute(Qt::WA_TransparentForMouseEvents);
  return label;
}

/// One edit to choose.
class OfferButton : public QAbstractButton {
 public:
  OfferButton(const PullOffer& offer, const QString& folded, std::function<void()> pointed_at)
      : pointed_at_(std::move(pointed_at)) {
    setCheckable(true);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::PointingHandCursor);
    setAttribute(Qt::WA_Hover);
    QString said = offer.what;
    said[0] = said[0].toUpper();
    auto* what = makeText(theme::headingFont(), false);
    what->setText(said);
    auto* price = makeText(theme::smallFont(), true);
    price->setText(offer.folded ? folded + QLatin1Char(' ') + offer.price : offer.price);
    auto* column = makeColumn(this, {what, price}, theme::kGrid / 4, inset(theme::kGrid, theme::kGrid * 3 / 4));
    for (const QString& note : offer.notes) {
      auto* line = makeText(theme::smallFont(), false);
      setInk(*line, theme::warningInk());
      line->setText(note);
      column->addWidget(line);
    }
    setText(said);
    setAccessibleName(said);
    setAccessibleDescription(price->text() + QLatin1Char(' ') + offer.notes.join(QLatin1Char(' ')));
  }

  QSize sizeHint() const override { return layout()->sizeHint(); }

 protected:
  void enterEvent(QEnterEvent* event) override {
    pointed_at_();
    QAbstractButton::enterEvent(event);
  }

  void paintEvent(QPaintEvent* /*event*/) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(isChecked() ? theme::accent() : theme::border(), isChecked() ? 2 : 1));
    painter.setBrush(isChecked() ? theme::window() : theme::card());
    const QRectF box = QRectF(rect()).adjusted(1, 1, -1, -1);
    painter.drawRoundedRect(box, theme::kCornerRadius, theme::kCornerRadius);
    if (!hasFocus()) return;
    painter.setPen(QPen(theme::accent(), 1, Qt::DotLine));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(box.adjusted(3, 3, -3, -3), theme::kCornerRadius - 2, theme::kCornerRadius - 2);
  }

 private:
  std::function<void()> pointed_at_;
};

}  // namespace

PullCard::PullCard(PullController& pull, std::vector<PullWish> references, QWidget& window)
    : Card(&window),
      pull_(pull),
      references_(std::move(references)),
      window_(window),
      who_(new QComboBox(this)),
      kind_(new QComboBox(this)),
      now_(new QLabel(this)),
      point_row_(makePointRow()),
      band_row_(makeBandRow()),
      sentence_(makeText(theme::smallFont(), true)),
      choice_(new QButtonGroup(this)),
      all_(new QCheckBox(this)),
      hint_(makeText(theme::smallFont(), true)),
      warning_(makeText(theme::smallFont(), false)),
      pin_row_(makePinRow()),
      take_(new PrimaryButton(tr("Make this edit"), this)) {
  setAccessibleName(tr("Pull the force"));
  const fuzzy::ForceModel& model = pull_.scene().model()->model;

  auto* title = new QLabel(tr("Pull the force of"), this);
  title->setFont(theme::headingFont());
  who_->setAccessibleName(tr("Whose force"));
  if (model.experts.size() > 1) who_->addItem(tr("Mean"), kMean);
  for (std::size_t i = 0; i < model.experts.size(); ++i) who_->addItem(labelOf(model.experts[i]), static_cast<int>(i));
  kind_->setAccessibleName(tr("Where to"));
  kind_->addItem(tr("to a force here"));
  kind_->addItem(tr("into a band"));
  for (const PullWish& one : references_) kind_->addItem(tr("to the curve %1").arg(one.name));
  kind_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  auto* close = new QToolButton(this);
  close->setText(QStringLiteral("×"));
  close->setAutoRaise(true);
  close->setToolTip(tr("Close without a change (Esc)"));
  close->setAccessibleName(tr("Close"));

  auto* offers = new QWidget(this);
  offers_ = makeColumn(offers, {}, theme::kGrid / 2);
  hint_->setText(tr("The mean offers no rules: a rule belongs to one expert. Choose the expert to change one."));
  setInk(*warning_, theme::warningInk());
  auto* cancel = new QPushButton(tr("Cancel"), this);
  makeColumn(this,
             {makeRow({title, who_, {kind_, 1}, close}), point_row_, band_row_, sentence_, offers, all_, hint_,
              warning_, pin_row_, makeRow({spring(1), cancel, take_})},
             theme::kGrid * 3 / 4, inset(theme::kGrid * 3 / 2));
  keepFitted(*this, [this] { fit(); });

  connect(who_, &QComboBox::activated, this, [this] {
    const int expert = who_->currentData().toInt();
    pull_.setExpert(expert == kMean ? std::nullopt : std::optional(static_cast<std::size_t>(expert)));
  });
  connect(kind_, &QComboBox::activated, this, &PullCard::onKindChosen);
  for (NumberBox* box : {wanted_, from_, to_, low_, high_})
    connect(box, &QDoubleSpinBox::valueChanged, this, &PullCard::onNumberTyped);
  connect(all_, &QCheckBox::toggled, this, &PullCard::listOffers);
  connect(close, &QToolButton::clicked, &pull_, &PullController::cancel);
  connect(cancel, &QPushButton::clicked, &pull_, &PullController::cancel);
  connect(take_, &QPushButton::clicked, this, &PullCard::makeEdit);
  connect(&pull_, &PullController::changed, this, &PullCard::adoptAnswer);
  window_.installEventFilter(this);
  adoptAnswer();
  show();
  raise();
  wanted_->isVisible() ? wanted_->setFocus() : kind_->setFocus();
}

NumberBox* PullCard::addBox(const fuzzy::Variable& variable) {
  const bool force = &variable == &pull_.scene().model()->model.output;
  auto* box = new NumberBox(variable, force ? kForceStep : stepOf(variable), this);
  box->setRoomFor(QStringLiteral("000.00") + box->suffix());
  return box;
}

// `Now 0.589 N at 200 mm. Wanted [0.550 N]`
QWidget* PullCard::makePointRow() {
  wanted_ = addBox(pull_.scene().model()->model.output);
  wanted_->setAccessibleName(tr("Wanted force"));
  auto* row = new QWidget(this);
  makeRow(row, {now_, spring(1), new QLabel(tr("wanted"), this), wanted_});
  return row;
}

QWidget* PullCard::makeBandRow() {
  const fuzzy::Variable& x = pull_.scene().xVariable();
  const fuzzy::Variable& force = pull_.scene().model()->model.output;
  from_ = addBox(x);
  to_ = addBox(x);
  low_ = addBox(force);
  high_ = addBox(force);
  from_->setAccessibleName(tr("From"));
  to_->setAccessibleName(tr("To"));
  low_->setAccessibleName(tr("At least"));
  high_->setAccessibleName(tr("At most"));
  auto* row = new QWidget(this);
  auto* word = new QLabel(tr("from"), this);
  makeColumn(row,
             {makeRow({word, from_, new QLabel(tr("to"), this), to_, spring(1)}),
              makeRow({new QLabel(tr("at least"), this), low_, new QLabel(tr("at most"), this), high_, spring(1)})},
             theme::kGrid / 2);
  return row;
}

// `The force stays at 120 mm, 240 mm. [Take the pins away]`
QWidget* PullCard::makePinRow() {
  pins_ = makeText(theme::smallFont(), false);
  auto* away = new QPushButton(tr("Take the pins away"), this);
  connect(away, &QPushButton::clicked, &pull_, &PullController::clearPins);
  auto* row = new QWidget(this);
  makeRow(row, {{pins_, 1}, away});
  return row;
}

void PullCard::showPins() {
  const SceneController& scene = pull_.scene();
  QStringList here;
  int elsewhere = 0;
  for (const std::vector<double>& pin : pull_.pins()) {
    std::vector<double> place = scene.values();
    place[scene.xInput()] = pin[scene.xInput()];
    place == pin ? void(here << placeText(scene.xVariable(), pin[scene.xInput()])) : void(++elsewhere);
  }
  QStringList says;
  if (!here.isEmpty()) says << tr("The force stays at %1.").arg(here.join(QStringLiteral(", ")));
  if (elsewhere > 0) says << tr("It stays at %n place(s) with other inputs.", nullptr, elsewhere);
  pins_->setText(says.join(QLatin1Char(' ')));
  pin_row_->setVisible(!says.isEmpty());
}

void PullCard::onKindChosen(int index) {
  const fuzzy::Variable& x = pull_.scene().xVariable();
  PullWish wish = pull_.wish();
  if (index >= kReferences) {
    wish = references_[static_cast<std::size_t>(index - kReferences)];
  } else if (index == kABand && wish.kind != PullWish::Kind::kBand) {
    // A tenth of the axis around the place, from the wanted force up.
    const double half = (x.max - x.min) / 20;
    const double at = wish.kind == PullWish::Kind::kPoint ? wish.from : pull_.scene().value(pull_.scene().xInput());
    const double force_n = wish.kind == PullWish::Kind::kPoint ? wish.force_n : low_->value();
    wish = bandWish(placeOf(x, at - half), placeOf(x, at + half), force_n, high_->maximum());
  } else if (index == kAPoint && wish.kind != PullWish::Kind::kPoint) {
    const double at = pull_.scene().value(pull_.scene().xInput());
    wish = pointWish(at, wanted_->value());
  }
  pull_.setWish(wish);
}

void PullCard::onNumberTyped() {
  PullWish wish = pull_.wish();
  if (wish.kind == PullWish::Kind::kPoint) {
    wish.force_n = wanted_->exact();
  } else {
    wish.from = std::min(from_->exact(), to_->exact());
    wish.to = std::max(from_->exact(), to_->exact());
    wish.low_n = std::min(low_->exact(), high_->exact());
    wish.high_n = std::max(low_->exact(), high_->exact());
  }
  pull_.setWish(wish);
}

void PullCard::showWish() {
  const PullWish& wish = pull_.wish();
  const bool point = wish.kind == PullWish::Kind::kPoint;
  point_row_->setVisible(point);
  band_row_->setVisible(wish.kind == PullWish::Kind::kBand);
  const QSignalBlocker of_who(who_);
  const QSignalBlocker of_kind(kind_);
  // A model of one expert has no entry for the mean.
  who_->setCurrentIndex(std::max(0, who_->findData(pull_.expert() ? static_cast<int>(*pull_.expert()) : kMean)));
  int kind = point ? kAPoint : kABand;
  for (std::size_t i = 0; wish.kind == PullWish::Kind::kReference && i < references_.size(); ++i) {
    if (references_[i].name == wish.name) kind = kReferences + static_cast<int>(i);
  }
  kind_->setCurrentIndex(kind);
  const auto put = [](NumberBox* box, double value) {
    const QSignalBlocker quiet(box);
    if (box->exact() != value) box->setExact(value);
  };
  if (point) put(wanted_, wish.force_n);
  if (wish.kind != PullWish::Kind::kBand) return;
  put(from_, wish.from);
  put(to_, wish.to);
  put(low_, wish.low_n);
  put(high_, wish.high_n);
}

void PullCard::adoptAnswer() {
  if (pull_.state() != PullController::State::kChoosing) return;
  showWish();
  const fuzzy::ForceModel& model = pull_.scene().model()->model;
  const PullAnswer* const answer = pull_.answer();
  const QString place = placeText(pull_.scene().xVariable(), pull_.wish().from);
  now_->setText(answer && answer->now_n ? tr("Now %1 at %2").arg(forceText(*answer->now_n, model.output.unit), place)
                                        : tr("At %1").arg(place));
  sentence_->setText(!pull_.failure().isEmpty() ? pull_.failure()
                     : answer == nullptr        ? tr("Searching…")
                     : pull_.isSearching()      ? tr("Searching… Before: %1").arg(answer->sentence)
                                                : answer->sentence);
  const QStringList approved = pull_.approvedBy();
  QStringList warnings;
  if (!approved.isEmpty())
    warnings << tr("%1 approved the model as it is; an edit makes a version that is not approved.")
                    .arg(approved.join(QStringLiteral(", ")));
  if (const auto locked = static_cast<int>(pull_.lockedVertices()); locked > 0)
    warnings << tr("%n locked vertices stay where they are.", nullptr, locked);
  const bool of_mean = !pull_.expert() && model.experts.size() > 1;
  hint_->setVisible(of_mean);
  warning_->setText(warnings.join(QLatin1Char('\n')));
  warning_->setVisible(!warnings.isEmpty());
  showPins();
  if (answer != listed_) {
    listed_ = answer;
    listOffers();
  } else {
    showOffers();
  }
}

void PullCard::listOffers() {
  const auto buttons = choice_->buttons();
  const bool had_focus = std::any_of(buttons.begin(), buttons.end(), [](auto* one) { return one->hasFocus(); });
  for (QAbstractButton* button : buttons) {
    choice_->removeButton(button);
    button->hide();
    button->deleteLater();
  }
  const PullAnswer* const answer = pull_.answer();
  std::size_t folded = 0;
  std::size_t plausible = 0;
  for (std::size_t i = 0; answer != nullptr && i < answer->offers.size(); ++i) {
    const PullOffer& offer = answer->offers[i];
    (offer.folded ? folded : plausible) += 1;
    // Without a plausible edit the others are all there is.
    if (offer.folded && plausible > 0 && !all_->isChecked()) continue;
    const auto preview = [this, i] { pull_.preview(i); };
    auto* button = new OfferButton(offer, tr("Not plausible."), preview);
    choice_->addButton(button, static_cast<int>(i));
    offers_->addWidget(button);
    connect(button, &QAbstractButton::toggled, this, [preview](bool on) {
      if (on) preview();
    });
  }
  all_->setText(tr("Show %n edits that are not plausible", nullptr, static_cast<int>(folded)));
  all_->setVisible(folded > 0 && plausible > 0);
  showOffers();
  if (had_focus && choice_->checkedButton() != nullptr) choice_->checkedButton()->setFocus();
}

void PullCard::showOffers() {
  const auto shown = pull_.previewed();
  if (QAbstractButton* button = shown ? choice_->button(static_cast<int>(*shown)) : nullptr; button != nullptr) {
    const QSignalBlocker quiet(button);
    button->setChecked(true);
    for (QAbstractButton* one : choice_->buttons()) one->update();
  }
  take_->setEnabled(choice_->checkedButton() != nullptr && !pull_.isSearching());
}

void PullCard::makeEdit() {
  const int chosen = choice_->checkedId();
  if (chosen >= 0) pull_.take(static_cast<std::size_t>(chosen));
}

// Wrapped texts have their height only at this width.
void PullCard::fit() {
  const int width = std::min(kCharacters * fontMetrics().averageCharWidth(), window_.width() - 2 * theme::kGrid);
  setFixedWidth(width);
  layout()->activate();
  const int wanted = layout()->hasHeightForWidth() ? layout()->heightForWidth(width) : layout()->sizeHint().height();
  resize(width, std::min(wanted, window_.height() - 2 * theme::kGrid));
  moveBeside(beside_);
}

void PullCard::moveBeside(QPoint place) {
  beside_ = place;
  const bool right = window_.width() - place.x() >= place.x();
  const int x = right ? place.x() + kBesidePull : place.x() - kBesidePull - width();
  move(std::clamp(x, theme::kGrid, std::max(theme::kGrid, window_.width() - width() - theme::kGrid)),
       std::clamp(place.y() - height() / 2, theme::kGrid,
                  std::max(theme::kGrid, window_.height() - height() - theme::kGrid)));
}

void PullCard::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Escape: pull_.cancel(); break;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (take_->isEnabled()) makeEdit();
      break;
    default: Card::keyPressEvent(event);
  }
}

bool PullCard::event(QEvent* event) {
  const bool taken = Card::event(event);
  if (event->type() == QEvent::LayoutRequest) fit();
  return taken;
}

bool PullCard::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) fit();
  return Card::eventFilter(watched, event);
}

}  // namespace tactus::workbench
