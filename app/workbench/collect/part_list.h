// The parts of a session on the protocol's page: which of them there are, and in which order they come.
#pragma once

#include <QStringList>
#include <QWidget>
#include <array>

class QCheckBox;
class QLabel;
class QToolButton;

namespace tactus::workbench {

class ProtocolController;

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

}  // namespace tactus::workbench
