// All rules of the expert as a list to filter, sort and edit, with the form for any rule.
#pragma once

#include <QWidget>
#include <vector>

class QComboBox;
class QKeyEvent;
class QLabel;
class QLineEdit;
class QTableView;
class QToolButton;

namespace tactus::workbench {

class Flash;
class Refresh;
class RuleController;
class RuleForm;
class RuleListModel;
class RuleListSieve;

class RuleListPane : public QWidget {
  Q_OBJECT

 public:
  explicit RuleListPane(RuleController& rules, QWidget* parent = nullptr);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void buildTable();
  void buildPlace();
  void connectAll();
  void refresh();
  void sync();
  void showSelected();
  void showPointed();
  bool answerWithKey(QKeyEvent* event);
  void copy();
  void paste();
  void showCount();
  void showActions();
  void fitRows();
  std::vector<std::size_t> chosen() const;
  void enable(bool enabled);
  void remove();
  void edit();
  void showRule(std::size_t rule);
  void openMenu(QPoint at);

  RuleController& rules_;
  RuleListModel* list_;
  RuleListSieve* sieve_;
  QLineEdit* text_;
  QComboBox* only_;
  QLabel* count_;
  QTableView* table_;
  QToolButton* add_;
  QToolButton* edit_;
  QToolButton* enable_;
  QToolButton* disable_;
  QToolButton* remove_;
  QToolButton* go_;
  Flash* flash_;
  RuleForm* form_;
  Refresh* refresh_;
  bool stale_ = true;     ///< rules changed after the list took them
  bool showing_ = false;  ///< the table takes over the selection of the program
};

}  // namespace tactus::workbench
