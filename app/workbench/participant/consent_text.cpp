#include "app/workbench/participant/consent_text.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "app/workbench/base/display_text.h"
#include "app/workbench/participant/kit/wordbook.h"

namespace tactus::workbench {
namespace {

struct ConsentWords {
  Q_DECLARE_TR_FUNCTIONS(ConsentWords)
};

using nurse::phrase;
using session::Block;

constexpr double kGravity = 9.81;  // m/s^2
constexpr int kMinuteStep = 5;

bool has(const ParticipantPlan& plan, Block block) {
  return std::find(plan.settings.blocks.begin(), plan.settings.blocks.end(), block) != plan.settings.blocks.end();
}

bool moves(const ParticipantPlan& plan) { return has(plan, Block::kSpeed) || has(plan, Block::kForce); }

/// The weight that pulls like the largest force, in g, upwards to tens.
int gramsOf(double force_n) { return static_cast<int>(std::ceil(force_n / kGravity * 100 - 1e-9)) * 10; }

void addLines(const QString& text, std::vector<nurse::Phrase>& out) {
  for (const QString& line : text.split(QLatin1Char('\n'), Qt::SkipEmptyParts)) out.push_back(nurse::plain(line));
}

QString textIn(const std::map<QString, QString>& texts, const nurse::Language& language) {
  const auto text = texts.find(language.id);
  return text == texts.end() ? QString() : text->second.trimmed();
}

void addStatements(const ParticipantPlan& plan, bool usability, std::vector<nurse::Phrase>& out) {
  const auto add = [&out](const char* id, const QStringList& values = {}) {
    out.push_back(phrase(QString::fromLatin1(id), values));
  };
  add(usability ? "u.purpose" : "con.purpose");
  if (!usability) {
    add(moves(plan) ? "con.what" : "con.what_questions");
    add("con.minutes", {QString::number(minutesOf(plan))});
    add("con.force", {QString::number(gramsOf(plan.force_cap_n))});
  }
  add("con.voluntary");
  add("con.stop");
  add(usability ? "u.data" : moves(plan) ? "con.data" : "con.data_questions");
  add("con.withdraw");
}

}  // namespace

std::vector<nurse::Phrase> consentParagraphs(const ParticipantPlan& plan, const nurse::Language& language,
                                             bool usability) {
  std::vector<nurse::Phrase> out;
  const QString statements = textIn(plan.statements, language);
  if (statements.isEmpty()) {
    addStatements(plan, usability, out);
  } else {
    addLines(statements, out);
  }
  addLines(textIn(plan.consent_texts, language), out);
  if (!plan.contact.isEmpty()) out.push_back(phrase(QStringLiteral("con.contact"), {plan.contact}));
  return out;
}

QString consentText(const ParticipantPlan& plan, const std::vector<nurse::Phrase>& paragraphs,
                    const nurse::Language& language) {
  const nurse::Wordbook words(plan.settings.about(), plan.settings.form);
  QStringList lines;
  for (const nurse::Phrase& paragraph : paragraphs) lines << words.say(paragraph, language);
  return lines.join(QLatin1Char('\n'));
}

int minutesOf(const ParticipantPlan& plan) {
  const double minutes = session::expectedMinutes(plan.settings);
  return static_cast<int>(std::ceil(minutes / kMinuteStep)) * kMinuteStep;
}

QString whyNoText(const ParticipantPlan& plan) {
  for (const QString& language : plan.languages) {
    if (textIn(plan.consent_texts, nurse::Language{language}).isEmpty())
      return ConsentWords::tr("The protocol has no text of the study in %1: whose study it is, and who approved it.")
          .arg(languageName(language));
  }
  return {};
}

QString whyNoSession(const ParticipantPlan& plan) {
  if (plan.simulated) return {};
  if (!plan.protocol) {
    return ConsentWords::tr(
        "The study has no protocol: a person must be told whose study it is and whom to ask. To try the screens "
        "without "
        "one: tactus-workbench --rehearse.");
  }
  if (const QString why = whyNoText(plan); !why.isEmpty()) return why;
  if (plan.contact.isEmpty()) {
    return ConsentWords::tr(
        "The protocol names nobody whom a participant can ask. To try the screens without a person: tactus-workbench "
        "--rehearse.");
  }
  return {};
}

}  // namespace tactus::workbench
