#include "app/workbench/feel/duel/duel_window.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QFormLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QRandomGenerator>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QStandardItemModel>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/base/theme.h"
#include "app/workbench/device/device_search.h"
#include "app/workbench/feel/feel_panel.h"
#include "app/workbench/kit/buttons.h"
#include "app/workbench/kit/labels.h"
#include "app/workbench/kit/layout.h"
#include "app/workbench/kit/number_box.h"
#include "app/workbench/model/patient.h"
#include "app/workbench/study/connection/study_connection.h"

namespace tactus::workbench {
namespace {

using experiments::DuelRun;
using experiments::DuelVerdict;
using State = DuelController::State;
using study::DuelChoice;
using study::DuelQuestion;
using study::DuelRule;

constexpr double kSlowestMmS = 5;
constexpr double kFastestMmS = 200;
constexpr int kWide = 640;  // px

QLabel* wrappedLabel(QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  return label;
}

QString wholePercent(double share) { return numberText(100 * share, 0); }

}  // namespace

DuelWindow::DuelWindow(DuelController& duel, DeviceSession& device, StudyConnection& study, QWidget* parent)
    : QDialog(parent),
      duel_(duel),
      device_(device),
      study_(study),
      search_(new DeviceSearch(this)),
      pages_(new QStackedWidget(this)),
      message_(wrappedLabel(this)) {
  setWindowTitle(tr("Feel blind"));
  message_->hide();
  setInk(*message_, theme::warningInk());
  pages_->addWidget(makeSetup());
  pages_->addWidget(makeRun());
  pages_->addWidget(makeResult());
  makeColumn(this, {{pages_, 1}, message_}, theme::kGrid, inset(2 * theme::kGrid));
  resize(kWide, sizeHint().height());
  keepWhole(*this);
  connectAll();
}

QWidget* DuelWindow::makeSetup() {
  auto* page = new QWidget(this);
  names_ = wrappedLabel(page);
  auto* heavier = new QRadioButton(tr("Which was heavier?"), page);
  auto* real = new QRadioButton(tr("Which was more like a real insertion?"), page);
  heavier->setChecked(true);
  question_ = new QButtonGroup(page);
  question_->addButton(heavier, static_cast<int>(DuelQuestion::kHeavier));
  question_->addButton(real, static_cast<int>(DuelQuestion::kMoreReal));
  rule_ = new QComboBox(page);
  rule_->addItem(tr("after a fixed number of trials"), static_cast<int>(DuelRule::kFixed));
  rule_->addItem(tr("as soon as the answers suffice"), static_cast<int>(DuelRule::kSequential));
  rule_->addItem(tr("own smallest difference, with A alone"), static_cast<int>(DuelRule::kOwnJnd));
  const auto box = [page](double most, double step, const QString& unit, const QString& name) {
    fuzzy::Variable variable;
    variable.unit = unit.toStdString();
    variable.max = most;
    auto* made = new NumberBox(variable, step, page);
    made->setAccessibleName(name);
    return made;
  };
  from_ = box(1000, 5, QStringLiteral("mm"), tr("The stroke begins at"));
  to_ = box(1000, 5, QStringLiteral("mm"), tr("The stroke ends at"));
  speed_ = box(kFastestMmS, 5, QStringLiteral("mm/s"), tr("Speed of the stroke"));
  devices_ = new QComboBox(page);
  forecast_ = wrappedLabel(page);
  kept_ = wrappedLabel(page);
  begin_ = new QPushButton(tr("Begin"), page);
  resume_ = new QPushButton(page);
  auto* close = new QPushButton(tr("Close"), page);
  connect(close, &QPushButton::clicked, this, &QDialog::reject);
  auto* form = new QFormLayout;
  form->addRow(tr("Question"), makeColumn({heavier, real}, 2));
  form->addRow(tr("Ends"), rule_);
  form->addRow(tr("Stroke"),
               makeRow({from_, new QLabel(tr("to"), page), to_, new QLabel(tr("at"), page), speed_, spring(1)}));
  form->addRow(tr("Device"), devices_);
  makeColumn(
      page,
      {names_, form,
       makeRow({{forecast_, 1}, {new StatisticHelp({Statistic::kNoticeable, Statistic::kRms}, page), 0, Qt::AlignTop}}),
       kept_, spring(1), makeRow({spring(1), resume_, begin_, close})},
      2 * theme::kGrid);
  return page;
}

QWidget* DuelWindow::makeRun() {
  auto* page = new QWidget(this);
  instruction_ = wrappedLabel(page);
  instruction_->setFont(theme::headingFont());
  repeat_ = wrappedLabel(page);
  setInk(*repeat_, theme::warningInk());
  pace_ = new PaceBar(page);
  pad_ = new TubePad(page);
  answers_ = new QWidget(page);
  auto* first = new QPushButton(tr("Choose the first (1)"), answers_);
  auto* second = new QPushButton(tr("Choose the second (2)"), answers_);
  auto* untold = new QPushButton(tr("Choose neither: can't tell (0)"), answers_);
  connect(first, &QPushButton::clicked, &duel_, [this] { duel_.answer(DuelChoice::kFirst); });
  connect(second, &QPushButton::clicked, &duel_, [this] { duel_.answer(DuelChoice::kSecond); });
  connect(untold, &QPushButton::clicked, &duel_, [this] { duel_.answer(DuelChoice::kCantTell); });
  makeRow(answers_, {first, second, untold, spring(1)});
  progress_ = wrappedLabel(page);
  go_on_ = new QPushButton(tr("Go on"), page);
  auto* stop = new QPushButton(tr("Stop (Esc)"), page);
  connect(go_on_, &QPushButton::clicked, &duel_, &DuelController::goOn);
  connect(stop, &QPushButton::clicked, &duel_, &DuelController::stop);
  makeColumn(page, {instruction_, repeat_, pace_, pad_, answers_, spring(1), makeRow({{progress_, 1}, go_on_, stop})},
             2 * theme::kGrid);
  return page;
}

QWidget* DuelWindow::makeResult() {
  auto* page = new QWidget(this);
  verdict_ = wrappedLabel(page);
  verdict_->setFont(theme::headingFont());
  details_ = wrappedLabel(page);
  who_ = new QLineEdit(page);
  who_->setPlaceholderText(tr("Name or code of who felt it"));
  who_->setAccessibleName(who_->placeholderText());
  approve_ = new QPushButton(tr("Approve: felt"), page);
  auto* again = new QPushButton(tr("Begin another"), page);
  auto* close = new QPushButton(tr("Close"), page);
  connect(approve_, &QPushButton::clicked, this, [this] {
    if (const auto felt = duel_.feltOpenModel()) emit approved(who_->text(), *felt);
    approve_->setEnabled(false);
  });
  connect(who_, &QLineEdit::textChanged, this,
          [this](const QString& who) { approve_->setEnabled(!who.trimmed().isEmpty()); });
  connect(again, &QPushButton::clicked, &duel_, &DuelController::stop);
  connect(close, &QPushButton::clicked, this, &QDialog::reject);
  makeColumn(page, {verdict_, details_, spring(1), makeRow({{who_, 1}, approve_}), makeRow({spring(1), again, close})},
             2 * theme::kGrid);
  return page;
}

void DuelWindow::connectAll() {
  for (NumberBox* box : {from_, to_, speed_}) connect(box, &NumberBox::valueChanged, this, &DuelWindow::showForecast);
  connect(question_, &QButtonGroup::idClicked, this, &DuelWindow::showForecast);
  connect(rule_, &QComboBox::activated, this, &DuelWindow::showForecast);
  connect(begin_, &QPushButton::clicked, this, &DuelWindow::begin);
  connect(resume_, &QPushButton::clicked, this, &DuelWindow::resume);
  connect(search_, &DeviceSearch::found, this, &DuelWindow::listDevices);
  connect(&duel_, &DuelController::changed, this, &DuelWindow::showState);
  connect(&duel_, &DuelController::moved, this, &DuelWindow::showMotion);
  connect(&duel_, &DuelController::failed, this, &DuelWindow::say);
  connect(pad_, &TubePad::targetMoved, &device_, &DeviceSession::setTarget);
  connect(pad_, &TubePad::gripped, &device_, &DeviceSession::setHeld);
  listDevices();
}

void DuelWindow::listDevices() {
  const QVariant chosen = devices_->currentData();
  devices_->clear();
  auto* items = qobject_cast<QStandardItemModel*>(devices_->model());
  for (const devices::ListedDevice& device : search_->list().devices) {
    devices_->addItem(text(device.name), text(device.id));
    if (!device.usable) items->item(devices_->count() - 1)->setEnabled(false);
  }
  const int again = devices_->findData(chosen);
  devices_->setCurrentIndex(again >= 0 ? again : devices_->count() - 1);
}

void DuelWindow::propose(DuelSetup setup, const QString& who) {
  if (duel_.state() != State::kIdle && duel_.state() != State::kDone) return;  // one is in progress
  duel_.stop();
  setup_ = std::move(setup);
  message_->hide();
  who_->setText(who);
  const auto depth = fuzzy::wayOf(setup_.a->model.inputs);
  const fuzzy::Variable& variable = setup_.a->model.inputs[*depth];
  const auto put = [](NumberBox& box, double least, double most, double value) {
    const QSignalBlocker quiet(&box);  // the forecast is for all three
    box.setRange(least, most);
    box.setValue(value);
  };
  put(*from_, variable.min, variable.max, setup_.from_mm);
  put(*to_, variable.min, variable.max, setup_.to_mm);
  put(*speed_, kSlowestMmS, kFastestMmS, setup_.speed_mm_s);
  names_->setText(tr("A: %1\nB: %2").arg(text(setup_.a_name.name), text(setup_.b_name.name)));
  search_->search();
  lookForUnfinished();
  showForecast();
  showState();
}

void DuelWindow::readSetup() {
  setup_.from_mm = from_->value();
  setup_.to_mm = to_->value();
  setup_.speed_mm_s = speed_->value();
  setup_.question = static_cast<DuelQuestion>(question_->checkedId());
  setup_.rule = static_cast<DuelRule>(rule_->currentData().toInt());
}

void DuelWindow::lookForUnfinished() {
  unfinished_.reset();
  resume_->hide();
  if (!study_.takesOrders()) return;
  study_.read(*this, [this, a = setup_.a_name, b = setup_.b_name](const store::StudyFile& file) {
    std::optional<store::StoredDuel> found;
    if (auto all = store::duels(file)) {
      for (auto& duel : *all) {
        if (!duel.end && duel.start.a == a && duel.start.b == b) found = std::move(duel);
      }
    }
    return [this, found] {
      unfinished_ = found;
      resume_->setVisible(found.has_value());
      if (!found) return;
      const auto answered = std::count_if(found->answers.begin(), found->answers.end(),
                                          [](const auto& answer) { return answer.choice.has_value(); });
      resume_->setText(tr("Go on with the interrupted one (%n answer(s))", nullptr, static_cast<int>(answered)));
    };
  });
}

void DuelWindow::showForecast() {
  if (!setup_.a) return;
  readSetup();
  const bool own = setup_.rule == DuelRule::kOwnJnd;
  for (QAbstractButton* button : question_->buttons()) button->setEnabled(!own);
  kept_->setText(study_.takesOrders() ? tr("The answers go into the study %1.").arg(study_.fileName())
                                      : tr("No study is open: the answers are not kept."));
  begin_->setEnabled(true);
  if (own) {
    forecast_->setText(
        tr("40 trials find the smallest difference of A that this hand feels on this device, mostly within "
           "a quarter of the truth."));
    return;
  }
  const auto forecast = duelForecast(setup_);
  begin_->setEnabled(forecast && forecast->test);
  if (!forecast) {
    forecast_->setText(tr("There is no force along this stroke. Choose another one."));
    return;
  }
  const auto& difference = forecast->difference;
  QString sentence = tr("Along this stroke A and B differ by %1 JND (RMS), at most %2 JND at %3 mm.")
                         .arg(numberText(difference.rms_jnd, 2), numberText(difference.largest_jnd, 2),
                              numberText(difference.at_mm, 0));
  if (!forecast->test) {
    sentence +=
        QLatin1Char(' ') + tr("That is not felt, however often it is tried. Choose another stroke or other versions.");
  } else {
    sentence +=
        QLatin1Char(' ') + tr("It takes %n trial(s); %1 right answers show the difference, which is found with %2 %.",
                              nullptr, forecast->test->trials)
                               .arg(forecast->test->critical)
                               .arg(wholePercent(forecast->test->power));
    if (setup_.question == DuelQuestion::kMoreReal && difference.rms_jnd < 1)
      sentence += QLatin1Char(' ') + tr("Below 1 JND a preference is mostly chance: ask first which was heavier.");
  }
  forecast_->setText(sentence);
}

void DuelWindow::begin() {
  readSetup();
  tell(duel_.begin(setup_, devices_->currentData().toString(), QRandomGenerator::system()->generate64()));
}

void DuelWindow::resume() {
  if (unfinished_) tell(duel_.resume(setup_, *unfinished_, devices_->currentData().toString()));
}

void DuelWindow::tell(const base::Result<void>& begun) {
  message_->hide();
  if (!begun) say(tr("The comparison did not begin: %1").arg(text(begun.error().message())));
}

void DuelWindow::say(const QString& sentence) {
  message_->setText(sentence);
  message_->show();
}

void DuelWindow::showState() {
  const State state = duel_.state();
  if (state == State::kIdle) {
    if (pages_->currentIndex() != 0 && setup_.a) lookForUnfinished();
    pages_->setCurrentIndex(0);
    return;
  }
  if (state == State::kDone) {
    showResult();
    pages_->setCurrentIndex(2);
    return;
  }
  if (pages_->currentIndex() != 1) {
    pages_->setCurrentIndex(1);
    pad_->setFocus();
  }
  const DuelRun& run = *duel_.run();
  instruction_->setText(instruction());
  repeat_->setText(repeatText());
  pace_->setWay(run.start().from_mm, run.start().to_mm);
  answers_->setEnabled(state == State::kQuestion);
  go_on_->setVisible(state == State::kRest || state == State::kInterrupted);
  progress_->setText(run.start().rule == DuelRule::kSequential
                         ? tr("Trial %1, at most %2").arg(run.done() + 1).arg(run.all())
                         : tr("Trial %1 of %2").arg(run.done() + 1).arg(run.all()));
  showMotion();
}

void DuelWindow::showMotion() {
  pace_->setPlaces(duel_.depthMm(), duel_.promptMm());
  const haptics::Sample& sample = device_.latest();
  TubePad::Reading reading;
  reading.hand_mm = sample.position_mm;
  reading.tube_mm = sample.position_mm - sample.stretch_mm;
  reading.target_mm = device_.targetMm();
  reading.live = device_.isHandLive();
  reading.held = sample.enabled;
  reading.latch = device_.grip().latch;
  reading.running = device_.isRunning();
  pad_->setReading(reading);
}

QString DuelWindow::instruction() const {
  const DuelRun& run = *duel_.run();
  const QString which = run.stage() == DuelRun::Stage::kSecondStroke ? tr("Second stroke") : tr("First stroke");
  switch (duel_.state()) {
    case State::kStarting: return tr("The device starts…");
    case State::kLetGo: return tr("%1: let go, and take the hand back.").arg(which);
    case State::kPush: return tr("%1: hold the tool and push to the end, with the line.").arg(which);
    case State::kRest: return tr("Rest your hand. Go on when you like.");
    case State::kInterrupted: return tr("The device has stopped. Nothing is lost.");
    case State::kQuestion: break;
    case State::kIdle:
    case State::kDone: return {};
  }
  const auto& start = run.start();
  return start.rule == DuelRule::kOwnJnd || start.question == DuelQuestion::kHeavier
             ? tr("Which was heavier?")
             : tr("Which was more like a real insertion?");
}

QString DuelWindow::repeatText() const {
  using experiments::DuelRepeat;
  if (duel_.wasHeldBack()) return tr("Once more: the device did not give the whole force yet.");
  switch (duel_.run()->repeat()) {
    case DuelRepeat::kNone: return {};
    case DuelRepeat::kNotWhole: return tr("Once more: the stroke ended before the end of the way.");
    case DuelRepeat::kTooSlow: return tr("Once more: that was slower than the line.");
    case DuelRepeat::kTooFast: return tr("Once more: that was faster than the line.");
    case DuelRepeat::kPause: return tr("Once more: begin the second stroke within two seconds.");
  }
  return {};
}

void DuelWindow::showResult() {
  verdict_->setText(verdictText());
  details_->setText(detailsText());
  const bool may_approve = duel_.feltOpenModel() && duel_.run()->start().rule != DuelRule::kOwnJnd;
  for (QWidget* part : {static_cast<QWidget*>(who_), static_cast<QWidget*>(approve_)}) part->setVisible(may_approve);
  approve_->setEnabled(may_approve && !who_->text().trimmed().isEmpty());
}

QString DuelWindow::verdictText() const {
  const auto& start = duel_.run()->start();
  const DuelVerdict verdict = duel_.verdict();
  const QString count = tr("%1 of %2").arg(numberText(verdict.right, 1)).arg(verdict.trials);
  switch (verdict.outcome) {
    case DuelVerdict::Outcome::kUnfinished: return {};
    case DuelVerdict::Outcome::kMeasured:
      return tr("The smallest difference that was felt is %1 times the usual one (95 % interval %2 to %3).")
          .arg(numberText(verdict.own->factor, 2), numberText(verdict.own->low, 2), numberText(verdict.own->high, 2));
    case DuelVerdict::Outcome::kNotShown:
      return tr("Not shown to differ: %1. A difference of %2 JND or more would have been found with %3 %.")
          .arg(count, numberText(verdict.detectable_jnd, 1), wholePercent(start.power));
    case DuelVerdict::Outcome::kDiffer: break;
  }
  const QString name = text(start.expects_b ? start.b.name : start.a.name);
  return (start.question == DuelQuestion::kHeavier
              ? tr("“%1” is felt as heavier: %2 (95 % interval %3 to %4 %).")
              : tr("“%1” is felt as more like a real insertion: %2 (95 % interval %3 to %4 %)."))
      .arg(name, count, wholePercent(verdict.share.low), wholePercent(verdict.share.high));
}

QString DuelWindow::notFeltText() const {
  const auto& start = duel_.run()->start();
  if (start.setting.simulated)
    return tr("The device was simulated: nothing was felt, and this is no sign-off by hand.");
  return start.gives_force ? QString()
                           : tr("The device gives no force: nothing was felt, and this is no sign-off by hand.");
}

QString DuelWindow::detailsText() const {
  const auto& start = duel_.run()->start();
  const DuelVerdict verdict = duel_.verdict();
  QStringList lines;
  if (const QString not_felt = notFeltText(); !not_felt.isEmpty()) lines << not_felt;
  if (start.rule == DuelRule::kSequential)
    lines << tr("Sequential: it ended as soon as the answers sufficed, so the interval is too narrow.");
  if (verdict.marked) {
    lines << tr("Marked: of the large differences only %1 of %2 were told right.")
                 .arg(verdict.large_right)
                 .arg(verdict.large);
  } else if (verdict.large > 0) {
    lines << tr("Large differences told right: %1 of %2.").arg(verdict.large_right).arg(verdict.large);
  }
  if (verdict.same > 0)
    lines << tr("A difference was named where there was none: %1 of %2.").arg(verdict.same_named).arg(verdict.same);
  lines << tr("Can't tell: %1. Trials that came again: %2.").arg(verdict.cant_tell).arg(verdict.repeated);
  lines << (duel_.isKept() ? tr("Kept in the study %1.").arg(study_.fileName()) : tr("Not kept: no study was open."));
  return lines.join(QLatin1Char('\n'));
}

void DuelWindow::keyPressEvent(QKeyEvent* event) {
  if (duel_.state() == State::kQuestion && !event->isAutoRepeat()) {
    switch (event->key()) {
      case Qt::Key_1: return duel_.answer(DuelChoice::kFirst);
      case Qt::Key_2: return duel_.answer(DuelChoice::kSecond);
      case Qt::Key_0: return duel_.answer(DuelChoice::kCantTell);
      default: break;
    }
  }
  // Takes the force away at once; only a second Escape closes the window.
  if ((event->key() == Qt::Key_Escape || event->key() == Qt::Key_F12) && duel_.state() != State::kIdle &&
      duel_.state() != State::kDone) {
    duel_.stop();
    return;
  }
  QDialog::keyPressEvent(event);
}

void DuelWindow::done(int result) {
  duel_.stop();
  QDialog::done(result);
}

}  // namespace tactus::workbench
