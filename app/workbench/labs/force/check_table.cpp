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

void CheckTable::setChecks(std::vector<ParticipantChecks> checks) {
  beginResetModel();
  rows_ = std::move(checks);
  endResetModel();
}

int CheckTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

QVariant CheckTable::data(const QModelIndex& index, int role) const {
  const ParticipantChecks& row = rows_[static_cast<std::size_t>(index.row())];
  const auto finding = [&] {
    return std::find_if(row.checks.findings.begin(), row.checks.findings.end(),
                        [&](const experiments::JudgementFinding& one) { return one.check == checkOf(index.column()); });
  };
  switch (role) {
    case Qt::DisplayRole:
      return shownCheck(row, index.column());
    case Qt::ToolTipRole:
      return finding() == row.checks.findings.end() ? QVariant() : text(finding()->sentence);
    case kNotableRole:
      return finding() != row.checks.findings.end() && finding()->notable;
    case Qt::TextAlignmentRole:
      return static_cast<int>((index.column() == kWho ? Qt::AlignLeft : Qt::AlignHCenter) | Qt::AlignVCenter);
    default:
      return {};
  }
}

QVariant CheckTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole && section == kWho) return static_cast<int>(Qt::AlignLeft | Qt::AlignVCenter);
  if (role == Qt::DisplayRole) {
    switch (section) {
      case kWho:
        return tr("Participant");
      case kReversals:
        return tr("Falling words");
      case kHysteresis:
        return tr("Rising – falling");
      case kRepeats:
        return tr("Repeats");
      case kBlanks:
        return tr("Blanks felt");
      case kThresholds:
        return tr("Limits between words");
      case kAnswerTime:
        return tr("Answer after");
      case kMotion:
        return tr("Forward speed");
      default:
        return {};
    }
  }
  if (role != Qt::ToolTipRole) return {};
  switch (section) {
    case kReversals:
      return tr("Pairs of forces in which the larger one got the lower word.");
    case kHysteresis:
      return tr("Mean word in the rising series less that in the falling series, at equal forces.");
    case kRepeats:
      return tr(
          "Agreement of the answers to equal forces: kappa with quadratic weights, and the share within one word.");
    case kBlanks:
      return tr("Blanks of 0 N that were judged as felt.");
    case kThresholds:
      return tr("Ordered probit: the force at which one word gives way to the next, and the spread of what is felt.");
    default:
      return {};
  }
}

}  // namespace tactus::workbench
