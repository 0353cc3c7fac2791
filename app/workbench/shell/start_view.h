// The screen before anything is open: what can be tried, what can be begun, and what can be gone on with.
#pragma once

#include <QAbstractButton>
#include <QList>
#include <QWidget>

class QLabel;
class QProgressBar;
class QVBoxLayout;

namespace tactus::workbench {

/// One way to begin on the start screen: its name, and in small letters what it leads to.
class StartEntry : public QAbstractButton {
  Q_OBJECT

 public:
  StartEntry(const QString& name, const QString& note, QWidget* parent = nullptr);

  void setNote(const QString& note);
  const QString& note() const { return note_; }
  /// True: the entry that a newcomer should take, on the accent color.
  void setPrimary(bool primary);
  bool isPrimary() const { return primary_; }
  /// Notes in one line, cut in the middle where it is too long; otherwise they take as many lines as they need.
  void setOneLine(bool one_line);

  QSize sizeHint() const override;
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  QRect nameRect(int width) const;
  QRect noteRect(int width) const;

  QString note_;
  bool primary_ = false;
  bool one_line_ = false;
};

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
