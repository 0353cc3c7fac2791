// The averaged model of the open study with the labs' settings, and everything that led to it.
#pragma once

#include <QObject>
#include <QSet>
#include <QString>
#include <memory>

#include "app/workbench/labs/data/lab_work.h"

namespace tactus::workbench {

/// Thread: gui.
class LabModel : public QObject {
  Q_OBJECT

 public:
  /// `data` outlives this.
  explicit LabModel(LabData& data, QObject* parent = nullptr);

  /// Of the newest build; null if there is none, or it failed. While another one runs, the last one stays.
  const std::shared_ptr<const elicitation::BuiltModel>& built() const { return built_; }
  /// The study that `built` was made from, with the settings that made it.
  const std::shared_ptr<const LabStudy>& builtFrom() const { return from_; }
  const elicitation::BuildSettings& builtWith() const { return with_; }
  /// One sentence: why no model can be built; empty if one can.
  const QString& failure() const { return failure_; }
  const LabWork& work() const { return work_; }
  LabWork& work() { return work_; }

  /// Builds while at least one asker wants it. An asker that ends wants nothing.
  void setWanted(QObject& asker, bool wanted);

 signals:
  /// `built` or `failure` changed.
  void builtChanged();

 private:
  /// The newest model of the work's thread, whose clusters serve the next one. It keeps no study alive.
  struct Kept {
    std::weak_ptr<const LabStudy> study;
    elicitation::SpeedTermSettings with;
    std::shared_ptr<const elicitation::BuiltModel> built;
  };
  LabWork::Deliver build(const LabWork::Run& run);

  std::shared_ptr<const elicitation::BuiltModel> built_;
  std::shared_ptr<const LabStudy> from_;
  elicitation::BuildSettings with_;
  QString failure_;
  QSet<QObject*> askers_;
  Kept kept_;     ///< of the work's thread alone
  LabWork work_;  ///< last: its end waits for a build, which answers to all above
};

}  // namespace tactus::workbench
