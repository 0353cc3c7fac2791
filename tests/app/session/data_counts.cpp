// data_counts STUDIES: how often each kind of finding is said of well-made studies of simulated nurses, and what
// session::dataFindings takes on a study of 200 participants.
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <map>
#include <string>

#include "app/session/data_checks.h"
#include "app/session/study_source.h"

#include "tests/support/default_procedure.h"
#include "tests/support/table_study.h"

namespace {

using namespace tactus;

/// Some participants say their answers as rules, so that there are rules to look at.
void addRules(study::Study& study) {
  const auto items = session::knownForms(support::defaultProcedure()).front().items;
  for (const auto& answer : study.answers) {
    const auto& item = items[static_cast<std::size_t>(answer.item - 1)];
    study.rules.push_back({answer.participant, {}, item.conditions, answer.term, 1, {}});
  }
}

}  // namespace

int main(int argc, char** argv) {
  const int studies = argc > 1 ? std::atoi(argv[1]) : 100;
  std::map<std::string, int> counts;
  int made = 0;
  for (int seed = 1; made < studies; ++seed) {
    for (const int nurses : {4, 6, 12}) {
      for (const double noise : {0.0, 0.02, 0.1}) {
        auto study = support::tableStudy(static_cast<std::uint64_t>(seed), {.nurses = nurses, .noise = noise});
        addRules(study);
        ++made;
        for (const auto& finding : session::dataFindings(study)) {
          if (++counts[std::string(name(finding.kind))] < 4) std::cout << text(finding) << '\n';
        }
      }
    }
  }
  std::cout << made << " studies\n";
  for (const auto& [kind, count] : counts) std::cout << "  " << kind << ' ' << count << '\n';
  for (const double rows_per_s : {100.0, 1000.0}) {
    const auto large = support::tableStudy(1, {.nurses = 200, .rows_per_s = rows_per_s});
    const std::clock_t start = std::clock();
    const auto findings = session::dataFindings(large);
    const double taken_s = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    std::cout << "200 participants, " << large.speeds.size() << " rows: " << taken_s << " s of a processor, findings "
              << findings.size() << '\n';
  }
}
