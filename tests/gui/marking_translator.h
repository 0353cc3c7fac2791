// A language for tests: each text that the program translates comes back between brackets, so that text which was never
// translated shows: `⟦Rule ⟧3⟦ says ⟧large`.
#pragma once

#include <QSet>
#include <QTranslator>

namespace tactus::tests {

inline constexpr QChar kOpen{0x27E6};   // ⟦
inline constexpr QChar kClose{0x27E7};  // ⟧

/// Marks texts that lupdate finds under the context which the program asks for, and those of Qt itself. One that is
/// asked for under another context would stay untranslated in every language, and is not marked.
class MarkingTranslator : public QTranslator {
 public:
  MarkingTranslator();

  bool isEmpty() const override { return false; }
  QString translate(const char* context, const char* source, const char* comment, int count) const override;

 private:
  QSet<QString> contexts_;
  QSet<QString> texts_;  ///< context and source, with a line break between them
};

/// What is left of `text` outside the brackets, with single spaces.
QString unmarked(const QString& text);

}  // namespace tactus::tests
