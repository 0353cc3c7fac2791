// The page of the study's protocol: sections of settings, and below them what is stored and how to store the rest.
#pragma once

#include <QHash>
#include <QWidget>
#include <functional>

class QCheckBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QScrollArea;
class QVBoxLayout;

namespace tactus::workbench {

class Card;
class PrimaryButton;
class ProtocolController;
class ProtocolField;
struct ProtocolFieldSpec;

class ProtocolView : public QWidget {
  Q_OBJECT

 public:
  /// `author`: the name that a stored protocol bears; may be empty.
  ProtocolView(ProtocolController& protocol, std::function<QString()> author, QWidget* parent = nullptr);

 public slots:
  /// Brings the section of the research key into view.
  void showKey();
  /// Brings section `index` into view.
  void showSection(int index);

 signals:
  /// Back to the study's home.
  void left();

 private:
  QWidget* makeHead();
  QWidget* makeFoot();
  QVBoxLayout* addSection(const QString& title, const QString& note = {});
  void putField(QVBoxLayout& section, ProtocolFieldSpec spec);
  void addParts();
  void addSpeed();
  void addForces();
  void addQuestions();
  void addLanguages();
  void addDevice();
  void addKey();
  void offer(const QString& language, bool in);
  void follow();
  void followLists();
  void followForces();
  void followFoot();
  void store();
  void leave();

  ProtocolController& protocol_;
  const std::function<QString()> author_;
  QLabel* state_;
  QListWidget* index_;
  QScrollArea* scroll_;
  QVBoxLayout* column_;
  QList<Card*> sections_;
  QHash<QString, QCheckBox*> languages_;
  QHash<QString, ProtocolField*> consents_;
  QHash<QString, ProtocolField*> statements_;  ///< by language, instead of the general ones
  QLabel* ladder_ = nullptr;
  QLabel* key_state_ = nullptr;
  QLineEdit* key_ = nullptr;
  QLineEdit* key_again_ = nullptr;
  QLabel* key_trouble_ = nullptr;
  QPushButton* set_key_ = nullptr;
  QPushButton* remove_key_ = nullptr;
  QLabel* foot_;
  QLineEdit* reason_;
  QPushButton* discard_;
  PrimaryButton* store_;
};

}  // namespace tactus::workbench
