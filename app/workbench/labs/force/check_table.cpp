#include "app/workbench/labs/force/check_table.h"

#include <algorithm>
#include <utility>

#include "app/workbench/base/display_text.h"

namespace tactus::workbench {
namespace {

const QString kNone = QStringLiteral("–");

// The name in JudgementFinding::check, by column.
const char* checkOf(int column) {
  switch (column) {
    case CheckTable::kReversals:
      return "monotonicity";
    case CheckTable::kHysteresis:
      return "hysteresis";
    case CheckTable::kRepeats:
      return "repeats";
    case CheckTable::kBlanks:
      return "blanks";
    case CheckTable::kThresholds:
      return "thresholds";
    case CheckTable::kAnswerTime:
      return "response_time";
    case CheckTable::kMotion:
      return "motion";
    default:
      return "";
  }
}

QString share(std::size_t part, std::size_t whole) {
  return whole == 0 ? kNone : CheckTable::tr("%1 of %2").arg(part).arg(whole);
}

QString reversals(const experiments::JudgementChecks& checks) {
  std::size_t pairs = 0;
  std::size_t falls = 0;
  for (const experiments::MonotonicityCheck& one : checks.monotonicity) {
    pairs += one.pairs;
    falls += one.violations;
  }
  return share(falls, pairs);
}

QString repeats(const experiments::RepeatCheck& check) {
  if (check.pairs == 0) return kNone;
  const QString kappa = check.kappa ? QStringLiteral("κ ") + numberText(*check.kappa) : QString();
  const QString near =
      check.within_one ? CheckTable::tr("%1 % near").arg(numberText(*check.within_one * 100, 0)) : QString();
  return kappa.isEmpty() || near.isEmpty() ? kappa + near : kappa + QStringLiteral(" · ") + near;
}

QString thresholds(const study::TermThresholds& found) {
  QStringList parts;
  for (const auto& one : found.threshold_n) parts << (one ? numberText(*one) : kNone);
  QString out = parts.join(QStringLiteral(" · ")) + QStringLiteral(" N");
  if (found.sigma_n) out += QStringLiteral(" ± ") + numberText(*found.sigma_n);
  return out;
}

QString shownCheck(const ParticipantChecks& row, int column) {
  const experiments::JudgementChecks& checks = row.checks;
  switch (column) {
    case CheckTable::kWho:
      return harmless(text(row.participant));
    case CheckTable::kReversals:
      return reversals(checks);
    case CheckTable::kHysteresis:
      return checks.hysteresis.index ? CheckTable::tr("%1 words").arg(numberText(*checks.hysteresis.index)) : kNone;
    case CheckTable::kRepeats:
      return repeats(checks.repeats);
    case CheckTable::kBlanks:
      return share(checks.blanks.false_alarms, checks.blanks.blanks);
    case CheckTable::kThresholds:
      return thresholds(checks.thresholds);
    case CheckTable::kAnswerTime:
      return checks.response_time.median_s ? quantityText(*checks.response_time.median_s, "s", 1) : kNone;
    case CheckTable::kMotion:
      return checks.motion.median_mm_s ? quantityText(*checks.motion.median_mm_s, "mm/s", 0) : kNone;
    default:
      return {};
  }
}

}  // namespace

std::vector<ParticipantChecks> judgementChecks(const fuzzy::Variable& words,
                                               const std::vector<session::JudgedForce>& all) {
  std::vector<std::string> ids;
  for (const fuzzy::Term& term : words.terms) ids.push_back(term.id);
  std::vector<ParticipantChecks> out;
  for (auto first = all.begin(); first != all.end();) {
    const auto last =
        std::find_if(first, all.end(), [&](const auto& one) { return one.participant != first->participant; });
    std::vector<study::JudgementRecord> records;
    std::transform(first, last, std::back_inserter(records), [](const auto& one) { return one.record; });
    // Each record holds now: what it corrected is not among them.
    for (study::JudgementRecord& record : records) record.entry.supersedes.reset();
    out.push_back({first->participant, experiments::checkJudgements(records, ids)});
    first = last;
  }
  return out;
}

CheckTable::CheckTable(QObject* parent)
    : LabTableModel(
          {{tr("Participant")},
           {tr("Falling words"), Qt::AlignHCenter, tr("Pairs of forces in which the larger one got the lower word.")},
           {tr("Rising – falling"), Qt::AlignHCenter,
            tr("Mean word in the rising series less that in the falling series, at equal forces.")},
           {tr("Repeats"), Qt::AlignHCenter,
            tr("Agreement of the answers to equal forces: kappa with quadratic weights, and the share within one "
               "word.")},
           {tr("Blanks felt"), Qt::AlignHCenter, tr("Blanks of 0 N that were judged as felt.")},
           {tr("Limits between words"), Qt::AlignHCenter,
            tr("Ordered probit: the force at which one word gives way to the next, and the spread of what is felt.")},
           {tr("Answer after"), Qt::AlignHCenter},
           {tr("Forward speed"), Qt::AlignHCenter}},
          parent) {}

void CheckTable::setChecks(std::vector<ParticipantChecks> checks) {
  beginResetModel();
  rows_ = std::move(checks);
  endResetModel();
}

QVariant CheckTable::cell(int row, int column, int role) const {
  const ParticipantChecks& at = rows_[static_cast<std::size_t>(row)];
  const auto& findings = at.checks.findings;
  const auto finding = std::find_if(findings.begin(), findings.end(),
                                    [column](const auto& one) { return one.check == checkOf(column); });
  switch (role) {
    case Qt::DisplayRole:
      return shownCheck(at, column);
    case Qt::ToolTipRole:
      return finding == findings.end() ? QVariant() : text(finding->sentence);
    case kNotableRole:
      return finding != findings.end() && finding->notable;
    default:
      return {};
  }
}

}  // namespace tactus::workbench
