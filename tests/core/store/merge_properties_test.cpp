// Merges in any order, again, and with chains of corrections on both sides.
#include <filesystem>
#include <gtest/gtest.h>
#include <map>
#include <set>

#include "core/base/random.h"
#include "core/store/entries.h"
#include "core/store/model_versions.h"
#include "core/store/person_codes.h"
#include "core/store/persons.h"
#include "core/store/sessions.h"
#include "core/store/withdrawal.h"

#include "tests/core/store/merges.h"
#include "tests/core/store/naming_model.h"

namespace tactus::store {
namespace {

namespace fs = std::filesystem;

/// Chains of corrections on both sides of a merge, against a model that knows only what was written.
class MergedChains : public Merges, public testing::WithParamInterface<int> {
 protected:
  /// Lets a station correct what counts for it, `steps` times, with a clock that may be anywhere.
  void correct(const std::string& name, const std::string& from, base::Random& random, int steps) {
    copy(from, name);
    SampleRecords records(random.next());
    auto file = StudyFile::open(path(name), fast());
    ASSERT_TRUE(file);
    for (int step = 0; step < steps; ++step) {
      const auto there = *answers(*file);
      const auto& before = there[static_cast<std::size_t>(random.below(static_cast<int>(there.size())))];
      auto answer = records.answer(before.entry.session, before.item);
      answer.entry.supersedes = before.entry.id;
      answer.entry.when.utc_ms = 1'700'000'000'000 + random.below(20);
      ASSERT_TRUE(append(*file, answer));
    }
    ASSERT_TRUE(file->close());
  }
  /// Of each first answer the last correction that counts: of those without a correction the latest, then the highest
  /// id.
  static std::set<study::RecordId> expected(const std::vector<study::AnswerRecord>& history) {
    std::map<study::RecordId, const study::AnswerRecord*> by_id;
    std::set<study::RecordId> corrected;
    for (const auto& answer : history) {
      by_id[answer.entry.id] = &answer;
      if (answer.entry.supersedes) corrected.insert(*answer.entry.supersedes);
    }
    std::map<study::RecordId, const study::AnswerRecord*> latest;
    for (const auto& answer : history) {
      if (corrected.contains(answer.entry.id)) continue;
      const study::AnswerRecord* root = &answer;
      while (root->entry.supersedes) root = by_id.at(*root->entry.supersedes);
      const auto*& best = latest[root->entry.id];
      if (best == nullptr ||
          std::pair(best->entry.when.utc_ms, best->entry.id) < std::pair(answer.entry.when.utc_ms, answer.entry.id)) {
        best = &answer;
      }
    }
    std::set<study::RecordId> ids;
    for (const auto& [root, answer] : latest) ids.insert(answer->entry.id);
    return ids;
  }
  std::set<study::RecordId> current(const std::string& name) const {
    const auto file = StudyFile::open(path(name), fast());
    EXPECT_TRUE(file);
    std::set<study::RecordId> ids;
    const auto there = *answers(*file);
    for (const auto& answer : there) ids.insert(answer.entry.id);
    EXPECT_EQ(ids, expected(*answers(*file, {.history = true})));
    return ids;
  }
};

TEST_P(MergedChains, OneAnswerOfEachCountsInWhateverOrder) {
  SampleRecords shared(1);
  auto study = makeStudy(path("origin"), shared);
  for (int item = 1; item <= 3; ++item) ASSERT_TRUE(append(study.file, shared.answer(study.session.id, item)));
  ASSERT_TRUE(study.file.close());
  base::Random random(static_cast<std::uint64_t>(GetParam()));
  correct("a", "origin", random, 4);
  correct("b", "origin", random, 6);
  correct("c", "a", random, 3);
  copy("a", "abc");
  mergeInto("abc", "b");
  mergeInto("abc", "c");
  copy("c", "cba");
  mergeInto("cba", "b");
  mergeInto("cba", "a");
  EXPECT_EQ(current("abc").size(), 3U);
  EXPECT_EQ(current("cba"), current("abc"));
  // What was merged can be corrected further.
  correct("abcd", "abc", random, 4);
  EXPECT_EQ(current("abcd").size(), 3U);
  mergeInto("abcd", "cba");
  EXPECT_EQ(current("abcd").size(), 3U);
}

INSTANTIATE_TEST_SUITE_P(Seeds, MergedChains, testing::Range(1, 11));

TEST_F(Merges, ACorrectionOfACorrectionOnOneSideLeavesOneThatCounts) {
  SampleRecords records(1);
  auto study = makeStudy(path("a"), records);
  const auto root = records.answer(study.session.id);
  ASSERT_TRUE(append(study.file, root) && study.file.close());
  copy("a", "b");
  const auto correct = [&](const std::string& name, const study::RecordId& before, std::int64_t utc_ms) {
    auto file = StudyFile::open(path(name), fast());
    auto correction = records_.answer(study.session.id);
    correction.entry.when.utc_ms = utc_ms;
    correction.entry.supersedes = before;
    EXPECT_TRUE(append(*file, correction) && file->close());
    return correction;
  };
  const auto first = correct("a", root.entry.id, 1);
  const auto second = correct("a", first.entry.id, 2);
  const auto other = correct("b", root.entry.id, 3);
  mergeInto("a", "b");
  const auto file = StudyFile::open(path("a"));
  EXPECT_EQ(*answers(*file), std::vector{other});
}

/// Three stations that began with copies of one study, went on by themselves, and exchange their files.
class MergeProperties : public Merges, public testing::WithParamInterface<int> {
 protected:
  void SetUp() override {
    SampleRecords shared(1);
    auto study = makeStudy(path("origin"), shared);
    for (const char* code : {"calm-fox", "misty-lake", "quiet-drum"}) {
      const auto person = shared.person(code);
      const auto session = shared.session(person.id);
      ASSERT_TRUE(append(study.file, person) && append(study.file, session));
      ASSERT_TRUE(append(study.file, shared.answer(session.id)) && append(study.file, shared.stroke(session.id)));
    }
    ASSERT_TRUE(append(study.file, shared.model("first")) && study.file.close());
    base::Random random(static_cast<std::uint64_t>(GetParam()));
    for (const char* name : {"a", "b", "c"}) goOn(name, random);
  }

  /// A model with the experts that some of the persons are.
  static std::string modelOf(const StudyFile& file, base::Random& random) {
    std::vector<std::string> codes = {"printed-expert"};
    const auto there = *persons(file);
    for (const auto& person : there) {
      const bool is_twice = std::find(codes.begin(), codes.end(), person.code) != codes.end();
      if (random.below(2) == 0 && !is_twice) codes.push_back(person.code);
    }
    return namingModel(codes);
  }

  void goOn(const std::string& name, base::Random& random) {
    copy("origin", name);
    SampleRecords records(random.next());
    auto opened = StudyFile::open(path(name), fast());
    ASSERT_TRUE(opened);
    StudyFile& file = *opened;
    for (int step = 0; step < 10; ++step) {
      const auto there = *sessions(file);
      const auto session = there.empty() ? study::RecordId() : there[random.below(static_cast<int>(there.size()))].id;
      const int choice = random.below(there.empty() ? 1 : 6);
      if (choice == 0) {
        const auto person = records.person(random.uniform() < 0.3 ? "the-same" : study::toText(records.id()));
        const bool is_new = append(file, person).has_value();
        ASSERT_TRUE(!is_new || append(file, records.session(person.id)));
      } else if (choice == 1) {
        ASSERT_TRUE(append(file, records.stroke(session)));
      } else if (choice == 2) {
        const auto before = *answers(file, {.session = session});
        auto answer = records.answer(session);
        if (!before.empty()) answer.entry.supersedes = before.back().entry.id;
        EXPECT_TRUE(append(file, answer));
      } else if (choice == 3) {
        ASSERT_TRUE(append(file, records.judgement(session)));
      } else if (choice == 4) {
        auto model = records.model(modelOf(file, random));
        model.parent = (*latestModelVersion(file))->id;
        ASSERT_TRUE(append(file, model));
      } else {
        const auto persons_there = *persons(file);
        const auto person = persons_there[random.below(static_cast<int>(persons_there.size()))].id;
        if (random.uniform() < 0.5) {
          ASSERT_TRUE(withdraw(file, person, 5 + random.below(3)));
        } else {
          ASSERT_TRUE(recode(file, person,
                             "code-" + std::string(1, 'a' + static_cast<char>(random.below(26))) +
                                 study::toText(records.id()).substr(0, 6) + "x",
                             records.id(), random.below(9)));
        }
      }
    }
    ASSERT_TRUE(file.close());
  }
};

TEST_P(MergeProperties, OrderAndRepetitionDoNotMatter) {
  // A code of another person who withdrew refuses a merge, and then in every order.
  int refused = 0;
  const auto merge = [&](const char* into, const char* from) {
    const auto merged = tryMerge(into, from);
    if (merged) return true;
    EXPECT_EQ(merged.error().code, base::ErrorCode::kData) << merged.error().message();
    ++refused;
    return false;
  };
  const auto inOrder = [&](const char* into, const char* first, const char* second) {
    return merge(into, first) && merge(into, second);
  };
  copy("a", "ab_c");
  copy("b", "bc");
  copy("a", "a_bc");
  copy("c", "cba");
  const bool first = inOrder("ab_c", "b", "c");
  const bool second = merge("bc", "c") && merge("a_bc", "bc");
  const bool third = inOrder("cba", "b", "a");
  EXPECT_EQ(first, second);
  EXPECT_EQ(first, third);
  if (!first) return;
  const auto content = contentOf(path("ab_c"));
  EXPECT_EQ(contentOf(path("a_bc")), content);
  EXPECT_EQ(contentOf(path("cba")), content);
  for (const char* again : {"a", "b", "c", "bc", "cba"}) {
    const auto repeated = mergeInto("ab_c", again);
    EXPECT_TRUE(repeated.added.empty() || (repeated.added.size() == 1 && repeated.added[0].table == "import_log"));
  }
  EXPECT_EQ(contentOf(path("ab_c")), content);
  // No person who withdrew is an expert of any model.
  auto file = StudyFile::open(path("ab_c"), fast());
  EXPECT_EQ(erase(*file)->models, 0);
}

TEST_P(MergeProperties, WhoWithdrewNeverComesBack) {
  if (!tryMerge("a", "b") || !tryMerge("a", "c")) return;  // a code of another person who withdrew
  mergeInto("a", "origin");
  PlainSql sql(path("a"));
  EXPECT_EQ(sql.number("SELECT count(*) FROM person WHERE id IN (SELECT person_id FROM tombstone)"), 0);
  EXPECT_EQ(sql.number("SELECT count(*) FROM session WHERE person_id IN (SELECT person_id FROM tombstone)"), 0);
  EXPECT_EQ(sql.lines("PRAGMA foreign_key_check"), "");
  EXPECT_EQ(sql.text("PRAGMA integrity_check"), "ok");
  // Each withdrawal of any station counts here.
  for (const char* name : {"b", "c"}) {
    EXPECT_EQ(sql.complaint("ATTACH '" + path(name) + "' AS other"), "");
    EXPECT_EQ(
        sql.number("SELECT count(*) FROM other.tombstone WHERE person_id NOT IN (SELECT person_id FROM tombstone)"), 0);
    sql.complaint("DETACH other");
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, MergeProperties, testing::Range(1, 9));

}  // namespace
}  // namespace tactus::store
