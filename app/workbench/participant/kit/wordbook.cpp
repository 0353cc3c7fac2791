#include "app/workbench/participant/kit/wordbook.h"

#include <algorithm>
#include <set>

#include "core/base/check.h"
#include "questionnaires/questionnaire.h"

namespace tactus::workbench::nurse {
namespace {

constexpr auto kTool = "tool";  // what is inserted, of each procedure

}  // namespace

std::vector<QString> languagesOf(const procedure::Procedure& procedure) {
  std::vector<QString> out;
  const auto tool = procedure.words.find(kTool);
  for (const std::string& language : procedure.languages) {
    if (tool == procedure.words.end() || tool->second.contains(language))
      out.push_back(QString::fromStdString(language));
  }
  return out;
}

QStringList fontFamilies(const Language& language) {
  const QString latin = QStringLiteral("DejaVu Sans");
  if (language == Language::kTraditionalChinese) return {QStringLiteral("Noto Sans CJK TC"), latin};
  if (language == Language::kSimplifiedChinese) return {QStringLiteral("Noto Sans CJK SC"), latin};
  return {latin};
}

std::string_view stringsFile();

namespace {

// What is inserted stands in the texts as this.
constexpr auto kToolPlace = "%tool";

// A text with the count 1, if the language has a form of its own for it.
QString oneOf(const QString& id) { return id + QStringLiteral(".one"); }

/// What an item says before it asks: where the wording has no order, the place of the tip last. Nothing if the wording
/// gives it as a whole.
std::optional<std::string> situationOf(questionnaires::Wording wording, const procedure::Procedure& procedure,
                                       const study::FormItem& item) {
  if (wording.item(item.number) != nullptr) return std::nullopt;
  wording.question.clear();
  if (wording.order.empty()) {
    wording.order = procedure.inputIds();
    std::rotate(wording.order.begin() + static_cast<std::ptrdiff_t>(procedure.way()),
                wording.order.begin() + static_cast<std::ptrdiff_t>(procedure.way()) + 1, wording.order.end());
  }
  auto sentence = wording.sentence(item.conditions);
  TACTUS_CHECK(sentence.has_value());  // the pack was read
  sentence->resize(sentence->size() - wording.joiner.size());
  return sentence;
}

}  // namespace

Wordbook::Wordbook(const procedure::Procedure& procedure, std::string_view form)
    : first_(QString::fromStdString(procedure.languages.front())) {
  addStrings();
  addProcedure(procedure);
  const study::Form* const asked = procedure.form(form);
  std::set<QString> languages;
  for (const Language& language : kLanguages) languages.insert(language.id);
  for (const std::string& language : procedure.languages) languages.insert(QString::fromStdString(language));
  for (const QString& language : languages) {
    addForm(procedure, asked != nullptr ? *asked : procedure.forms.front(), language);
    addUsability(procedure, language);
  }
}

void Wordbook::addStrings() {
  const std::string_view file = stringsFile();
  const QStringList lines =
      QString::fromUtf8(file.data(), static_cast<qsizetype>(file.size())).split(QLatin1Char('\n'), Qt::SkipEmptyParts);
  bool header = true;
  for (const QString& line : lines) {
    if (line.startsWith(QLatin1Char('#'))) continue;
    const QStringList fields = line.split(QLatin1Char('\t'));
    TACTUS_CHECK(fields.size() == 1 + static_cast<qsizetype>(kLanguages.size()));
    TACTUS_CHECK(!texts_.contains(fields[0]));
    for (std::size_t i = 0; i < kLanguages.size(); ++i) {
      const QString& field = fields[static_cast<qsizetype>(i) + 1];
      if (header) TACTUS_CHECK(field == kLanguages[i].id);
      if (!header) add(fields[0], kLanguages[i].id, field);
    }
    header = false;
  }
}

void Wordbook::addProcedure(const procedure::Procedure& procedure) {
  for (const auto& [id, texts] : procedure.words) {
    for (const auto& [language, text] : texts)
      add(QString::fromStdString(id), QString::fromStdString(language), QString::fromStdString(text));
  }
}

void Wordbook::add(const QString& id, const QString& language, const QString& text) {
  if (!texts_.contains(id)) ids_ << id;
  texts_[id][language] = text;
}

void Wordbook::addForm(const procedure::Procedure& procedure, const study::Form& form, const QString& language) {
  const std::string code = language.toStdString();
  const auto put = [&](const std::string& id, const std::string& text) {
    add(QString::fromStdString(id), language, QString::fromStdString(text));
  };
  const auto whole = questionnaires::questionnaire(procedure, form.id, code);
  if (!whole) return;  // not in this language
  const auto composed = questionnaires::composedWording(procedure, form.id, code);
  put("q.instructions", whole->instructions);
  for (const auto& choice : whole->choices) put("w." + choice.value, choice.label);
  for (std::size_t i = 0; i < form.items.size(); ++i) {
    const std::string number = std::to_string(form.items[i].number);
    const auto situation = composed ? situationOf(*composed, procedure, form.items[i]) : std::nullopt;
    put("q.item." + number, situation.value_or(whole->questions[i].text));
    put("q.ask." + number, situation ? composed->question : std::string());
  }
}

void Wordbook::addUsability(const procedure::Procedure& procedure, const QString& language) {
  const auto usability = questionnaires::questionnaire(procedure, "usability-v1", language.toStdString());
  if (!usability) return;
  const auto put = [&](const QString& id, const std::string& text) { add(id, language, QString::fromStdString(text)); };
  for (const auto& [number, text, block] : usability->questions) put(QStringLiteral("u.%1").arg(number), text);
  put(QStringLiteral("u.low"), usability->choices.front().label);
  put(QStringLiteral("u.high"), usability->choices.back().label);
}

QString Wordbook::text(const Texts& texts, const Language& language) const {
  for (const QString& wanted : {language.id, first_, Language::kEnglish.id}) {
    if (const auto found = texts.constFind(wanted); found != texts.constEnd()) return *found;
  }
  return texts.isEmpty() ? QString() : *texts.constBegin();
}

QString Wordbook::say(const Phrase& phrase, const Language& language) const {
  if (phrase.id.isEmpty()) return phrase.plain;
  const bool one = phrase.count == 1 && texts_.contains(oneOf(phrase.id));
  const auto found = texts_.constFind(one ? oneOf(phrase.id) : phrase.id);
  TACTUS_CHECK(found != texts_.constEnd());
  QString said = text(*found, language);
  if (said.contains(QLatin1String(kToolPlace)))
    said.replace(QLatin1String(kToolPlace), text(texts_.value(QString::fromUtf8(kTool)), language));
  if (phrase.count) said.replace(QStringLiteral("%n"), QString::number(*phrase.count));
  for (const QString& value : phrase.values) said = said.arg(value);
  return said;
}

}  // namespace tactus::workbench::nurse
