#include "app/workbench/take_part_start.h"

#include <QGuiApplication>
#include <QScreen>
#include <algorithm>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "app/workbench/participant/consent_text.h"

namespace tactus::workbench {

QString deviceToFeel(const devices::DeviceList& list) {
  const auto real = std::find_if(list.devices.begin(), list.devices.end(),
                                 [](const auto& device) { return device.usable && !device.simulated; });
  return text(real != list.devices.end() ? real->id : list.devices.back().id);
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
  take_part_ = std::make_unique<TakePart>(study_, device_, plan);
  connect(take_part_.get(), &TakePart::left, &study_, &StudyConnection::close);
  take_part_->begin(*QGuiApplication::primaryScreen());
}

}  // namespace tactus::workbench
