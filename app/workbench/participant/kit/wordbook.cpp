#include "app/workbench/participant/kit/wordbook.h"

#include <string_view>

#include "core/base/check.h"
#include "questionnaires/questionnaire.h"

namespace tactus::workbench::nurse {

QString idOf(Language language) {
  switch (language) {
    case Language::kEnglish: return QStringLiteral("en");
    case Language::kTraditionalChinese: return QStringLiteral("zh-Hant");
    case Language::kSimplifiedChinese: break;
  }
  return QStringLiteral("zh-Hans");
}

std::optional<Language> languageWithId(const QString& id) {
  for (const Language language : kLanguages) {
    if (idOf(language) == id) return language;
  }
  return std::nullopt;
}

QStringList fontFamilies(Language language) {
  const QString latin = QStringLiteral("DejaVu Sans");
  switch (language) {
    case Language::kEnglish: return {latin};
    case Language::kTraditionalChinese: return {QStringLiteral("Noto Sans CJK TC"), latin};
    case Language::kSimplifiedChinese: break;
  }
  return {QStringLiteral("Noto Sans CJK SC"), latin};
}

std::string_view stringsFile();

namespace {

// A text with the count 1, if the language has a form of its own for it.
QString oneOf(const QString& id) { return id + QStringLiteral(".one"); }

}  // namespace

Wordbook::Wordbook() {
  const std::string_view file = stringsFile();
  const QStringList lines =
      QString::fromUtf8(file.data(), static_cast<qsizetype>(file.size())).split(QLatin1Char('\n'), Qt::SkipEmptyParts);
  bool header = true;
  for (const QString& line : lines) {
    if (line.startsWith(QLatin1Char('#'))) continue;
    const QStringList fields = line.split(QLatin1Char('\t'));
    TACTUS_CHECK(fields.size() == 1 + static_cast<qsizetype>(kLanguages.size()));
    if (header) {
      for (std::size_t i = 0; i < kLanguages.size(); ++i)
        TACTUS_CHECK(fields[static_cast<qsizetype>(i) + 1] == idOf(kLanguages[i]));
      header = false;
      continue;
    }
    TACTUS_CHECK(!texts_.contains(fields[0]));
    for (std::size_t i = 0; i < kLanguages.size(); ++i)
      add(fields[0], kLanguages[i], fields[static_cast<qsizetype>(i) + 1]);
  }
  for (const Language language : kLanguages) addForms(language);
}

void Wordbook::add(const QString& id, Language language, const QString& text) {
  if (!texts_.contains(id)) ids_ << id;
  texts_[id][static_cast<std::size_t>(language)] = text;
}

void Wordbook::addForms(Language language) {
  const std::string code = idOf(language).toStdString();
  const auto put = [&](const std::string& id, const std::string& text) {
    add(QString::fromStdString(id), language, QString::fromStdString(text));
  };
  const procedure::Procedure& about = *procedure::defaultProcedure();
  const auto force = questionnaires::composedWording(about, about.forms.front().id, code);
  const auto usability = questionnaires::questionnaire(about, "usability-v1", code);
  TACTUS_CHECK(force.has_value() && usability.has_value());
  put("q.instructions", force->instructions);
  for (const auto& [condition, text] : force->phrases) put("q." + condition.input + '.' + condition.term, text);
  put("q.question", force->question);
  for (const auto& [term, text] : force->answers) put("w." + term, text);
  for (const auto& [number, text, block] : usability->questions) put("u." + std::to_string(number), text);
  put("u.low", usability->choices.front().label);
  put("u.high", usability->choices.back().label);
}

QString Wordbook::say(const Phrase& phrase, Language language) const {
  if (phrase.id.isEmpty()) return phrase.plain;
  const bool one = phrase.count == 1 && texts_.contains(oneOf(phrase.id));
  const auto found = texts_.constFind(one ? oneOf(phrase.id) : phrase.id);
  TACTUS_CHECK(found != texts_.constEnd());
  QString text = found.value()[static_cast<std::size_t>(language)];
  if (phrase.count) text.replace(QStringLiteral("%n"), QString::number(*phrase.count));
  for (const QString& value : phrase.values) text = text.arg(value);
  return text;
}

}  // namespace tactus::workbench::nurse
