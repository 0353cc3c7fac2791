// The controls of the device: the choice of the device, Start and Stop, the grip, and the state. A simulated device is
// labelled as such.
#pragma once

#include <QWidget>

class QBoxLayout;
class QComboBox;
class QLabel;
class QPushButton;
class QToolButton;

namespace tactus::workbench {

class Card;
class DeviceSearch;
class ElidedLabel;
class FeelController;
class NumberBox;

class DeviceBar : public QWidget {
  Q_OBJECT

 public:
  DeviceBar(FeelController& feel, DeviceSearch& search, QWidget* parent = nullptr);

  /// Whether a model is open and can be felt.
  void setModelOpen(bool open);
  /// True: after the start one chip stands for device and grip; a click on it shows them.
  void setFoldable(bool foldable);
  /// Shows `sentence` until the next start.
  void showFailure(const QString& sentence);
  /// Reads the values that change during a run: latency and rate.
  void showProgress();

 public slots:
  /// Starts on the chosen device, or stops it.
  void toggle();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void listDevices();
  void showState();
  void showMessage();
  void showChoice();
  void chooseGrip();
  QString stateText() const;
  QString stateWord() const;
  void fitLine();
  void fitMessage();
  void setMessage(const QString& sentence, bool bad);

  FeelController& feel_;
  DeviceSearch& search_;
  QComboBox* devices_;
  QToolButton* look_;
  QToolButton* chip_;  ///< in the place of the choice of device and grip
  QPushButton* start_;
  QComboBox* grip_;
  NumberBox* zone_;
  QLabel* simulated_;
  ElidedLabel* state_;
  Card* message_card_;
  QLabel* message_;
  QPushButton* rearm_;
  QPushButton* again_;  ///< starts once more after a failure
  QBoxLayout* line_ = nullptr;
  QString failure_;
  bool starting_ = false;  ///< by `toggle`, and not running yet
  bool model_open_ = false;
  bool foldable_ = false;
  bool advises_ = false;  ///< the message asks the user to push
};

}  // namespace tactus::workbench
