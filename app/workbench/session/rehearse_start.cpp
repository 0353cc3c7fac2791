#include "app/workbench/session/rehearse_start.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QGuiApplication>
#include <QScreen>
#include <iterator>
#include <utility>

#include "app/session/simulated_study.h"
#include "app/workbench/base/display_text.h"
#include "app/workbench/participant/check_in.h"
#include "app/workbench/rehearsal/rehearsal.h"
#include "core/store/persons.h"

namespace tactus::workbench {
namespace {

// One after another in a study, so that their model has more than one expert; the first uses all five words.
constexpr const char* kNurses[] = {"S3", "S1", "S2"};
constexpr std::uint64_t kRehearsalSeed = 2;  // of the first; arbitrary: another one is another session

/// A name that no file has yet.
QString newStudy() {
  const QDir folder(QDir::tempPath());
  const QString stem =
      QStringLiteral("tactus-rehearsal-") + QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss"));
  QString name = stem;
  for (int number = 2; folder.exists(name + QStringLiteral(".tactus")); ++number) {
    name = stem + QLatin1Char('-') + QString::number(number);
  }
  return folder.filePath(name + QStringLiteral(".tactus"));
}

}  // namespace

RehearseStart::RehearseStart(const RehearseSettings& settings)
    : speed_(settings.speed),
      path_(settings.study.isEmpty() ? newStudy() : QFileInfo(settings.study).absoluteFilePath()),
      device_(time_.access()) {
  connect(&study_, &StudyConnection::failed, this, [this](const QString& /*path*/, const QString& sentence) {
    // With a disk that refuses, the nurse waits as a person does.
    if (!take_part_) end(sentence);
  });
  connect(&study_, &StudyConnection::opened, this, &RehearseStart::prepare);
  connect(&study_, &StudyConnection::closed, this, &RehearseStart::readBack);
}

void RehearseStart::begin() {
  began_utc_ms_ = QDateTime::currentMSecsSinceEpoch();
  if (QFileInfo::exists(path_)) {
    study_.open(path_);
  } else {
    study_.create(path_);
  }
}

study::Moment RehearseStart::now() const { return {began_utc_ms_ + time_.nowNs() / 1'000'000, time_.nowNs()}; }

void RehearseStart::prepare() {
  if (study_.isReadOnly()) {
    return end(tr("No session can begin: %1 is open for reading only, because %2.")
                   .arg(study_.fileName(), study_.readOnlyReason()));
  }
  study_.read(*this, [this](const store::StudyFile& file) -> StudyConnection::Deliver {
    auto plan = participantPlan(file);
    if (!plan) return [this, sentence = text(plan.error().message())] { end(sentence); };
    const auto before = store::persons(file);
    if (!before) return [this, sentence = text(before.error().message())] { end(sentence); };
    plan->simulated = true;
    const std::uint64_t seed = kRehearsalSeed + before->size();
    plan->seed = seed;
    const auto nurse = session::simulatedNurseCalled(kNurses[before->size() % std::size(kNurses)], seed);
    return [this, plan = *plan, nurse] { raise(plan, nurse); };
  });
}

void RehearseStart::raise(const ParticipantPlan& plan, const session::NurseTraits& nurse) {
  take_part_ = std::make_unique<TakePart>(study_, device_, plan, [this] { return now(); });
  emit raised(&take_part_->course());
  take_part_->begin(*QGuiApplication::primaryScreen());
  const Rehearsal::Parts on{take_part_->course(), take_part_->window(), take_part_->look(), device_, time_};
  rehearsal_ = std::make_unique<Rehearsal>(on, nurse, plan.seed.value_or(kRehearsalSeed), speed_);
  connect(&take_part_->course(), &ParticipantController::refused, this, &RehearseStart::end);
  connect(rehearsal_.get(), &Rehearsal::stuck, this, &RehearseStart::end);
  connect(rehearsal_.get(), &Rehearsal::came, this, &RehearseStart::came);
  connect(rehearsal_.get(), &Rehearsal::done, this, [this] {
    take_part_->window().leave();
    device_.stop();
    study_.close();
  });
  rehearsal_->begin();
}

void RehearseStart::readBack() {
  if (ended_) return;
  const auto file = store::StudyFile::open(path_.toStdString(), {store::Access::kReadOnly});
  const auto checked = file ? checkRehearsal(*file, rehearsal_->memory()) : tl::unexpected(file.error());
  if (!checked) return end(text(checked.error().message()));
  ended_ = true;
  emit succeeded();
}

void RehearseStart::end(const QString& sentence) {
  if (std::exchange(ended_, true)) return;
  emit failed(sentence);
}

}  // namespace tactus::workbench
