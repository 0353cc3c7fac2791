// Adds stage Agree to the window: the labs, which lead from recordings to an agreed model.
#pragma once

#include <QObject>

#include "app/workbench/labs/data/corrections.h"
#include "app/workbench/labs/data/lab_data.h"
#include "app/workbench/labs/data/lab_model.h"
#include "app/workbench/labs/frame/lab_screen.h"
#include "app/workbench/labs/speed/speed_lab.h"

namespace tactus::workbench {

class MainWindow;
class SessionRun;
class SpeedLabView;

class LabParts : public QObject {
  Q_OBJECT

 public:
  LabParts(MainWindow& window, StudyConnection& study, const SessionRun& run);
  /// Takes the screen out of the window, because it shows what ends here.
  ~LabParts() override;

  LabData& data() { return data_; }
  LabModel& model() { return model_; }
  Corrections& corrections() { return corrections_; }
  LabScreen& screen() { return *screen_; }
  SpeedLab& speed() { return speed_; }
  SpeedLabView& speedView() { return *speed_view_; }

 private:
  LabData data_;
  LabModel model_{data_};
  Corrections corrections_{data_};
  SpeedLab speed_{data_};
  LabScreen* screen_;
  SpeedLabView* speed_view_;
};

}  // namespace tactus::workbench
