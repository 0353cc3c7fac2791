// The screen before anything is open: the two ways to begin, and the files of the last times.
#pragma once

#include <QWidget>

class QPushButton;
class QVBoxLayout;

namespace tactus::workbench {

class RecentFiles;

class StartView : public QWidget {
  Q_OBJECT

 public:
  explicit StartView(const RecentFiles& recent, QWidget* parent = nullptr);

 signals:
  void newStudyRequested();
  void openStudyRequested();
  /// A model, or a study.
  void openRequested();
  void recentRequested(const QString& path);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void listRecent();

  const RecentFiles& recent_;
  QWidget* panel_;
  QWidget* recent_list_ = nullptr;
  QVBoxLayout* column_;
};

}  // namespace tactus::workbench
