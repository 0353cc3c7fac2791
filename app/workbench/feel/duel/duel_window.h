// The window of a blind duel: what it takes, the strokes and the question, and the result. No page says which model is
// in the hand.
#pragma once

#include <QDialog>

#include "app/workbench/feel/duel/duel_controller.h"

class QButtonGroup;
class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QStackedWidget;

namespace tactus::workbench {

class DeviceSearch;
class NumberBox;
class StudyConnection;
class TubePad;

/// The way of a stroke: where the tip is, and where it should be at the prompted speed.
class PaceBar : public QWidget {
  Q_OBJECT

 public:
  explicit PaceBar(QWidget* parent = nullptr);

  void setWay(double from_mm, double to_mm);
  /// Nothing: outside of a stroke.
  void setPlaces(std::optional<double> tip_mm, std::optional<double> prompt_mm);

  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  double from_mm_ = 0;
  double to_mm_ = 1;
  std::optional<double> tip_mm_;
  std::optional<double> prompt_mm_;
};

class DuelWindow : public QDialog {
  Q_OBJECT

 public:
  DuelWindow(DuelController& duel, DeviceSession& device, StudyConnection& study, QWidget* parent = nullptr);

  /// Shows what a duel of `setup` takes; its stroke, question and rule are proposals. `who`: who feels, for the
  /// sign-off.
  void propose(DuelSetup setup, const QString& who);

 signals:
  /// The open model, which was felt, is approved by `who`.
  void approved(const QString& who, const tactus::editing::Felt& felt);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void done(int result) override;

 private:
  QWidget* makeSetup();
  QWidget* makeRun();
  QWidget* makeResult();
  void connectAll();
  void listDevices();
  void readSetup();
  void lookForUnfinished();
  void showForecast();
  void showState();
  void showMotion();
  void showResult();
  void begin();
  void resume();
  void tell(const base::Result<void>& begun);
  void say(const QString& sentence);
  QString instruction() const;
  QString repeatText() const;
  QString verdictText() const;
  QString detailsText() const;
  QString notFeltText() const;

  DuelController& duel_;
  DeviceSession& device_;
  StudyConnection& study_;
  DeviceSearch* search_;
  DuelSetup setup_;
  std::optional<store::StoredDuel> unfinished_;  ///< of the same two models
  QStackedWidget* pages_;
  QLabel* message_;

  QLabel* names_;
  QButtonGroup* question_;
  QComboBox* rule_;
  NumberBox* from_ = nullptr;
  NumberBox* to_ = nullptr;
  NumberBox* speed_ = nullptr;
  QComboBox* devices_;
  QLabel* forecast_;
  QLabel* kept_;
  QPushButton* begin_;
  QPushButton* resume_;

  QLabel* instruction_;
  QLabel* repeat_;
  PaceBar* pace_;
  TubePad* pad_;
  QWidget* answers_;
  QLabel* progress_;
  QPushButton* go_on_;

  QLabel* verdict_;
  QLabel* details_;
  QLineEdit* who_;
  QPushButton* approve_;
};

}  // namespace tactus::workbench
