// Ordinary mistakes in tables: what makes one, and which finding names it. For tests of session::dataFindings.
#pragma once

#include <algorithm>
#include <functional>
#include <gtest/gtest.h>
#include <ostream>
#include <string>
#include <vector>

#include "app/session/data_checks.h"

#include "tests/support/table_study.h"

namespace tactus::session {

using study::Answer;
using study::DataFinding;
using study::ForceJudgement;
using study::SpeedSample;
using study::Study;
using Severity = DataFinding::Severity;

inline const std::string kWho = "N3";

template <class Record>
void each(std::vector<Record>& records, const std::function<void(Record&)>& change) {
  for (auto& record : records) {
    if (record.participant == kWho) change(record);
  }
}
inline void eachSample(Study& study, const std::function<void(SpeedSample&)>& change) { each(study.speeds, change); }
inline void eachJudgement(Study& study, const std::function<void(ForceJudgement&)>& change) {
  each(study.judgements, change);
}
inline void eachAnswer(Study& study, const std::function<void(Answer&)>& change) { each(study.answers, change); }

template <class Record>
void removeRows(std::vector<Record>& records, const std::function<bool(const Record&)>& gone) {
  std::erase_if(records, [&gone](const Record& record) { return record.participant == kWho && gone(record); });
}

/// The rows of kWho at `from` become those of `source`, each changed by `change`.
template <class Record>
void copyFrom(std::vector<Record>& records, const std::string& source, const std::function<void(Record&)>& change) {
  std::vector<Record> copies;
  for (const auto& record : records) {
    if (record.participant != source) continue;
    copies.push_back(record);
    copies.back().participant = kWho;
    change(copies.back());
  }
  std::erase_if(records, [](const Record& record) { return record.participant == kWho; });
  records.insert(records.end(), copies.begin(), copies.end());
}

inline void setTerm(ForceJudgement& judgement, const std::string& term) {
  judgement.kind = ForceJudgement::Kind::kTerm;
  judgement.term = term;
}

inline std::string opposite(const std::string& term) {
  static const std::vector<std::string> terms = {"very_small", "small", "medium", "large", "very_large"};
  const auto place = std::find(terms.begin(), terms.end(), term) - terms.begin();
  return terms[static_cast<std::size_t>(4 - place)];
}

struct Mistake {
  std::string name;
  std::function<void(Study&)> make;
  std::string kind;
  Severity severity = Severity::kWarning;
};

inline std::ostream& operator<<(std::ostream& out, const Mistake& mistake) { return out << mistake.name; }

/// Makes the mistake in studies of three seeds.
inline void expectNamedOnce(const Mistake& mistake) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    Study study = support::tableStudy(seed);
    mistake.make(study);
    const auto findings = dataFindings(study);
    int named = 0;
    for (const auto& finding : findings) {
      EXPECT_EQ(finding.participant, kWho) << text(finding);
      if (name(finding.kind) != mistake.kind) continue;
      ++named;
      EXPECT_EQ(finding.severity, mistake.severity) << text(finding);
      EXPECT_GT(finding.cell.line.number, 1U);
      EXPECT_NE(finding.sentence.find(kWho), std::string::npos) << finding.sentence;
    }
    EXPECT_EQ(named, 1) << "seed " << seed << ", " << findings.size() << " findings"
                        << (findings.empty() ? "" : ": " + text(findings.front()));
    EXPECT_EQ(study::refuseData(findings).has_value(), mistake.severity != Severity::kRefused)
        << text(findings.front());
  }
}

inline std::string nameOf(const testing::TestParamInfo<Mistake>& test) { return test.param.name; }

}  // namespace tactus::session
