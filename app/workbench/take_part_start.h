// `tactus-workbench --take-part STUDY`: opens the study and shows the nurse's screens, without the research mode.
#pragma once

#include <QObject>
#include <QString>
#include <memory>

#include "app/workbench/device/device_search.h"
#include "app/workbench/device/device_session.h"
#include "app/workbench/study/connection/study_connection.h"
#include "app/workbench/take_part.h"

namespace tactus::workbench {

/// The first device with a motor that can be used, else the virtual one.
QString deviceToFeel(const devices::DeviceList& list);

class TakePartStart : public QObject {
  Q_OBJECT

 public:
  explicit TakePartStart(DeviceAccess devices = realDevices());

  /// Ends with `left`, as soon as the researcher leaves, or with `failed`.
  void open(const QString& study);

 signals:
  /// The study is closed; the research mode may open it.
  void left(const QString& study);
  /// One sentence: why the study cannot be opened or followed.
  void failed(const QString& sentence);

 private:
  void plan();
  void begin(ParticipantPlan plan);

  StudyConnection study_;
  DeviceSearch search_;
  DeviceSession device_;
  QString path_;
  std::unique_ptr<TakePart> take_part_;
};

}  // namespace tactus::workbench
