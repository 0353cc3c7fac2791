// What all labs share: the open study as elicitation sees it, and the settings of the model that is built from it.
// Nothing is read while no lab is on the screen.
#pragma once

#include <QObject>
#include <QSet>
#include <QString>
#include <memory>

#include "app/workbench/labs/data/lab_study.h"
#include "app/workbench/study/connection/study_connection.h"
#include "elicitation/model/model_builder.h"

namespace tactus::workbench {

/// Thread: gui.
class LabData : public QObject {
  Q_OBJECT

 public:
  /// `connection` outlives this.
  explicit LabData(StudyConnection& connection, QObject* parent = nullptr);

  /// The study, shared unchanged; null while none is read.
  const std::shared_ptr<const LabStudy>& study() const { return study_; }
  /// One sentence: why the study cannot be read; empty if it can.
  const QString& failure() const { return failure_; }
  /// The study is being read.
  bool isReading() const { return reading_; }
  StudyConnection& connection() { return connection_; }
  const StudyConnection& connection() const { return connection_; }

  /// The settings of every lab's model. They begin with the defaults when a study is opened.
  const elicitation::BuildSettings& settings() const { return settings_; }
  void setSettings(elicitation::BuildSettings settings);
  /// Another measurement of depths for the settings. Without effect on a model with the template's depths.
  void setMeasuredDepths(const elicitation::DepthMeasurement& measured);

  /// Reads the study while at least one asker wants it. An asker that ends wants nothing.
  void setWanted(QObject& asker, bool wanted);
  /// While a session runs, the thread of the study belongs to it: reading waits until the end.
  void setSessionRunning(bool runs);

 public slots:
  /// Reads the study again: something in it has changed.
  void refresh();

 signals:
  /// `study`, `failure` or `isReading` changed.
  void studyChanged();
  void settingsChanged();

 private:
  void read();
  void forget();

  StudyConnection& connection_;
  std::shared_ptr<const LabStudy> study_;
  QString failure_;
  elicitation::BuildSettings settings_;
  QSet<QObject*> askers_;
  bool stale_ = false;
  bool reading_ = false;
  bool runs_ = false;
};

}  // namespace tactus::workbench
