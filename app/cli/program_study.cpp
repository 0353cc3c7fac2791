// The command line of `tactus study`.
#include <cmath>

#include "app/cli/command_line.h"
#include "app/cli/study_commands.h"
#include "app/cli/study_seal.h"
#include "app/planning/study_plan.h"
#include "app/session/simulated_study.h"

namespace tactus::cli {
namespace {

void addFile(CLI::App& command, std::string& file) {
  command.add_option("FILE", file, "Study file")->required()->check(notEmpty());
}

/// What the studies that a command simulates are about.
CLI::Option* addSimulatedPack(CLI::App& command, std::string& pack) {
  return command
      .add_option("--pack", pack,
                  "What a study to come is about: a folder with a pack, or a procedure that `tactus pack show` lists; "
                  "default: the first of these")
      ->check(notEmpty());
}

CLI::Validator whole(int low, int high) {
  return numberThat("a whole number from " + std::to_string(low) + " to " + std::to_string(high),
                    [low, high](double x) { return x >= low && x <= high && x == std::floor(x); });
}

void addPackCommands(CLI::App& app, Chosen& chosen) {
  CLI::App& pack = *app.add_subcommand("pack", "Procedures as data: make, check, show, preview");
  pack.require_subcommand(1);
  const auto addPack = [](CLI::App& command, PackOptions& o, const char* what) {
    return command.add_option("PACK", o.pack, what)->check(notEmpty());
  };
  constexpr const char* kAny = "Folder with procedure.json, or a procedure that the program carries";
  addCommand(pack, chosen, "new", "A small complete pack to begin with", packNew,
             [addPack](CLI::App& command, PackOptions& o) {
               addPack(command, o, "Folder to make")->required();
               addJson(command, o.json);
             });
  addCommand(pack, chosen, "check", "What is wrong with a pack, or what it holds", packCheck,
             [addPack](CLI::App& command, PackOptions& o) {
               addPack(command, o, kAny)->required();
               addJson(command, o.json);
             });
  addCommand(pack, chosen, "show", "Inputs, words, regions and items of a pack; alone: the procedures of the program",
             packShow, [addPack](CLI::App& command, PackOptions& o) {
               addPack(command, o, kAny);
               command.add_flag("--texts", o.texts,
                                "The ids of the participant's screens with their words, as a table");
               addJson(command, o.json);
             });
  addCommand(pack, chosen, "preview", "Its forms as pages and on paper, its pictures with each region lit", packPreview,
             [addPack](CLI::App& command, PackOptions& o) {
               addPack(command, o, kAny)->required();
               command.add_option("--out", o.out, "Folder for the files")->required()->check(notEmpty());
               addJson(command, o.json);
             });
}

}  // namespace

void addStudyCommands(CLI::App& app, Chosen& chosen) {
  addPackCommands(app, chosen);
  CLI::App& study = *app.add_subcommand("study", "Study files: make, look into, check, merge, import, export");
  study.require_subcommand(1);
  addCommand(study, chosen, "new", "Make a study file", studyNew, [](CLI::App& command, StudyNewOptions& o) {
    addFile(command, o.file);
    command.add_option("--name", o.name, "Name of the study; by default the file's")->check(notEmpty());
    command
        .add_option("--pack", o.pack,
                    "What it is about: a folder with a pack, or a procedure that `tactus pack show` lists; default: "
                    "the first of these")
        ->check(notEmpty());
    addJson(command, o.json);
  });
  addCommand(study, chosen, "info", "What a study file holds", studyInfo, [](CLI::App& command, StudyInfoOptions& o) {
    addFile(command, o.file);
    addJson(command, o.json);
  });
  addCommand(
      study, chosen, "check", "Look for damaged, lost and contradicting records, and at the data", studyCheck,
      [](CLI::App& command, StudyCheckOptions& o) {
        command.add_option("FILE", o.file, "Study file, or folder with the CSV tables")->required()->check(notEmpty());
        addJson(command, o.json);
      });
  addCommand(study, chosen, "merge", "Add the records of other study files", studyMerge,
             [](CLI::App& command, StudyMergeOptions& o) {
               addFile(command, o.file);
               command.add_option("OTHER", o.others, "Study files to read from")->required()->check(notEmpty());
               addJson(command, o.json);
             });
  addCommand(study, chosen, "simulate", "Add simulated experts, to try a study before anybody is asked", studySimulate,
             [](CLI::App& command, StudySimulateOptions& o) {
               addFile(command, o.file);
               command.add_option("--nurses", o.group.count, "How many, 1 to 50")->check(CLI::Range(1, 50));
               command.add_option("--alike", o.group.alike, "How alike they are, 0 to 1")->check(CLI::Range(0.0, 1.0));
               command.add_option("--seed", o.group.seed, "Seed, a whole number from 1 on")
                   ->check(wholeNumberUpTo(session::kLargestSeed));
               addJson(command, o.json);
             });
  addCommand(study, chosen, "import", "Add the CSV tables of a folder, a full export, or answer files", studyImport,
             [](CLI::App& command, StudyImportOptions& o) {
               addFile(command, o.file);
               command
                   .add_option("FOLDER", o.sources,
                               "Folder with the CSV tables, or answer files of the form as a web page, any number")
                   ->required()
                   ->check(notEmpty());
               addAccept(command, o.accept, "import");
               addJson(command, o.json);
             });
  addCommand(
      study, chosen, "export", "Write everything as CSV tables with a codebook", studyExport,
      [](CLI::App& command, StudyExportOptions& o) {
        addFile(command, o.file);
        command
            .add_option("FOLDER,--out", o.folder,
                        "New or empty folder, or an earlier export, which is replaced; no default")
            ->check(outputFolder());
        command.parse_complete_callback([&o] {
          if (o.folder.empty()) throw CLI::RequiredError("FOLDER");
        });
        command.add_flag("--shareable", o.shareable, "Only what counts now, without identifying details");
        auto* const mark =
            command.add_flag("--bom", o.mark, "Begin each table with a byte order mark, for spreadsheet programs");
        command
            .add_option("--layout", o.layout,
                        "A data set for publication, without identifying details; default: CSV tables with a codebook")
            ->check(oneOf({"psych-ds", "bids"}))
            ->excludes(mark);
        addJson(command, o.json);
      });
  addCommand(study, chosen, "compare", "Does a choice of the method matter here? In newtons", studyCompare,
             [](CLI::App& command, StudyCompareOptions& o) {
               addBuildOptions(command, o, "compare");
               addJson(command, o.json);
             });
  addCommand(
      study, chosen, "bands", "How far the averaged force can be trusted; whose words, whose rules", studyBands,
      [](CLI::App& command, StudyBandsOptions& o) {
        addBuildOptions(command, o, "bands");
        command
            .add_option("--at", o.at,
                        "INPUT=VALUE of the curve along the way; default: the usual values of the procedure")
            ->type_name("INPUT=VALUE")
            ->expected(1)
            ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
        command.add_option("--out", o.out, "CSV file for the bands at every 5 mm; no default")->check(notEmpty());
        addJson(command, o.json);
      });
  addCommand(
      study, chosen, "plan", "How many nurses and questions? Simulated studies, their error and hours", studyPlan,
      [](CLI::App& command, StudyPlanOptions& o) {
        auto* const running =
            command.add_option("STUDY", o.study, "A running study, as a file or a folder; default: a study to come")
                ->check(notEmpty());
        addSimulatedPack(command, o.pack)->excludes(running);
        command.add_option("--precision", o.precision_n, "Error that is wanted, N, root mean square")
            ->check(numberThat("a number above 0", [](double x) { return x > 0; }));
        command.add_option("--region", o.region, "Region, such as laryngopharynx; default: all")->check(notEmpty());
        command.add_option("--most-nurses", o.most_nurses, "Largest number of nurses")
            ->check(whole(2, planning::kMostNurses));
        command
            .add_option("--questions", o.questions,
                        "Numbers of questions; default: a third, two thirds and all of the form, for a "
                        "running study ten fewer, as many and ten more")
            ->delimiter(',')
            ->check(whole(1, 100));
        command
            .add_option("--strokes", o.strokes,
                        "Numbers of strokes at each speed; default: 4, for a running study "
                        "as it has")
            ->delimiter(',')
            ->check(whole(1, 100));
        command
            .add_option("--minutes", o.minutes,
                        "Minutes of: consent and setup, a stroke, a force, a question; "
                        "default: 5,0.2,0.2,0.1667")
            ->delimiter(',')
            ->expected(4)
            ->check(numberThat("a number of 0 or more", [](double x) { return x >= 0; }));
        command.add_option("--studies", o.studies, "Simulated studies of each design")
            ->check(whole(2, planning::kMostStudies));
        command.add_option("--seed", o.seed, "Seed, a whole number")->check(wholeNumberUpTo(session::kLargestSeed));
        addForceTermsFrom(command, o);
        command.add_option("--out", o.out, "CSV file for the designs; no default")->check(notEmpty());
        addJson(command, o.json);
      });
  addCommand(
      study, chosen, "trial", "Simulated studies with a known truth: how often it lies in the stated band", studyTrial,
      [](CLI::App& command, StudyTrialOptions& o) {
        addSimulatedPack(command, o.pack);
        command.add_option("--nurses", o.nurses, "Nurses of each study")->check(whole(2, planning::kMostNurses));
        command.add_option("--strokes", o.strokes, "Strokes at each speed")->check(whole(1, 100));
        command.add_option("--studies", o.studies, "Number of studies")->check(whole(2, planning::kMostStudies));
        command.add_option("--seed", o.seed, "Seed, a whole number")->check(wholeNumberUpTo(session::kLargestSeed));
        addForceTermsFrom(command, o);
        addJson(command, o.json);
      });
  addCommand(study, chosen, "form", "The questionnaire as a web page, for a survey system or on paper", studyForm,
             [](CLI::App& command, StudyFormOptions& o) {
               command.add_option("STUDY", o.study, "Study file, or folder with the CSV tables")
                   ->required()
                   ->check(notEmpty());
               auto* const to = command.add_option("--to", o.to, "What it is for; no default")
                                    ->check(oneOf({"web", "redcap", "limesurvey", "print"}));
               command.add_option("--out", o.out, "Folder for the files")->required()->check(outputFolder());
               command
                   .add_option("--wording", o.wording,
                               "The words of the items: plain, as on the screens, or published, those of the paper; "
                               "default: plain, and of responses not known")
                   ->check(oneOf({"plain", "published"}));
               auto* const responses = command
                                           .add_option("--responses", o.responses,
                                                       "Table of answers that a survey system exported; no default")
                                           ->excludes(to)
                                           ->transform(inputFile());
               command
                   .add_option("--participants", o.participants,
                               "CSV file record,participant; default: the record ids are the participants' codes")
                   ->needs(responses)
                   ->transform(inputFile());
               command.add_option("--missing", o.missing, "A cell that means no answer, such as -999; no default")
                   ->needs(responses)
                   ->allow_extra_args(false)
                   ->check(notEmpty());
               command.parse_complete_callback([&o] {
                 if (o.to.empty() && o.responses.empty()) throw CLI::RequiredError("--to or --responses");
               });
               addJson(command, o.json);
             });
  addCommand(study, chosen, "recode", "Give a participant another code", studyRecode,
             [](CLI::App& command, StudyRecodeOptions& o) {
               addFile(command, o.file);
               command.add_option("PERSON", o.person, "Code or id of the participant")->required()->check(notEmpty());
               command.add_option("CODE", o.code, "The new code")->required()->check(notEmpty());
             });
  addCommand(
      study, chosen, "withdraw", "Permanently remove all data of a participant", studyWithdraw,
      [](CLI::App& command, StudyWithdrawOptions& o) {
        addFile(command, o.file);
        command.add_option("PERSON", o.person, "Code or id of the participant")->required()->check(notEmpty());
        auto* const yes = command.add_flag("--yes", o.yes, "Really remove; it cannot be undone");
        command.add_flag("--dry-run", o.dry_run, "Only say what would be removed and what would stay")->excludes(yes);
        command.parse_complete_callback([&o] {
          if (!o.yes && !o.dry_run) throw CLI::RequiredError("--yes or --dry-run");
        });
        addJson(command, o.json);
      });
  addCommand(study, chosen, "protocol", "Show or set what each participant is asked", studyProtocol,
             [](CLI::App& command, StudyProtocolOptions& o) {
               addFile(command, o.file);
               command.add_option("--set", o.set, "NAME=VALUE, with a name that the command lists; repeatable")
                   ->type_name("NAME=VALUE")
                   ->expected(1)
                   ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
               command.add_option("--consent", o.consent, "The consent text in a language, from a file; repeatable")
                   ->type_name("LANGUAGE=FILE")
                   ->expected(1)
                   ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
               command.add_option("--from", o.from, "Begin with the protocol in this JSON file")->check(notEmpty());
               command.add_option("--preset", o.preset, "Settings to begin with: published, recommended or short")
                   ->check(CLI::IsMember({"published", "recommended", "short"}));
               command.add_option("--reason", o.reason, "Why it changes; needed once participants follow it");
               command.add_option("--author", o.author, "Who changes it");
               addJson(command, o.json);
             });
  addCommand(study, chosen, "key", "Set the key that leads from the participant's screens to the researcher's",
             studyKey, [](CLI::App& command, StudyKeyOptions& o) {
               addFile(command, o.file);
               auto* const from =
                   command.add_option("--from", o.from, "File whose first line is the key; else the standard input")
                       ->check(notEmpty());
               command.add_flag("--remove", o.remove, "Take the key away")->excludes(from);
             });
  addCommand(study, chosen, "seal", "Put a reference curve under seal before the elicitation", studySeal,
             [](CLI::App& command, StudySealOptions& o) {
               addFile(command, o.file);
               command.add_option("REFERENCE", o.reference, "CSV file with the columns depth_mm and force_n")
                   ->required()
                   ->check(notEmpty());
               command.add_option("--note", o.note, "Where the curve comes from; everyone can read it");
               command
                   .add_option("--passphrase-file", o.passphrase_file,
                               "File whose first line is the passphrase; else it is asked for")
                   ->check(notEmpty());
               command.add_option("--at", o.at, "INPUT=VALUE of the curve; default: the usual values of the procedure")
                   ->type_name("INPUT=VALUE")
                   ->expected(1)
                   ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
               command.add_flag("--late", o.late, "Also after the elicitation began; the seal is marked as late");
               addJson(command, o.json);
             });
  addCommand(study, chosen, "open", "Open the sealed reference curve after the sign-off", studyOpen,
             [](CLI::App& command, StudyOpenOptions& o) {
               addFile(command, o.file);
               command
                   .add_option("--passphrase-file", o.passphrase_file,
                               "File whose first line is the passphrase; else it is asked for")
                   ->check(notEmpty());
               command.add_option("--out", o.out, "File for the curve; no default")->check(notEmpty());
               command.add_flag("--early", o.early, "Also before a sign-off; the opening is marked as early");
               addJson(command, o.json);
             });
  addCommand(study, chosen, "erase", "Finish an erasure that was interrupted", studyErase,
             [](CLI::App& command, StudyEraseOptions& o) {
               addFile(command, o.file);
               addJson(command, o.json);
             });
}

}  // namespace tactus::cli
