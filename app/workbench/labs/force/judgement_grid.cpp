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

struct CheckWords {
  Q_DECLARE_TR_FUNCTIONS(CheckWords)
};

QString share(std::size_t part, std::size_t whole) {
  return whole == 0 ? kNone : CheckWords::tr("%1 of %2").arg(part).arg(whole);
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
      check.within_one ? CheckWords::tr("%1 % near").arg(numberText(*check.within_one * 100, 0)) : QString();
  return kappa.isEmpty() || near.isEmpty() ? kappa + near : kappa + QStringLiteral(" · ") + near;
}

QString thresholds(const study::TermThresholds& found) {
  QStringList parts;
  for (const auto& one : found.threshold_n) parts << (one ? numberText(*one) : kNone);
  QString out = parts.join(QStringLiteral(" · ")) + QStringLiteral(" N");
  if (found.sigma_n) out += QStringLiteral(" ± ") + numberText(*found.sigma_n);
  return out;
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

std::vector<Column<ParticipantChecks>> checkColumns() {
  using Row = ParticipantChecks;
  // `check`: the name in JudgementFinding::check.
  const auto column = [](const QString& head, const char* check,
                         QString (*text_of)(const experiments::JudgementChecks&),
                         const QString& tip = {}) -> Column<Row> {
    const auto finding = [check](const Row& row) {
      const auto& all = row.checks.findings;
      const auto found = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.check == check; });
      return found == all.end() ? nullptr : &*found;
    };
    return {head,
            [text_of](const Row& row) { return text_of(row.checks); },
            Qt::AlignHCenter,
            tip,
            {{Qt::ToolTipRole,
              [finding](const Row& row) {
                const auto* const found = finding(row);
                return found == nullptr ? QVariant() : text(found->sentence);
              }},
             {kNotableRole, [finding](const Row& row) {
                const auto* const found = finding(row);
                return found != nullptr && found->notable;
              }}}};
  };
  using Checks = const experiments::JudgementChecks&;
  return {
      {CheckWords::tr("Participant"), [](const Row& row) { return harmless(text(row.participant)); }},
      column(CheckWords::tr("Falling words"), "monotonicity", &reversals,
             CheckWords::tr("Pairs of forces in which the larger one got the lower word.")),
      column(
          CheckWords::tr("Rising – falling"), "hysteresis",
          [](Checks all) {
            return all.hysteresis.index ? CheckWords::tr("%1 words").arg(numberText(*all.hysteresis.index)) : kNone;
          },
          CheckWords::tr("Mean word in the rising series less that in the falling series, at equal forces.")),
      column(
          CheckWords::tr("Repeats"), "repeats", [](Checks all) { return repeats(all.repeats); },
          CheckWords::tr("Agreement of the answers to equal forces: kappa with quadratic weights, and the share within "
                         "one word.")),
      column(
          CheckWords::tr("Blanks felt"), "blanks",
          [](Checks all) { return share(all.blanks.false_alarms, all.blanks.blanks); },
          CheckWords::tr("Blanks of 0 N that were judged as felt.")),
      column(
          CheckWords::tr("Limits between words"), "thresholds", [](Checks all) { return thresholds(all.thresholds); },
          CheckWords::tr("Ordered probit: the force at which one word gives way to the next, and the spread of what is "
                         "felt.")),
      column(CheckWords::tr("Answer after"), "response_time",
             [](Checks all) {
               return all.response_time.median_s ? quantityText(*all.response_time.median_s, "s", 1) : kNone;
             }),
      column(CheckWords::tr("Forward speed"), "motion", [](Checks all) {
        return all.motion.median_mm_s ? quantityText(*all.motion.median_mm_s, "mm/s", 0) : kNone;
      })};
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

namespace {

/// The judgements of one cell, for one role.
QString cellText(const fuzzy::Variable& words, const std::vector<session::JudgedForce>& cell, bool tip) {
  QStringList parts;
  for (const session::JudgedForce& judged : cell) {
    QString part = judgedText(words, judgedWord(judged.record));
    if (!tip) {
      parts << part;
      continue;
    }
    for (const session::JudgedWord& before : judged.before) {
      part += QLatin1Char('\n') + GridWords::tr("Corrected; before: %1").arg(judgedText(words, before));
    }
    const QString rest = measured(judged);
    parts << (rest.isEmpty() ? part : part + QLatin1Char('\n') + rest);
  }
  return parts.join(tip ? QStringLiteral("\n\n") : QStringLiteral(", "));
}

}  // namespace

void JudgementGrid::setJudgements(const fuzzy::Variable& words, const std::vector<session::JudgedForce>& all,
                                  const std::string& series) {
  words_ = words;
  forces_n_.clear();
  for (const session::JudgedForce& one : all) {
    if (one.record.series == series) forces_n_.push_back(one.record.commanded_n);
  }
  std::sort(forces_n_.begin(), forces_n_.end());
  const auto same = [](double a, double b) { return std::abs(a - b) < elicitation::kSameForceN; };
  forces_n_.erase(std::unique(forces_n_.begin(), forces_n_.end(), same), forces_n_.end());
  std::vector<JudgedRow> rows;
  for (const session::JudgedForce& one : all) {
    if (one.record.series != series) continue;
    if (rows.empty() || rows.back().participant != one.participant) {
      rows.push_back({one.participant, std::vector<std::vector<session::JudgedForce>>(forces_n_.size())});
    }
    rows.back().cells[static_cast<std::size_t>(columnOf(one.record.commanded_n))].push_back(one);
  }
  std::vector<Column<JudgedRow>> columns;
  for (std::size_t i = 0; i < forces_n_.size(); ++i) {
    const auto cell = [this, i](bool tip) {
      return [this, i, tip](const JudgedRow& row) { return cellText(words_, row.cells[i], tip); };
    };
    columns.push_back({quantityText(forces_n_[i], words_.unit),
                       cell(false),
                       {},
                       {},
                       {{Qt::ToolTipRole, cell(true)}, {Qt::AccessibleTextRole, cell(false)}}});
  }
  setRowHeads([](const JudgedRow& row) { return harmless(text(row.participant)); });
  setTable(std::move(columns), std::move(rows));
}

int JudgementGrid::columnOf(double force_n) const {
  for (std::size_t i = 0; i < forces_n_.size(); ++i) {
    if (std::abs(forces_n_[i] - force_n) < elicitation::kSameForceN) return static_cast<int>(i);
  }
  return -1;
}

std::vector<const session::JudgedForce*> JudgementGrid::at(const QModelIndex& index) const {
  std::vector<const session::JudgedForce*> out;
  if (!index.isValid()) return out;
  for (const session::JudgedForce& one : row(index.row()).cells[static_cast<std::size_t>(index.column())]) {
    out.push_back(&one);
  }
  return out;
}

}  // namespace tactus::workbench
