// A text of the nurse's screens before a language is chosen: an id of the word book with its values.
#pragma once

#include <QString>
#include <QStringList>
#include <optional>

namespace tactus::workbench::nurse {

struct Phrase {
  QString id;                ///< of the word book; empty: `plain` is shown
  QStringList values;        ///< for %1, %2, …
  std::optional<int> count;  ///< for %n
  QString plain;             ///< a text of the study or of the person, the same in every language

  bool operator==(const Phrase&) const = default;
  bool isEmpty() const { return id.isEmpty() && plain.isEmpty(); }
};

inline Phrase phrase(const QString& id, const QStringList& values = {}) { return {id, values, std::nullopt, {}}; }
inline Phrase counted(const QString& id, int count) { return {id, {}, count, {}}; }
inline Phrase plain(const QString& text) { return {{}, {}, std::nullopt, text}; }

}  // namespace tactus::workbench::nurse
