#include "app/workbench/deliver/readiness.h"

#include <gtest/gtest.h>

namespace tactus::workbench {
namespace {

/// A model with nothing to say about it but that no bundle was made yet.
ReadinessFacts cleanFacts() {
  ReadinessFacts facts;
  facts.findings.current = true;
  facts.experts = 2;
  facts.default_force = QStringLiteral("0 N");
  facts.signed_by = QStringLiteral("S4");
  return facts;
}

ReadinessLine lineOf(const ReadinessFacts& facts, ReadinessTopic topic) {
  return readinessLines(facts)[static_cast<std::size_t>(topic)];
}

TEST(Readiness, HasALineWithASentenceAndAnActForEachTopic) {
  const auto lines = readinessLines(cleanFacts());
  ASSERT_EQ(lines.size(), kReadinessTopics);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    EXPECT_EQ(static_cast<std::size_t>(lines[i].topic), i);
    EXPECT_FALSE(lines[i].name.isEmpty());
    EXPECT_TRUE(lines[i].sentence.endsWith(QLatin1Char('.'))) << lines[i].sentence.toStdString();
    EXPECT_FALSE(lines[i].act.isEmpty());
  }
  EXPECT_TRUE(readinessSummary(lines).startsWith(QStringLiteral("1 thing"))) << "no bundle was made";
}

TEST(Readiness, OnlyAHoleThatNobodyAcceptedStopsABundle) {
  ReadinessFacts facts = cleanFacts();
  facts.findings.holes = {{"depth 5 to 6 mm", QStringLiteral("Depth 5 to 6 mm"), false}};
  EXPECT_EQ(lineOf(facts, ReadinessTopic::kHoles).state, Readiness::kBlocks);
  EXPECT_TRUE(readinessSummary(readinessLines(facts)).startsWith(QStringLiteral("1 thing")));
  facts.findings.holes[0].accepted = true;
  EXPECT_EQ(lineOf(facts, ReadinessTopic::kHoles).state, Readiness::kReady);
  EXPECT_TRUE(lineOf(facts, ReadinessTopic::kHoles).sentence.contains(QStringLiteral("0 N")));
}

TEST(Readiness, DoesNotSayThatThereIsNoHoleWhereTheSearchWasCutOff) {
  ReadinessFacts facts = cleanFacts();
  EXPECT_EQ(lineOf(facts, ReadinessTopic::kHoles).sentence, QStringLiteral("Every place has a force."));
  facts.findings.complete = false;
  EXPECT_EQ(lineOf(facts, ReadinessTopic::kHoles).state, Readiness::kLook);
  EXPECT_TRUE(lineOf(facts, ReadinessTopic::kHoles).sentence.contains(QStringLiteral("there may be more")));
}

TEST(Readiness, KnowsNothingBeforeTheLintHasEnded) {
  ReadinessFacts facts = cleanFacts();
  facts.findings.current = false;
  for (const auto topic :
       {ReadinessTopic::kHoles, ReadinessTopic::kForceSteps, ReadinessTopic::kConflicts, ReadinessTopic::kExpertsApart})
    EXPECT_EQ(lineOf(facts, topic).state, Readiness::kUnknown);
  EXPECT_EQ(readinessSummary(readinessLines(facts)), QStringLiteral("Looking…"));
}

TEST(Readiness, CountsConflictsAndExpertsApart) {
  ReadinessFacts facts = cleanFacts();
  facts.findings.conflicts = 2;
  facts.findings.apart = 3;
  facts.findings.most_apart = QStringLiteral("0.610 N");
  EXPECT_TRUE(lineOf(facts, ReadinessTopic::kConflicts).sentence.startsWith(QStringLiteral("2 pair")));
  const auto apart = lineOf(facts, ReadinessTopic::kExpertsApart);
  EXPECT_EQ(apart.state, Readiness::kLook);
  EXPECT_TRUE(apart.sentence.startsWith(QStringLiteral("At 3 place"))) << apart.sentence.toStdString();
  EXPECT_TRUE(apart.sentence.contains(QStringLiteral("0.610 N")));
  facts.experts = 1;
  facts.findings.apart = 0;
  EXPECT_EQ(lineOf(facts, ReadinessTopic::kExpertsApart).sentence, QStringLiteral("The model is of one expert."));
}

TEST(Readiness, SaysWhatIsKnownOfTheContracts) {
  ReadinessFacts facts = cleanFacts();
  EXPECT_EQ(lineOf(facts, ReadinessTopic::kContracts).state, Readiness::kReady) << "there is none";
  facts.contracts.proved = 2;
  EXPECT_EQ(lineOf(facts, ReadinessTopic::kContracts).state, Readiness::kReady);
  EXPECT_TRUE(lineOf(facts, ReadinessTopic::kContracts).sentence.contains(QStringLiteral("keeps 2 contract")));
  facts.contracts.open = 1;
  EXPECT_EQ(lineOf(facts, ReadinessTopic::kContracts).state, Readiness::kLook);
  EXPECT_TRUE(lineOf(facts, ReadinessTopic::kContracts).sentence.startsWith(QStringLiteral("Of 3 contract")));
  facts.contracts.broken = 1;
  facts.contracts.first_broken = QStringLiteral("More “Gel” never raises the force");
  EXPECT_EQ(lineOf(facts, ReadinessTopic::kContracts).state, Readiness::kLook);
  EXPECT_TRUE(lineOf(facts, ReadinessTopic::kContracts).sentence.contains(facts.contracts.first_broken));
  facts.contracts.current = false;
  EXPECT_EQ(lineOf(facts, ReadinessTopic::kContracts).state, Readiness::kUnknown);
}

TEST(Readiness, AsksForASignOffOfEdits) {
  ReadinessFacts facts = cleanFacts();
  facts.signed_by.reset();
  EXPECT_EQ(lineOf(facts, ReadinessTopic::kSignOff).state, Readiness::kLook) << "nobody has approved anything";
  EXPECT_TRUE(lineOf(facts, ReadinessTopic::kSignOff).sentence.startsWith(QStringLiteral("0 of ")));
  facts.edits = 1;
  EXPECT_EQ(lineOf(facts, ReadinessTopic::kSignOff).state, Readiness::kLook);
  EXPECT_TRUE(lineOf(facts, ReadinessTopic::kSignOff).sentence.contains(QStringLiteral("the last")));
  facts.signed_by = QStringLiteral("S4");
  EXPECT_EQ(lineOf(facts, ReadinessTopic::kSignOff).state, Readiness::kReady);
  EXPECT_TRUE(lineOf(facts, ReadinessTopic::kSignOff).sentence.startsWith(QStringLiteral("S4")));
  facts.signed_felt = false;
  EXPECT_EQ(lineOf(facts, ReadinessTopic::kSignOff).state, Readiness::kLook);
}

TEST(Readiness, NeverCallsSimulatedOrUnknownDataReady) {
  ReadinessFacts facts = cleanFacts();
  facts.simulated = true;
  EXPECT_EQ(lineOf(facts, ReadinessTopic::kOrigin).state, Readiness::kLook);
  facts.simulated = false;
  facts.origin_known = false;
  EXPECT_EQ(lineOf(facts, ReadinessTopic::kOrigin).state, Readiness::kLook);
}

TEST(Readiness, NamesWhoFeltNoForce) {
  ReadinessFacts facts = cleanFacts();
  facts.without_force = {QStringLiteral("calm-fox")};
  EXPECT_EQ(lineOf(facts, ReadinessTopic::kOrigin).state, Readiness::kLook);
  EXPECT_TRUE(lineOf(facts, ReadinessTopic::kOrigin).sentence.contains(QStringLiteral("VIRTUAL")));
  EXPECT_TRUE(lineOf(facts, ReadinessTopic::kOrigin).sentence.contains(QStringLiteral("calm-fox")));
}

TEST(Readiness, SaysStepsNotesAndSettingsAndCountsThemAsOpen) {
  ReadinessFacts facts = cleanFacts();
  facts.bundle = {QStringLiteral("ngt-bundle"), true, false};
  EXPECT_EQ(readinessSummary(readinessLines(facts)), QStringLiteral("Nothing open"));
  facts.findings.steps = 2;
  facts.findings.largest_step = QStringLiteral("0.124 N");
  facts.data_notes = 1;
  facts.build_notes = 8;
  facts.first_note = QStringLiteral("S4 has no strokes.");
  facts.unlike_published = {QStringLiteral("alpha"), QStringLiteral("m")};
  const auto said = [&](ReadinessTopic topic, const char* what) {
    const auto line = lineOf(facts, topic);
    EXPECT_EQ(line.state, Readiness::kLook) << line.sentence.toStdString();
    EXPECT_TRUE(line.sentence.contains(QLatin1String(what))) << line.sentence.toStdString();
  };
  said(ReadinessTopic::kForceSteps, "0.124 N");
  said(ReadinessTopic::kData, "1 note");
  said(ReadinessTopic::kData, "8 of the build");
  said(ReadinessTopic::kData, "S4 has no strokes.");
  said(ReadinessTopic::kMethod, "alpha, m");
  said(ReadinessTopic::kMethod, "not known");
  facts.newtons_unlike_published = QStringLiteral("0.055 N");
  said(ReadinessTopic::kMethod, "0.055 N");
  EXPECT_TRUE(readinessSummary(readinessLines(facts)).startsWith(QStringLiteral("3 thing")));
}

TEST(Readiness, TheChecksAreReadyWhenTheBundleOfThisModelHolds) {
  ReadinessFacts facts = cleanFacts();
  facts.bundle = {QStringLiteral("ngt-bundle"), true, false};
  EXPECT_EQ(lineOf(facts, ReadinessTopic::kChecks).state, Readiness::kReady);
  EXPECT_EQ(readinessSummary(readinessLines(facts)), QStringLiteral("Nothing open"));
  facts.bundle->old = true;
  EXPECT_EQ(lineOf(facts, ReadinessTopic::kChecks).state, Readiness::kLook);
  facts.bundle->holds = false;
  EXPECT_EQ(lineOf(facts, ReadinessTopic::kChecks).state, Readiness::kLook);
  EXPECT_TRUE(lineOf(facts, ReadinessTopic::kChecks).sentence.contains(QStringLiteral("ngt-bundle")));
}

}  // namespace
}  // namespace tactus::workbench
