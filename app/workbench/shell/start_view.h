// The screen before a model is open.
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
  void openRequested();
  void recentRequested(const QString& path);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void listRecent();

  const RecentFiles& recent_;
  QPushButton* open_;
  QWidget* panel_;
  QWidget* recent_list_ = nullptr;
  QVBoxLayout* column_;
};

}  // namespace tactus::workbench
