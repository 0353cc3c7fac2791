// The screen before anything is open: what can be tried, what can be begun, and what can be gone on with.
#pragma once

#include <QList>
#include <QWidget>

class QLabel;
class QProgressBar;
class QVBoxLayout;

namespace tactus::workbench {

class DemoMaker;
class RecentFiles;
class StartEntry;

class StartView : public QWidget {
  Q_OBJECT

 public:
  StartView(const RecentFiles& recent, const DemoMaker& demo, QWidget* parent = nullptr);

 signals:
  void demoRequested();
  void freshDemoRequested();
  void tourRequested();
  void guideRequested();
  void newStudyRequested();
  void newModelRequested();
  void tablesRequested();
  void importRequested();
  /// A model, or a study.
  void openRequested();
  void recentRequested(const QString& path);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QVBoxLayout* addColumn(const QString& title);
  StartEntry* addEntry(QVBoxLayout& column, const QString& name, const QString& note, void (StartView::*asked)());
  void buildTry();
  void buildStart();
  void buildContinue();
  void showDemo();
  void listRecent();

  const RecentFiles& recent_;
  const DemoMaker& demo_;
  QWidget* panel_;
  StartEntry* explore_ = nullptr;
  StartEntry* tour_ = nullptr;
  StartEntry* fresh_ = nullptr;
  QLabel* making_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QVBoxLayout* recent_column_ = nullptr;
  QList<QWidget*> recent_entries_;
};

}  // namespace tactus::workbench
