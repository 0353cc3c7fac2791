// Broken tables: each gives one sentence that says file, place, what was found and what was wanted.
#include <gtest/gtest.h>
#include <ostream>

#include "core/study/csv_tables.h"

#include "tests/core/study/study_folder.h"

namespace tactus::study {
namespace {

struct BrokenTable {
  std::string_view name;
  std::string_view file;
  std::string_view text;
  std::string_view sentence;  // after the folder's path
};

std::ostream& operator<<(std::ostream& out, const BrokenTable& broken) { return out << broken.name; }

class BrokenTables : public ::testing::TestWithParam<BrokenTable> {};

TEST_P(BrokenTables, AreRefusedInOneSentence) {
  const StudyFolder folder;
  folder.write("participants.csv", "participant,years_experience,category,handedness,weight,simulated\nP1,,,,,\n");
  folder.write(std::string(GetParam().file), GetParam().text);
  const auto read = readStudyFolder(folder.path());
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().message(), folder.path(std::string(GetParam().sentence)));
}

INSTANTIATE_TEST_SUITE_P(
    Study, BrokenTables,
    ::testing::Values(
        BrokenTable{"ParticipantTwice", "participants.csv",
                    "participant,years_experience,category,handedness,weight,simulated\nP1,,,,,\n\nP1,,,,,\n",
                    "participants.csv: line 4, column 'participant': found 'P1' again, wanted each participant once"},
        BrokenTable{"MissingColumn", "speeds.csv", "participant,level,stroke,time_s,sped_mm_s\nP1,slow,1,0,0\n",
                    "speeds.csv: header: found the columns 'participant', 'level', 'stroke', 'time_s', 'sped_mm_s', "
                    "wanted a column 'depth_mm'"},
        BrokenTable{"ColumnMisspelled", "judgements.csv", "participant,series,step,force,term\nP1,a,1,0.1,small\n",
                    "judgements.csv: header: found the columns 'participant', 'series', 'step', 'force', 'term', "
                    "wanted a column 'force_n' (force?)"},
        BrokenTable{"CodeInAnotherSpelling", "speeds.csv",
                    "participant,level,stroke,time_s,depth_mm,speed_mm_s\np-01,slow,1,0,0,0\n",
                    "speeds.csv: line 2, column 'participant': found 'p-01', wanted a participant of participants.csv: "
                    "'P1'?"},
        BrokenTable{"Flag", "participants.csv",
                    "participant,years_experience,category,handedness,weight,simulated\nP1,,,,,maybe\n",
                    "participants.csv: line 2, column 'simulated': found 'maybe', wanted 1 or true, 0 or false, or an "
                    "empty cell"},
        BrokenTable{"NegativeWeight", "participants.csv",
                    "participant,years_experience,category,handedness,weight,simulated\nP1,,,,-1,\n",
                    "participants.csv: line 2, column 'weight': found '-1', wanted a number of at least 0, or an empty "
                    "cell"},
        BrokenTable{"NoCode", "participants.csv",
                    "participant,years_experience,category,handedness,weight,simulated\n,,,,1,\n",
                    "participants.csv: line 2, column 'participant': found an empty cell, wanted the code of a "
                    "participant (merged cells? fill them down)"},
        BrokenTable{"CodeAsFormula", "participants.csv",
                    "participant,years_experience,category,handedness,weight,simulated\n=1+1,,,,1,\n",
                    "participants.csv: line 2, column 'participant': found '=1+1', wanted a name that does not begin "
                    "with = + - @, a tab or a carriage return"},
        BrokenTable{
            "CodeBehindALineEnd", "participants.csv",
            "participant,years_experience,category,handedness,weight,simulated\n\"\r=1\",,,,1,\n",
            "participants.csv: line 2, column 'participant': found '\\x0d=1', wanted a name that does not begin "
            "with = + - @, a tab or a carriage return"},
        BrokenTable{"TermAsFormula", "judgements.csv", "participant,series,step,force_n,term\nP1,up,1,0.1,-small\n",
                    "judgements.csv: line 2, column 'term': found '-small', wanted a name that does not begin with = + "
                    "- @, a tab or a carriage return"},
        BrokenTable{"Stranger", "speeds.csv",
                    "participant,level,stroke,time_s,depth_mm,speed_mm_s\nP1,slow,1,0,0,0\nP9,slow,1,0,0,0\n",
                    "speeds.csv: line 3, column 'participant': found 'P9', wanted a participant of participants.csv"},
        BrokenTable{"NanSpeed", "speeds.csv",
                    "participant,level,stroke,time_s,depth_mm,speed_mm_s\nP1,slow,1,0,0,nan\n",
                    "speeds.csv: line 2, column 'speed_mm_s': found 'nan', wanted a finite number; leave a row without "
                    "one out"},
        BrokenTable{"NoLevel", "speeds.csv", "participant,level,stroke,time_s,depth_mm,speed_mm_s\nP1,,1,0,0,1\n",
                    "speeds.csv: line 2, column 'level': found an empty cell, wanted the level that was asked for "
                    "(merged cells? fill them down)"},
        BrokenTable{"DecimalComma", "speeds.csv",
                    "participant,level,stroke,time_s,depth_mm,speed_mm_s\nP1,slow,1,0,0,1,5\n",
                    "speeds.csv: line 2: found 7 cells, wanted 6 as in the first line (decimal commas? then semicolons "
                    "between the cells)"},
        BrokenTable{"EmptyFile", "speeds.csv", "",
                    "speeds.csv: found an empty table, wanted a header line with the names of the columns"},
        BrokenTable{"StepNotInteger", "judgements.csv", "participant,series,step,force_n,term\nP1,ascending,1.5,.1,\n",
                    "judgements.csv: line 2, column 'step': found '1.5', wanted an integer"},
        BrokenTable{"StepTooLarge", "judgements.csv",
                    "participant,series,step,force_n,term\nP1,ascending,99999999999,.1,\n",
                    "judgements.csv: line 2, column 'step': found '99999999999', wanted an integer of at most 32 bits"},
        BrokenTable{"StepZero", "judgements.csv", "participant,series,step,force_n,term\nP1,ascending,0,.1,\n",
                    "judgements.csv: line 2, column 'step': found '0', wanted an integer from 1"},
        BrokenTable{"StepNegative", "judgements.csv", "participant,series,step,force_n,term\nP1,ascending,-1,.1,\n",
                    "judgements.csv: line 2, column 'step': found '-1', wanted an integer from 1"},
        BrokenTable{"StrokeZero", "speeds.csv",
                    "participant,level,stroke,time_s,depth_mm,speed_mm_s\nP1,slow,0,0,0,1\n",
                    "speeds.csv: line 2, column 'stroke': found '0', wanted an integer from 1"},
        BrokenTable{"NegativeForce", "judgements.csv", "participant,series,step,force_n,term\nP1,a,1,-0.1,small\n",
                    "judgements.csv: line 2, column 'force_n': found '-0.1', wanted a force of 0 N or more"},
        BrokenTable{"StepTwice", "judgements.csv",
                    "participant,series,step,force_n,term\nP1,ascending,1,.1,small\nP1,ascending,1,.1,large\n",
                    "judgements.csv: line 3, column 'step': found step 1 of this series again, wanted each step of a "
                    "series once for a participant"},
        BrokenTable{"InfiniteForce", "judgements.csv", "participant,series,step,force_n,term\nP1,a,1,inf,small\n",
                    "judgements.csv: line 2, column 'force_n': found 'inf', wanted a finite number"},
        BrokenTable{"Status", "answers.csv", "participant,form,item,term,status\nP1,f,1,large,done\n",
                    "answers.csv: line 2, column 'status': found 'done', wanted 'answered', 'skipped', 'cant_tell' or "
                    "'cleared'"},
        BrokenTable{"AnsweredWithoutTerm", "answers.csv", "participant,form,item,term,status\nP1,f,1,,answered\n",
                    "answers.csv: line 2, column 'term': found an empty cell, wanted a term, as the status is "
                    "'answered'"},
        BrokenTable{"TermWithoutAnswer", "answers.csv", "participant,form,item,term,status\nP1,f,1,large,skipped\n",
                    "answers.csv: line 2, column 'term': found 'large', wanted an empty cell, as the status is "
                    "'skipped'"},
        BrokenTable{"ItemTwice", "answers.csv",
                    "participant,form,item,term,status\nP1,f,7,large,answered\nP1,g,7,,skipped\nP1,f,7,,cleared\n",
                    "answers.csv: line 4, column 'item': found item 7 of this form again, wanted each item of a form "
                    "once for a participant"},
        BrokenTable{"RuleWithoutCondition", "rules.csv", "participant,depth,then,weight\nP1,,large,1\n",
                    "rules.csv: line 2, column 'depth': found a rule without a condition, wanted a term for one input "
                    "or more"},
        BrokenTable{"RuleWithoutThen", "rules.csv", "participant,depth,then,weight\nP1,stomach,,1\n",
                    "rules.csv: line 2, column 'then': found an empty cell, wanted the term that follows (merged "
                    "cells? fill them down)"},
        BrokenTable{"RuleWeight", "rules.csv", "participant,depth,then,weight\nP1,stomach,large,1.01\n",
                    "rules.csv: line 2, column 'weight': found '1.01', wanted a weight from 0 to 1, or an empty cell "
                    "for 1"},
        BrokenTable{"RuleWeightInPercent", "rules.csv", "participant,depth,then,weight\nP1,stomach,large,80\n",
                    "rules.csv: line 2, column 'weight': found '80', wanted a weight from 0 to 1, or an empty cell "
                    "for 1 (percent? divide by 100)"},
        BrokenTable{"RuleTwice", "rules.csv",
                    "participant,depth,then,weight\nP1,stomach,large,1\nP1,stomach,large,0.5\n",
                    "rules.csv: line 3, column 'then': found the same rule twice, wanted each rule once for a "
                    "participant"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(BrokenFolders, FolderMustExist) {
  const auto read = readStudyFolder("/nowhere/at-all");
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().message(),
            "/nowhere/at-all: found nothing of this name, wanted a folder with participants.csv");
}

TEST(BrokenFolders, FolderMustNotBeAFile) {
  const StudyFolder folder;
  folder.write("speeds.csv", "x\n");
  const auto read = readStudyFolder(folder.path("speeds.csv"));
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().message(),
            folder.path("speeds.csv") + ": found a file, wanted a folder with participants.csv");
}

TEST(BrokenFolders, ParticipantsMustBeThere) {
  const StudyFolder folder;
  const auto read = readStudyFolder(folder.path());
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().message(),
            folder.path() + ": found no participants.csv in it, wanted a folder with participants.csv");
}

TEST(BrokenFolders, NamedInputsNeedTheirColumns) {
  const auto table = base::CsvTable::parse("participant,lubricaton,then,weight\nP1,well,large,1\n", "rules.csv");
  ASSERT_TRUE(table);
  const auto rules = readRules(*table, {"lubrication"});
  ASSERT_FALSE(rules);
  EXPECT_NE(rules.error().message().find("wanted a column 'lubrication'"), std::string::npos);
}

}  // namespace
}  // namespace tactus::study
