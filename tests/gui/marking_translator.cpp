#include "tests/gui/marking_translator.h"

#include <QRegularExpression>
#include <algorithm>

#include "tests/gui/translation_file.h"

namespace tactus::tests {
namespace {

QString keyOf(const QString& context, const QString& source) { return context + QLatin1Char('\n') + source; }

}  // namespace

MarkingTranslator::MarkingTranslator() {
  static const TranslationFile texts = textsOfTheSources();
  for (const auto& [text, translation] : texts) {
    contexts_.insert(text.context);
    texts_.insert(keyOf(text.context, text.source));
  }
}

QString MarkingTranslator::translate(const char* context, const char* source, const char* /*comment*/,
                                     int /*count*/) const {
  const QString of = QString::fromUtf8(context);
  const QString text = QString::fromUtf8(source);
  const bool qt = of.startsWith(QLatin1Char('Q')) && !contexts_.contains(of);
  if (text.isEmpty() || (!qt && !texts_.contains(keyOf(of, text)))) return {};
  // What is put in is outside: it was translated itself, or is data.
  static const QRegularExpression place(QStringLiteral("(%L?\\d+|%n)"));
  QString marked = text;
  return kOpen + marked.replace(place, kClose + QStringLiteral("\\1") + kOpen) + kClose;
}

QString unmarked(const QString& text) {
  QString out;
  int depth = 0;
  for (const QChar c : text) {
    // What stood on the two sides does not become one word.
    if (c == kOpen) {
      ++depth;
      out += QLatin1Char(' ');
    }
    if (depth == 0) out += c;
    if (c == kClose) depth = std::max(0, depth - 1);
  }
  return out.simplified();
}

}  // namespace tactus::tests
