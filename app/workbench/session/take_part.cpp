#include "app/workbench/session/take_part.h"

#include <QGuiApplication>
#include <QPointer>
#include <QScreen>
#include <algorithm>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/collect/monitor_controller.h"
#include "app/workbench/collect/monitor_window.h"
#include "app/workbench/participant/check_in.h"
#include "app/workbench/participant/consent_text.h"
#include "app/workbench/participant/participant_window.h"
#include "app/workbench/session/nurse_view.h"
#include "app/workbench/shell/main_window.h"
#include "core/store/research_key.h"

namespace tactus::workbench {

QScreen& screenForParticipant(QScreen& researcher) {
  const QList<QScreen*> screens = QGuiApplication::screens();
  const auto other = std::find_if(screens.begin(), screens.end(), [&](QScreen* one) { return one != &researcher; });
  return other == screens.end() ? researcher : **other;
}

namespace {

// The later of the certificate of this window and that of the study, if it holds for the device.
void keepSetup(ParticipantPlan& plan, const std::optional<session::SetupCertificate>& own) {
  if (own && (!plan.setup || own->utc_ms > plan.setup->utc_ms)) plan.setup = own;
  if (plan.setup && !session::holds(*plan.setup, plan.device.toStdString(), utcNowMs())) plan.setup.reset();
}

}  // namespace

SessionRun::SessionRun(MainWindow& window, StudyConnection& study, DeviceSession& device, QObject* parent)
    : QObject(parent), window_(window), study_(study), device_(device) {
  connect(&search_, &DeviceSearch::found, this, &SessionRun::plan);
  connect(&study_, &StudyConnection::changed, this, [this] {
    if (!study_.isOpening() && std::exchange(plans_again_, false)) plan();
  });
  connect(&device_, &DeviceSession::sampled, this, [this](std::span<const haptics::Sample> samples) {
    if (monitor_) monitor_->add(samples);
  });
  // Its windows may be moved to another screen: the participant's.
  connect(qGuiApp, &QGuiApplication::screenRemoved, this, &SessionRun::hideMonitor);
}

SessionRun::~SessionRun() = default;

void SessionRun::start(const QString& code) { prepare(code, false); }

void SessionRun::startUsability() { prepare({}, true); }

void SessionRun::prepare(const QString& code, bool usability) {
  if (isRunning() || !study_.takesOrders()) return;
  preparing_ = true;
  study_path_ = study_.path();
  code_ = code;
  usability_ = usability;
  device_.stop();  // whatever was felt ends
  search_.search();
  emit changed();
}

void SessionRun::plan() {
  if (!preparing_ || take_part_) return;
  const auto gone = [this] {
    if (preparing_ && !take_part_)
      fail(tr("No session has begun: the study was closed while the device was looked for."));
  };
  const auto read = [this, gone](const store::StudyFile& file) -> StudyConnection::Deliver {
    return [this, gone, plan = participantPlan(file)] {
      if (!preparing_ || take_part_) return;
      if (study_.isOpening()) {
        plans_again_ = true;  // the study is perhaps being left: what comes of it decides
      } else if (study_.path() != study_path_) {
        gone();
      } else if (!plan) {
        fail(text(plan.error().message()));
      } else if (const QString why = whyNoSession(*plan); !why.isEmpty()) {
        preparing_ = false;
        emit refused(why);
        emit changed();
      } else {
        begin(*plan);
      }
    };
  };
  study_.read(*this, read, gone);
}

// The code is of one study; in another the screens ask.
void SessionRun::startAgain() { prepare(study_.path() == study_path_ ? code_ : QString(), usability_); }

void SessionRun::begin(ParticipantPlan plan) {
  plan.device = deviceToFeel(search_.list());
  keepSetup(plan, setup_);
  const auto& blocks = plan.settings.blocks;
  const bool felt = !usability_ && std::any_of(blocks.begin(), blocks.end(),
                                               [](session::Block block) { return block != session::Block::kForm; });
  setup_unchecked_ = felt && !(plan.setup && plan.setup->isGood());
  take_part_ = std::make_unique<TakePart>(study_, device_, plan);
  preparing_ = false;
  // The window is closed from within its own button.
  connect(take_part_.get(), &TakePart::left, this, &SessionRun::end, Qt::QueuedConnection);
  if (!code_.isEmpty()) take_part_->course().sitDown(code_);
  if (usability_) take_part_->course().sitDownAsTeacher();
  // The window of the one mode is gone before that of the other comes.
  quits_with_last_window_ = QGuiApplication::quitOnLastWindowClosed();
  QGuiApplication::setQuitOnLastWindowClosed(false);
  QScreen& here = *window_.screen();
  QScreen& screen = screenForParticipant(here);
  window_.hide();
  take_part_->begin(screen);
  watch(screen, here);
  emit changed();
}

// The researcher's window must never be seen by the participant: with one screen it stays hidden.
void SessionRun::watch(QScreen& nurse, QScreen& researcher) {
  ParticipantController& course = take_part_->course();
  monitor_ = std::make_unique<MonitorController>(course.session(), study_, utcNowMs);
  monitor_window_ = std::make_unique<MonitorWindow>(*monitor_);
  connect(&course, &ParticipantController::changed, monitor_.get(), [this] { report(); });
  connect(&course, &ParticipantController::refused, monitor_.get(), &MonitorController::say);
  connect(monitor_.get(), &MonitorController::callAnswered, &course, &ParticipantController::acknowledgeCall);
  report();
  if (&nurse == &researcher) return;
  const QRect room = researcher.availableGeometry();
  monitor_window_->setScreen(&researcher);
  monitor_window_->resize(room.size() * 4 / 5);
  monitor_window_->move(room.center() - monitor_window_->rect().center());
  monitor_window_->show();
  course.setMonitored(true);
}

void SessionRun::report() {
  const auto snapshot = take_part_->course().session().snapshot();
  const bool feels = snapshot && snapshot->part == session::SessionPart::kForce && snapshot->force;
  NurseView view = nurseView(take_part_->course().state(), feels ? &*snapshot->force : nullptr);
  view.setup_unchecked = setup_unchecked_ && !view.simulated;
  monitor_->show(view);
}

void SessionRun::hideMonitor() {
  if (!monitor_window_ || monitor_window_->isHidden()) return;
  monitor_window_->hide();
  take_part_->course().setMonitored(false);
}

void SessionRun::end() {
  monitor_window_.reset();
  monitor_.reset();
  take_part_.reset();
  device_.stop();
  window_.show();
  QGuiApplication::setQuitOnLastWindowClosed(quits_with_last_window_);
  emit changed();
}

void SessionRun::fail(const QString& sentence) {
  preparing_ = false;
  emit failed(sentence);
  emit changed();
}

QString deviceToFeel(const devices::DeviceList& list) {
  const auto first = [&list](auto fits) { return std::find_if(list.devices.begin(), list.devices.end(), fits); };
  auto found = first([](const auto& device) { return device.usable && !device.simulated; });
  if (found == list.devices.end()) found = first([](const auto& device) { return device.usable; });
  return text(found != list.devices.end() ? found->id : list.devices.back().id);
}

TakePartStart::TakePartStart(DeviceAccess devices) : device_(std::move(devices)) {
  connect(&study_, &StudyConnection::failed, this, [this](const QString& /*path*/, const QString& sentence) {
    if (!take_part_) emit failed(sentence);
  });
  connect(&study_, &StudyConnection::opened, this, [this] {
    if (study_.isReadOnly()) {
      emit failed(tr("No session can begin: %1 is open for reading only, because %2.")
                      .arg(study_.fileName(), study_.readOnlyReason()));
    } else {
      search_.search();
    }
  });
  connect(&search_, &DeviceSearch::found, this, &TakePartStart::plan);
  connect(&study_, &StudyConnection::closed, this, [this] { emit left(path_); });
}

void TakePartStart::open(const QString& study) {
  path_ = study;
  study_.open(study);
}

void TakePartStart::plan() {
  if (take_part_) return;
  study_.read(*this, [this](const store::StudyFile& file) {
    return [this, plan = participantPlan(file)] {
      if (!plan) {
        emit failed(text(plan.error().message()));
      } else if (const QString why = whyNoSession(*plan); !why.isEmpty()) {
        emit failed(tr("No session can begin. %1").arg(why));
      } else {
        begin(*plan);
      }
    };
  });
}

void TakePartStart::begin(ParticipantPlan plan) {
  plan.device = deviceToFeel(search_.list());
  keepSetup(plan, {});
  take_part_ = std::make_unique<TakePart>(study_, device_, plan);
  connect(take_part_.get(), &TakePart::left, &study_, &StudyConnection::close);
  take_part_->begin(*QGuiApplication::primaryScreen());
}

TakePart::TakePart(StudyConnection& study, DeviceSession& device, const ParticipantPlan& plan,
                   std::function<study::Moment()> now)
    : study_(study),
      course_(study, device, plan, std::move(now)),
      window_(look_, [&device] { device.setForce({}); }),
      views_(course_, look_, window_),
      hand_(window_, look_, device) {
  connect(&course_, &ParticipantController::changed, this, &TakePart::giveHand);
  connect(&views_, &ParticipantViews::finished, this, &TakePart::finished);
  connect(&window_, &ParticipantWindow::forceOff, this, [this](ForceOffCause cause) {
    // In a pause of the researcher, who types in the monitor, there is no force, and nothing to ask the participant.
    if (cause == ForceOffCause::kDeactivated && course_.state().paused) return;
    course_.forceOff();
  });
  connect(&window_, &ParticipantWindow::pauseAsked, &course_, &ParticipantController::pause);
  connect(&window_, &ParticipantWindow::leaveAsked, this, &TakePart::askForPassphrase);
}

void TakePart::begin(QScreen& screen) { window_.showOn(screen); }

// On screens where she pushes and feels; elsewhere the keys choose and continue.
void TakePart::giveHand() {
  const ParticipantState& state = course_.state();
  using Screen = ParticipantScreen;
  const bool pushes = state.screen == Screen::kSpeed || state.screen == Screen::kOwnModel ||
                      (state.screen == Screen::kPractice && !state.feels_force) ||
                      (state.screen == Screen::kDeviceCheck && state.device != DeviceStep::kReady);
  const bool feels = (state.screen == Screen::kForce || state.screen == Screen::kPractice) && state.feels_force &&
                     state.force.phase != ForceState::Phase::kAnswer;
  const bool covered = state.overlay != ForceOffOverlay::kNone;
  hand_.setWanted(!covered && (pushes || feels));
  if (covered) hand_.letGo();
}

void TakePart::askForPassphrase() {
  auto* panel = new LeavePanel(look_);
  connect(panel, &LeavePanel::stay, &window_, &ParticipantWindow::endQuestion);
  connect(panel, &LeavePanel::entered, this, [this, panel](const QString& passphrase) { check(*panel, passphrase); });
  window_.askResearcher(panel);
}

void TakePart::check(LeavePanel& asked, const QString& passphrase) {
  study_.read(*this, [this, panel = QPointer(&asked), typed = passphrase.toStdString()](const store::StudyFile& file) {
    const auto opens = store::opensResearch(file, typed);
    return [this, panel, right = opens && *opens] {
      if (right) {
        window_.leave();
        emit left();
      } else if (panel) {
        panel->refuse();
      }
    };
  });
}

}  // namespace tactus::workbench
