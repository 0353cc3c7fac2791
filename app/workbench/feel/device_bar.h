// The device: which one, Start and Stop, how the hand takes the tube, and how it is doing. It says when the device is
// simulated.
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

  /// A model is open, so that there is something to feel.
  void setModelOpen(bool open);
  /// Shows `sentence` until the next start.
  void showFailure(const QString& sentence);
  /// Reads the state that changes while running: latency and rate.
  void showProgress();

 public slots:
  /// Starts on the chosen device, or stops.
  void toggle();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void listDevices();
  void showState();
  void showMessage();
  void chooseGrip();
  QString stateText() const;
  QString stateWord() const;
  void fitMessage();
  void setMessage(const QString& sentence, bool bad);

  FeelController& feel_;
  DeviceSearch& search_;
  QComboBox* devices_;
  QToolButton* look_;
  QPushButton* start_;
  QComboBox* grip_;
  NumberBox* zone_;
  QLabel* simulated_;
  ElidedLabel* state_;
  Card* message_card_;
  QLabel* message_;
  QPushButton* rearm_;
  QBoxLayout* line_ = nullptr;
  QString failure_;
  bool model_open_ = false;
  bool advises_ = false;  ///< the message is advice for a hand that has not pushed yet
};

}  // namespace tactus::workbench
