// The conditions that a nurse can change during the placement: lubrication and neck flexion.
#pragma once

#include <QWidget>
#include <cstddef>

class QBoxLayout;
class QButtonGroup;
class QHBoxLayout;
class QLabel;
class QPushButton;

namespace tactus::workbench {

class FeelController;
class SceneController;

class PatientControls : public QWidget {
  Q_OBJECT

 public:
  PatientControls(SceneController& scene, FeelController& feel, QWidget* parent = nullptr);

  /// In `room` px: the neck takes a row of its own where one row is too wide, and the word Lubrication gives way where
  /// its choices need the room.
  void fit(int room);
  /// The least room, px.
  int leastWidth() const;

 private:
  void build();
  void showValues();
  void onValue(std::size_t input);

  SceneController& scene_;
  FeelController& feel_;
  QLabel* lubrication_;
  QWidget* terms_;  ///< one button per term of the lubrication
  QHBoxLayout* terms_layout_;
  QButtonGroup* term_buttons_;
  QPushButton* neck_;
  QBoxLayout* rows_ = nullptr;
  bool has_lubrication_ = false;
};

}  // namespace tactus::workbench
