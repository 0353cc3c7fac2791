#include "app/workbench/labs/data/lab_data.h"

#include <utility>

#include "app/workbench/base/display_text.h"

namespace tactus::workbench {

LabData::LabData(StudyConnection& connection, QObject* parent) : QObject(parent), connection_(connection) {
  connect(&connection_, &StudyConnection::opened, this, [this] {
    forget();
    refresh();
  });
  connect(&connection_, &StudyConnection::contentsChanged, this, &LabData::refresh);
  connect(&connection_, &StudyConnection::closed, this, &LabData::forget);
  stale_ = connection_.isOpen();
}

void LabData::setSettings(elicitation::BuildSettings settings) {
  settings_ = std::move(settings);
  emit settingsChanged();
}

void LabData::setMeasuredDepths(const elicitation::DepthMeasurement& measured) {
  if (settings_.measured_depths == measured) return;
  settings_.measured_depths = measured;
  if (settings_.depths == elicitation::DepthsFrom::kMeasured) emit settingsChanged();
}

void LabData::setWanted(QObject& asker, bool wanted) {
  if (!wanted) {
    askers_.remove(&asker);
  } else if (!askers_.contains(&asker)) {
    askers_.insert(&asker);
    connect(&asker, &QObject::destroyed, this, [this](QObject* ended) { askers_.remove(ended); });
    read();
  }
}

void LabData::setSessionRunning(bool runs) {
  if (std::exchange(runs_, runs) && !runs) refresh();
}

void LabData::refresh() {
  if (!connection_.isOpen()) return;
  stale_ = true;
  read();
}

// Several requests while one is on its way become one more.
void LabData::read() {
  if (!stale_ || reading_ || runs_ || askers_.isEmpty() || !connection_.isOpen()) return;
  stale_ = false;
  reading_ = true;
  connection_.read(*this, [this, path = connection_.path()](const store::StudyFile& file) -> StudyConnection::Deliver {
    auto result = readLabStudy(file);
    const QString sentence = result ? QString() : text(result.error().message());
    const auto study = result ? std::make_shared<const LabStudy>(std::move(*result)) : nullptr;
    return [this, path, study, sentence] {
      reading_ = false;
      if (path == connection_.path()) {
        study_ = study;
        // Later ones come from the lab that measures.
        if (study_ != nullptr && study_->measured_depths && !settings_.measured_depths) {
          setMeasuredDepths(*study_->measured_depths);
        }
        failure_ = sentence;
      }
      read();
      emit studyChanged();
    };
  });
  emit studyChanged();
}

void LabData::forget() {
  study_ = nullptr;
  failure_.clear();
  stale_ = false;
  reading_ = false;
  settings_ = {};
  emit studyChanged();
  emit settingsChanged();
}

}  // namespace tactus::workbench
