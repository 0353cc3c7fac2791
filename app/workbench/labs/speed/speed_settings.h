// The settings of the speed lab: clusters, fuzziness, membership at the ramps' ends, trimming, centers, averaging.
#pragma once

#include "app/workbench/kit/cards.h"

class QComboBox;
class QLabel;

namespace tactus::workbench {

class SettingRow;
class SpeedLab;

class SpeedSettingsPanel : public Card {
  Q_OBJECT

 public:
  /// `lab` outlives this.
  explicit SpeedSettingsPanel(SpeedLab& lab, QWidget* parent = nullptr);

 private:
  void follow();

  SpeedLab& lab_;
  SettingRow* clusters_;
  SettingRow* fuzziness_;
  SettingRow* alpha_;
  SettingRow* trim_;
  QComboBox* centres_;
  QComboBox* averaging_;
  QLabel* note_;
};

}  // namespace tactus::workbench
