// The page of the study's protocol: sections of settings, and below them what is stored and how to store the rest.
#pragma once

#include <QHash>
#include <QStringList>
#include <QWidget>
#include <array>
#include <functional>
#include <string>
#include <vector>

class QCheckBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QScrollArea;
class QVBoxLayout;
class QToolButton;

namespace tactus::workbench {

class Card;
class PrimaryButton;
class ProtocolController;
class ProtocolField;
struct ProtocolFieldSpec;

// One value of the protocol on the page: its name, the field, the way back to the stored value, and what is wrong.

// The parts of a session on the protocol's page: which of them there are, and in which order they come.

class PartList : public QWidget {
  Q_OBJECT

 public:
  /// `protocol` outlives this.
  explicit PartList(ProtocolController& protocol, QWidget* parent = nullptr);

 private:
  static constexpr int kParts = 3;
  struct Row {
    QLabel* number;
    QCheckBox* box;
    QToolButton* earlier;
    QToolButton* later;
  };

  QToolButton* makeArrow(const QString& text);
  void refreshState();
  void put(const QString& part, bool in);
  void move(int row, int by);

  ProtocolController& protocol_;
  QStringList in_;     ///< of the session, in its order
  QStringList shown_;  ///< these, then the others
  std::array<Row, kParts> rows_{};
};

/// How a value is entered.
struct ProtocolFieldSpec {
  enum class Kind { kNumber, kFlag, kWord, kText, kLongText };
  std::string name;  ///< session/study_protocol.h
  QString label;
  Kind kind = Kind::kText;
  QString unit;
  QString help;  ///< one line below; may be empty
  struct Word {
    QString value;
    QString label;
  };
  std::vector<Word> words;  ///< of kWord
};

class ProtocolField : public QWidget {
  Q_OBJECT

 public:
  ProtocolField(ProtocolController& protocol, ProtocolFieldSpec spec, QWidget* parent = nullptr);

  const std::string& name() const { return spec_.name; }
  /// What is wrong with the value; empty: nothing.
  QString trouble() const;

 private:
  QWidget* makeInput();
  void refreshState();

  ProtocolController& protocol_;
  const ProtocolFieldSpec spec_;
  QWidget* input_;
  QToolButton* undo_;
  QLabel* note_;
};

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
  void refreshState();
  void followLists();
  void followForces();
  void followLoad();
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
  QLabel* load_ = nullptr;
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
