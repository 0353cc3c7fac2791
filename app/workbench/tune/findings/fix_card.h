// The chosen finding in full, its place, and one button for each fix.
#pragma once

#include <QFrame>
#include <memory>

class QGridLayout;
class QHBoxLayout;
class QLabel;
class QToolButton;

namespace tactus::workbench {

class FindingsController;
class RowStop;

class FixCard : public QFrame {
  Q_OBJECT

 public:
  explicit FixCard(FindingsController& findings, QWidget* parent = nullptr);
  ~FixCard() override;

 private:
  void showFinding();
  void showFixes();
  void showRules();

  FindingsController& findings_;
  QLabel* sentence_;
  QToolButton* here_;
  QToolButton* other_end_;
  QHBoxLayout* rules_;  ///< a button for each rule
  QLabel* note_;
  QWidget* fixes_;
  QGridLayout* grid_;
  std::unique_ptr<RowStop> places_stop_;  ///< the buttons that lead to a place or a rule
  std::unique_ptr<RowStop> fixes_stop_;
};

}  // namespace tactus::workbench
