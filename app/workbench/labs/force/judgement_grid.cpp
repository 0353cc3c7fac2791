#include "app/workbench/labs/force/judgement_grid.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/workbench/base/display_text.h"
#include "elicitation/force/force_voting.h"

namespace tactus::workbench {
namespace {

const QString kNone = QStringLiteral("–");

// The name in JudgementFinding::check, by column.
const char* checkOf(int column) {
  switch (column) {
    case CheckTable::kReversals: return "monotonicity";
    case CheckTable::kHysteresis: return "hysteresis";
    case CheckTable::kRepeats: return "repeats";
    case CheckTable::kBlanks: return "blanks";
    case CheckTable::kThresholds: return "thresholds";
    case CheckTable::kAnswerTime: return "response_time";
    case CheckTable::kMotion: return "motion";
    default: return "";
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
    case CheckTable::kWho: return harmless(text(row.participant));
    case CheckTable::kReversals: return reversals(checks);
    case CheckTable::kHysteresis:
      return checks.hysteresis.index ? CheckTable::tr("%1 words").arg(numberText(*checks.hysteresis.index)) : kNone;
    case CheckTable::kRepeats: return repeats(checks.repeats);
    case CheckTable::kBlanks: return share(checks.blanks.false_alarms, checks.blanks.blanks);
    case CheckTable::kThresholds: return thresholds(checks.thresholds);
    case CheckTable::kAnswerTime:
      return checks.response_time.median_s ? quantityText(*checks.response_time.median_s, "s", 1) : kNone;
    case CheckTable::kMotion:
      return checks.motion.median_mm_s ? quantityText(*checks.motion.median_mm_s, "mm/s", 0) : kNone;
    default: return {};
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
    case Qt::DisplayRole: return shownCheck(at, column);
    case Qt::ToolTipRole: return finding == findings.end() ? QVariant() : text(finding->sentence);
    case kNotableRole: return finding != findings.end() && finding->notable;
    default: return {};
  }
}

namespace {

using Judged = study::ForceJudgement::Kind;

struct GridWords {
  Q_DECLARE_TR_FUNCTIONS(GridWords)
};

/// What was measured beside a judgement, a line each.
QString measured(const session::JudgedForce& judged) {
  const study::JudgementRecord& record = judged.record;
  QStringList lines;
  if (record.felt_n)
    lines << GridWords::tr("Felt, with the friction of the device: %1").arg(quantityText(*record.felt_n, "N"));
  if (record.delivered_share) {
    lines << GridWords::tr("Least share of the force in the hand: %1 %")
                 .arg(numberText(*record.delivered_share * 100, 0));
  }
  if (record.forward_mm > 0) {
    lines << GridWords::tr("Moved forward: %1 at %2")
                 .arg(quantityText(record.forward_mm, "mm", 0), quantityText(record.forward_speed_mm_s, "mm/s", 0));
  }
  if (record.response_s > 0) lines << GridWords::tr("Answer after %1").arg(quantityText(record.response_s, "s", 1));
  if (record.feel_again > 0) lines << GridWords::tr("Felt again: %1 times").arg(record.feel_again);
  if (record.catch_trial) lines << GridWords::tr("A hidden check; it is not counted.");
  if (!judged.counts && !record.catch_trial) lines << GridWords::tr("Not counted for the terms.");
  return lines.join(QLatin1Char('\n'));
}

}  // namespace

QString judgedText(const fuzzy::Variable& words, const session::JudgedWord& word) {
  switch (word.kind) {
    case Judged::kTerm:
      for (const fuzzy::Term& term : words.terms) {
        if (term.id == word.term) return labelOf(term);
      }
      return harmless(text(word.term));
    case Judged::kNotFelt: return GridWords::tr("not felt");
    case Judged::kBeyondPractice: return GridWords::tr("beyond practice");
    case Judged::kNoAnswer: return GridWords::tr("no answer");
  }
  return {};
}

session::JudgedWord judgedWord(const study::JudgementRecord& record) { return {record.kind, record.term}; }

std::vector<session::JudgedWord> offeredWords(const fuzzy::Variable& words,
                                              const std::vector<session::JudgedForce>& all,
                                              const session::JudgedForce& judged) {
  std::vector<session::JudgedWord> out;
  for (const fuzzy::Term& term : words.terms) out.push_back({Judged::kTerm, term.id});
  out.push_back({Judged::kNotFelt, {}});
  const bool goes_on = std::any_of(all.begin(), all.end(), [&](const session::JudgedForce& other) {
    return other.record.entry.session == judged.record.entry.session && other.record.series == judged.record.series &&
           other.record.step > judged.record.step;
  });
  if (!goes_on) out.push_back({Judged::kBeyondPractice, {}});
  out.push_back({Judged::kNoAnswer, {}});
  std::erase(out, judgedWord(judged.record));
  return out;
}

void JudgementGrid::setJudgements(const fuzzy::Variable& words, const std::vector<session::JudgedForce>& all,
                                  const std::string& series) {
  beginResetModel();
  words_ = words;
  judgements_.clear();
  rows_.clear();
  columns_.clear();
  for (const session::JudgedForce& one : all) {
    if (one.record.series != series) continue;
    judgements_.push_back(one);
    if (rows_.empty() || rows_.back() != one.participant) rows_.push_back(one.participant);
    columns_.push_back(one.record.commanded_n);
  }
  std::sort(columns_.begin(), columns_.end());
  const auto same = [](double a, double b) { return std::abs(a - b) < elicitation::kSameForceN; };
  columns_.erase(std::unique(columns_.begin(), columns_.end(), same), columns_.end());
  cells_.assign(rows_.size(), std::vector<std::vector<std::size_t>>(columns_.size()));
  std::size_t row = 0;
  for (std::size_t i = 0; i < judgements_.size(); ++i) {
    if (judgements_[i].participant != rows_[row]) ++row;
    cells_[row][static_cast<std::size_t>(columnOf(judgements_[i].record.commanded_n))].push_back(i);
  }
  endResetModel();
}

int JudgementGrid::columnOf(double force_n) const {
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (std::abs(columns_[i] - force_n) < elicitation::kSameForceN) return static_cast<int>(i);
  }
  return -1;
}

std::vector<const session::JudgedForce*> JudgementGrid::at(const QModelIndex& index) const {
  std::vector<const session::JudgedForce*> out;
  if (!index.isValid()) return out;
  for (const std::size_t i : cells_[static_cast<std::size_t>(index.row())][static_cast<std::size_t>(index.column())]) {
    out.push_back(&judgements_[i]);
  }
  return out;
}

int JudgementGrid::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int JudgementGrid::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(columns_.size());
}

QVariant JudgementGrid::data(const QModelIndex& index, int role) const {
  if (role != Qt::DisplayRole && role != Qt::ToolTipRole && role != Qt::AccessibleTextRole) return {};
  QStringList parts;
  for (const session::JudgedForce* judged : at(index)) {
    QString part = judgedText(words_, judgedWord(judged->record));
    if (role != Qt::ToolTipRole) {
      parts << part;
      continue;
    }
    for (const session::JudgedWord& before : judged->before) {
      part += QLatin1Char('\n') + tr("Corrected; before: %1").arg(judgedText(words_, before));
    }
    const QString rest = measured(*judged);
    parts << (rest.isEmpty() ? part : part + QLatin1Char('\n') + rest);
  }
  return parts.join(role == Qt::ToolTipRole ? QStringLiteral("\n\n") : QStringLiteral(", "));
}

QVariant JudgementGrid::headerData(int section, Qt::Orientation orientation, int role) const {
  if (role != Qt::DisplayRole) return {};
  if (orientation == Qt::Vertical) return harmless(text(participant(section)));
  return quantityText(forceN(section), words_.unit);
}

}  // namespace tactus::workbench
