// The screen of stage Build: the labs behind tabs, with what is being computed, and undo.
#pragma once

#include <QHash>
#include <QTimer>
#include <QWidget>
#include <vector>

class QLabel;
class QPushButton;
class QStackedWidget;
class QTabBar;
class QToolButton;

namespace tactus::workbench {

class Computation;
class LabData;
class SettingsPrice;
class UndoSource;

class LabScreen : public QWidget {
  Q_OBJECT

 public:
  /// `lab_data` outlives this.
  explicit LabScreen(LabData& lab_data, QWidget* parent = nullptr);

  /// Adds a lab behind a tab. `undo`: what Ctrl+Z takes back while the lab is in front; may be null.
  void addLab(const QString& title, QWidget* lab, UndoSource* undo);
  /// Says what `work` is doing while it runs, with a button that cancels it: what the work itself says, or `doing`,
  /// e.g. `Clustering the speeds`.
  void watch(Computation& work, const QString& doing);
  /// Something short beside the watched work: it counts for `isBusy` without a text.
  void watch(std::function<bool()> busy) { short_work_.push_back(std::move(busy)); }
  /// Shows what the last change of the settings does to the force, below the tabs.
  void showPrice(SettingsPrice& price);
  /// Puts the lab with this widget in front.
  void reveal(QWidget* lab);
  QList<QWidget*> labs() const;
  /// The study is being read, or something that is watched is computed.
  bool isBusy() const;

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  struct Watched {
    Computation* work;
    QString doing;
  };
  UndoSource* undo() const;
  void followUndo();
  void followWork();
  void followStudy();

  LabData& data_;
  QTabBar* tabs_;
  QLabel* state_;
  QPushButton* cancel_;
  QToolButton* undo_;
  QToolButton* redo_;
  QLabel* price_;
  SettingsPrice* settings_price_ = nullptr;
  QLabel* failure_;
  QPushButton* read_again_;
  QStackedWidget* pages_;
  QHash<QWidget*, UndoSource*> undo_of_;
  std::vector<Watched> watched_;
  std::vector<std::function<bool()>> short_work_;
  bool said_ = false;  ///< what is running is on the screen
  QTimer patience_;    ///< what ends soon is not worth a word
};

}  // namespace tactus::workbench
