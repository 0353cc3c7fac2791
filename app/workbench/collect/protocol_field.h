// One value of the protocol on the page: its name, the field, the way back to the stored value, and what is wrong.
#pragma once

#include <QStringList>
#include <QWidget>
#include <array>
#include <string>
#include <vector>

class QCheckBox;
class QLabel;
class QToolButton;

namespace tactus::workbench {

class ProtocolController;

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
  void follow();
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
  std::string name;  ///< session/protocol_values.h
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
  void follow();

  ProtocolController& protocol_;
  const ProtocolFieldSpec spec_;
  QWidget* input_;
  QToolButton* undo_;
  QLabel* note_;
};

}  // namespace tactus::workbench
