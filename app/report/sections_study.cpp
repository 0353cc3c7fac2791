// The overview of a study: who took part, what is there, what is missing, what to look at in the data.
#include <algorithm>
#include <map>
#include <set>

#include "app/report/report_sections.h"
#include "core/analysis/force_difference.h"
#include "core/base/text.h"

namespace tactus::report {
namespace {

/// How many of the claims were tried on `subject` and how many hold.
std::pair<int, int> verdictsOf(const std::vector<Claim>& claims, std::string_view subject) {
  int tried = 0;
  int hold = 0;
  for (const Claim& claim : claims) {
    for (const Verdict& verdict : claim.verdicts) {
      if (verdict.subject != subject || !verdict.holds) continue;
      ++tried;
      hold += *verdict.holds ? 1 : 0;
    }
  }
  return {hold, tried};
}

std::string outOf(std::pair<int, int> count) {
  return std::to_string(count.first) + " of " + std::to_string(count.second);
}

}  // namespace

void addOverview(HtmlPage& page, const ReportContext& context) {
  page.section("At a glance");
  page.notice(
      badge(Badge::kSimulated) +
      " This report demonstrates the method. The strokes, the single judgements and the answers of three of the "
      "four nurses are simulated with a fixed seed, because the paper does not print them. No force in it was "
      "measured on a person.");
  std::set<std::string> strokes;
  for (const study::SpeedSample& sample : context.in.study.speeds) {
    strokes.insert(sample.participant + '/' + sample.level + '/' + std::to_string(sample.stroke));
  }
  std::size_t rules = 0;
  for (const fuzzy::Expert& expert : context.in.built.model.experts) rules += expert.rules.size();
  const auto range = analysis::reachableRange(context.in.built.model, context.curves->compiled());
  const std::string& published = context.demo->published_expert;
  page.keyNumbers(
      {{std::to_string(context.in.built.model.experts.size()) + " experts",
        "one of them with published rules, " + std::to_string(rules) + " rules in all"},
       {std::to_string(strokes.size()) + " strokes",
        std::to_string(context.in.study.speeds.size()) + " speed samples, simulated to match Table 1"},
       {range.fired > 0 ? base::formatFixed(range.min_n, 2) + " to " + base::formatFixed(range.max_n, 2) + " N"
                        : std::string("no force"),
        "what the averaged model can give"},
       {outOf(verdictsOf(context.claims, published)),
        "statements of the paper hold for " + published + "’s published rules; " +
            outOf(verdictsOf(context.claims, "mean")) + " for the mean, by construction"}});
  addVerdicts(page, context);
}

void addOrigin(HtmlPage& page, const ReportContext& context) {
  page.section("What is published and what is simulated");
  page.paragraph(
      "Every table and figure carries these marks. A result is only as real as the data it was computed from.");
  const auto row = [](const Markup& what, Badge origin, const Markup& how) {
    return std::vector<Cell>{headingCell(what), {.text = badge(origin)}, {.text = how}};
  };
  page.table(
      {.caption = strong("Origin of the data."),
       .head = {{{.text = "Data"}, {.text = "Origin"}, {.text = "How it came here"}}},
       .body =
           {row("Means and SDs of the speeds", Badge::kPublished, "Table 1 of the paper, typed in."),
            row("Single speed samples", Badge::kSimulated,
                "Strokes made so that their means and SDs are those of Table 1. Everything else about them, their "
                "length, shape and number of samples, is ours."),
            row("Votes on the forces", Badge::kPublished, "Table 2 of the paper, typed in."),
            row("Who voted what", Badge::kSimulated,
                "One of many ways to split the votes of Table 2 over four persons. The result of the vote does not "
                "depend on it."),
            row("Rules of " + context.demo->published_expert, Badge::kPublished,
                "Table A2 of the paper, typed in; the reading of its regions is a choice: see “The published rules in "
                "three "
                "readings”."),
            row("Answers of the other nurses", Badge::kSimulated,
                "Made with a fixed seed to follow what the text says of the experts. Statements that hold for them "
                "hold by construction."),
            row("Terms of lubrication, neck flexion, depth", Badge::kComputed,
                "Defaults of this project: the vertices in Fig. 3 are not printed. Depths follow published anatomy of "
                "adults."),
            row("Terms of the speed", Badge::kSimulated, "Fuzzy C-Means on the simulated strokes."),
            row("Terms of the force", Badge::kPublished, "The paper's vote on Table 2; cores and ramps computed."),
            row("Curves and surfaces", Badge::kComputed,
                "From these models. The numbers behind the paper's figures are not published, so nothing is drawn "
                "beside them.")},
       .wide = true});
}

void addContradictions(HtmlPage& page, const ReportContext& context) {
  page.section("Contradictions in the paper");
  page.paragraph("Kept visible, not repaired. Each of these needs a decision of the researcher.");
  page.list({
      strong("Regions of the rules.") + " The questionnaire asks about the oropharynx and not the stomach, the printed "
                                        "rules name the stomach and not "
                                        "the oropharynx, yet the text has all four experts peak in the oropharynx.",
      strong("Neck flexion.") +
          " The text says the force is larger when the neck is not flexed. The printed rules of " +
          context.demo->published_expert + " say the opposite in the laryngopharynx, the esophagus and the stomach.",
      strong("Five regions, six segments.") +
          " The text names five regions of the passage, the figure that measures them has six segments.",
      strong("Force or change of force.") +
          " The questionnaire asks for “Force Change”, the rules conclude on “Force”. Read as force.",
      strong("Upper end of the force.") +
          " Stimuli were given up to 1.7 N; the table and the universe of the force end at 1.1 N.",
      strong("The vote at 0.9 N.") +
          " Two terms have exactly half of the votes each; the rule in the text does not say which wins. The higher is "
          "taken, because the series rises.",
      strong("Consistency of speeds.") + " The text calls the speed of S2 relatively consistent; in Table 1 S2 has the "
                                         "largest coefficient of variation "
                                         "of all at the level fast (0.51).",
      strong("Friction.") +
          " With the sign as printed in Eq. 3, the damping term would push the hand on instead of holding it back.",
      strong("Depth of 22 mm.") + " The text puts the wall of the nasopharynx at about 22 mm. In adults it lies near "
                                  "94 mm; 22 mm fits the head of "
                                  "the inferior turbinate.",
      strong("Usability, question 3.") +
          " No nine answers from 1 to 7 have the printed mean, standard deviation and maximum at once.",
      strong("Forward motion.") +
          " Forces were to be judged while moving forward; nothing says that the motion was checked.",
  });
}

void addBuildNotes(HtmlPage& page, const ReportContext& context) {
  page.section("Notes and settings of this build");
  if (context.in.built.notes.empty()) {
    page.paragraph("The elicitation had nothing to remark.");
  } else {
    std::vector<Markup> notes(context.in.built.notes.begin(), context.in.built.notes.end());
    page.list(notes);
  }
  Table table{.caption = strong("Settings.") + " With these the same files come out again.",
              .head = {{{.text = "Setting"}, {.text = "Value"}}},
              .body = {}};
  for (const auto& [name, value] : context.in.settings) table.body.push_back({headingCell(name), {.text = value}});
  page.table(table);
}

namespace {

/// What one participant gave.
struct Given {
  std::set<std::pair<std::string, int>> strokes;  ///< level and number
  std::size_t judgements = 0;
  std::size_t answers = 0;
  std::size_t rules = 0;
};

std::map<std::string, Given> givenBy(const study::Study& study) {
  std::map<std::string, Given> out;
  for (const auto& one : study.participants) out[one.code];
  for (const auto& sample : study.speeds) out[sample.participant].strokes.insert({sample.level, sample.stroke});
  for (const auto& one : study.judgements) {
    if (one.kind != study::ForceJudgement::Kind::kNoAnswer) ++out[one.participant].judgements;
  }
  for (const auto& one : study.answers) {
    if (one.status == study::Answer::Status::kAnswered) ++out[one.participant].answers;
  }
  for (const auto& one : study.rules) ++out[one.participant].rules;
  return out;
}

/// `A, B and 3 others`.
std::string shortList(const std::vector<std::string>& codes) {
  constexpr std::size_t kShown = 8;
  if (codes.size() <= kShown + 1) return base::joined(codes, ", ");
  return base::joined(std::vector<std::string>(codes.begin(), codes.begin() + kShown), ", ") + " and " +
         std::to_string(codes.size() - kShown) + " others";
}

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

/// One sentence for each thing that a whole study has and this one lacks.
std::vector<Markup> missing(const ReportContext& context, const std::map<std::string, Given>& given) {
  const auto& study = context.in.study;
  std::vector<Markup> out;
  if (study.participants.empty()) out.emplace_back("There are no participants.");
  if (study.participants.size() == 1) {
    out.emplace_back(
        "There is one participant only: the mean is that participant’s model, and how far experts agree cannot be "
        "said.");
  }
  if (study.speeds.empty() && fuzzy::rateOf(context.in.built.model.inputs)) {
    out.emplace_back(
        "There are no insertion strokes. The speed has its default terms; the sections about speeds and clusters are "
        "left out.");
  }
  if (study.judgements.empty()) {
    out.emplace_back(
        "There are no force judgements. The force has its default terms; the sections about votes are left out.");
  }
  if (context.curves == nullptr) {
    out.emplace_back(
        "There are no answers and no rules. So there is no force model yet, and the sections about its forces, "
        "agreement in newtons and findings are left out.");
  }
  const auto lacking = [&](bool some, auto lacks, const std::string& what) {
    std::vector<std::string> codes;
    for (const auto& one : study.participants) {
      if (lacks(given.at(one.code))) codes.push_back(one.code);
    }
    if (some && !codes.empty()) out.emplace_back("Without " + what + ": " + shortList(codes) + ".");
  };
  lacking(
      !study.speeds.empty(), [](const Given& one) { return one.strokes.empty(); }, "strokes");
  lacking(
      !study.judgements.empty(), [](const Given& one) { return one.judgements == 0; }, "judgements");
  lacking(
      context.curves != nullptr, [](const Given& one) { return one.answers + one.rules == 0; }, "answers and rules");
  if (!study.speeds.empty() && !context.speed_intervals) {
    out.emplace_back(context.in.replicates == 0
                         ? "Intervals of the speed terms were not asked for."
                         : "The speed terms have no intervals: they need two strokes of each participant and level.");
  }
  return out;
}

}  // namespace

namespace {

/// What the study is about, in the words of its pack.
void addProcedure(HtmlPage& page, const ReportContext& context) {
  const procedure::Procedure& about = context.about();
  page.paragraph(strong("Procedure.") + " " + about.titleIn("en") + ", pack " + about.id + ", version " +
                 std::to_string(about.version) + ". " + about.about);
}

}  // namespace

void addStudyOverview(HtmlPage& page, const ReportContext& context) {
  const auto& study = context.in.study;
  const auto given = givenBy(study);
  page.section("At a glance");
  const auto simulated = static_cast<std::size_t>(std::count_if(study.participants.begin(), study.participants.end(),
                                                                [](const auto& one) { return one.simulated; }));
  if (simulated > 0) {
    page.notice(
        badge(Badge::kSimulated) + " The data of " +
        (simulated == study.participants.size()
             ? std::string("all participants")
             : std::to_string(simulated) + " of " + std::to_string(study.participants.size()) + " participants") +
        " are simulated. A program made them; no person was measured. Each picture that contains such data "
        "says so.");
  }
  std::vector<std::string> without_force;
  for (const auto& participant : study.participants) {
    if (participant.virtual_device) without_force.push_back(participant.code);
  }
  if (!without_force.empty()) {
    page.notice("VIRTUAL: " + base::joined(without_force, ", ") +
                " moved a device that gives no force. Nothing that was judged there counts; strokes there count only "
                "where the protocol says virtual = accepted.");
  }
  if (const double scale = context.about().device_scale; scale != 1) {
    page.notice("The forces are beyond the device: in the hand they were 1 : " + base::formatNumber(scale) +
                ". Every number here is that of the procedure.");
  }
  std::size_t strokes = 0;
  std::size_t answers = 0;
  std::size_t judgements = 0;
  for (const auto& [code, one] : given) {
    strokes += one.strokes.size();
    answers += one.answers + one.rules;
    judgements += one.judgements;
  }
  const auto& model = context.in.built.model;
  std::string range = "no force yet";
  if (context.curves != nullptr) {
    const auto reached = analysis::reachableRange(model, context.curves->compiled());
    if (reached.fired > 0) {
      range = base::formatFixed(reached.min_n, 2) + " to " + base::formatFixed(reached.max_n, 2) + " N";
    }
  }
  page.keyNumbers(
      {{counted(study.participants.size(), "participant", "participants"),
        counted(model.experts.size(), "expert", "experts") + " in the averaged model"},
       {counted(strokes, "stroke", "strokes"), counted(study.speeds.size(), "speed sample", "speed samples")},
       {counted(judgements, "judgement", "judgements"), counted(answers, "answer or rule", "answers and rules")},
       {range, "what the averaged model can give"}});
  addProcedure(page, context);
  const auto lacks = missing(context, given);
  if (lacks.empty()) return;
  page.subsection("What is missing");
  page.list(lacks);
}

void addParticipants(HtmlPage& page, const ReportContext& context) {
  const auto& study = context.in.study;
  if (study.participants.empty()) return;
  page.section("Participants");
  Table table{.caption = strong("Participants.") +
                         " Random codes, and what each one gave. Years of experience are "
                         "left out, so that no participant is recognized by them.",
              .head = {{{.text = "Participant"},
                        {.text = "Category"},
                        {.text = "Hand"},
                        numberCell("Strokes", true),
                        numberCell("Judgements"),
                        numberCell("Answers"),
                        numberCell("Given rules"),
                        numberCell("Weight", true),
                        {.text = "Data", .group_start = true}}},
              .body = {}};
  const auto given = givenBy(study);
  const auto& experts = context.in.built.model.experts;
  for (const auto& one : study.participants) {
    const auto& gave = given.at(one.code);
    const auto expert =
        std::find_if(experts.begin(), experts.end(), [&](const auto& each) { return each.id == one.code; });
    table.body.push_back(
        {headingCell(one.code),
         {.text = one.category},
         {.text = one.handedness},
         numberCell(std::to_string(gave.strokes.size()), true),
         numberCell(std::to_string(gave.judgements)),
         numberCell(std::to_string(gave.answers)),
         numberCell(std::to_string(gave.rules)),
         numberCell(expert == experts.end() ? "–" : base::formatNumber(expert->weight), true),
         {.text = one.simulated ? badge(Badge::kSimulated) : Markup("recorded"), .group_start = true}});
  }
  page.table(table);
}

namespace {

/// `0.12 ± 0.05`; `0.12` of one person.
std::string meanText(const experiments::MeanOverPersons& mean, int decimals) {
  std::string text = base::formatFixed(mean.mean, decimals);
  if (mean.standard_error) text += " ± " + base::formatFixed(*mean.standard_error, decimals);
  return text;
}

std::string outOf(std::size_t count, std::size_t all) {
  return all == 0 ? "–" : std::to_string(count) + " of " + std::to_string(all);
}

std::string speedSentence(const std::vector<experiments::MeanOverPersons>& places) {
  std::vector<std::string> parts;
  for (const auto& place : places) parts.push_back(meanText(place, 2));
  return "Speeds by their place in the session, as shares of the mean speed at the same level: " +
         base::joined(parts, ", ") + ". 1 = the place has no effect.";
}

}  // namespace

void addOrderEffects(HtmlPage& page, const ReportContext& context) {
  const auto& done = context.in.in_order;
  if (done.empty()) return;
  std::vector<std::string> terms;
  for (const auto& term : context.in.built.model.output.terms) terms.push_back(term.id);
  const auto effects = experiments::orderEffects(done, terms);
  if (effects.persons.empty() && effects.speed_at_place.empty() && effects.late_minus_early.persons == 0) return;
  page.section("Catch trials and order");
  if (!effects.persons.empty()) {
    Table table{
        .caption = strong("Catch trials and order.") + " " + marks(context, {Badge::kComputed, Badge::kSimulated}) +
                   " A blank is a step without force; the friction of the device can be felt there. A hidden "
                   "repeat is a force that came before. Up minus down: how much higher the words are on the way "
                   "up than on the way down, in words. None of these trials is in a vote, and no participant is left "
                   "out because of them.",
        .head = {{{.text = "Participant"},
                  numberCell("Blanks felt", true),
                  numberCell("Repeats with the same word"),
                  numberCell("Forces both ways", true),
                  numberCell("Up minus down")}},
        .body = {}};
    for (const auto& person : effects.persons) {
      table.body.push_back({headingCell(person.participant), numberCell(outOf(person.felt_blanks, person.blanks), true),
                            numberCell(outOf(person.same_repeats, person.repeats)),
                            numberCell(std::to_string(person.both_ways), true),
                            numberCell(person.up_minus_down ? base::formatFixed(*person.up_minus_down, 2) : "–")});
    }
    page.table(table);
  }
  std::vector<Markup> lines;
  if (effects.up_minus_down.persons > 1) {
    lines.emplace_back("Up minus down, mean of " + std::to_string(effects.up_minus_down.persons) +
                       " participants: " + meanText(effects.up_minus_down, 2) + " words.");
  }
  if (!effects.speed_at_place.empty()) lines.emplace_back(speedSentence(effects.speed_at_place));
  if (effects.late_minus_early.persons > 0) {
    lines.emplace_back(
        "Answers in the last third of the questions less those in the first, each less the mean of its "
        "question: " +
        meanText(effects.late_minus_early, 2) + " words.");
  }
  const auto several = [&done](const auto& has) { return std::count_if(done.begin(), done.end(), has) > 1; };
  std::vector<std::string> fixed;
  if (effects.speed_at_place.empty() && several([](const auto& one) { return one.speeds.size() > 1; })) {
    fixed.emplace_back("Speeds");
  }
  if (effects.late_minus_early.persons == 0 && several([](const auto& one) { return one.answers.size() > 1; })) {
    fixed.emplace_back(fixed.empty() ? "Questions" : "questions");
  }
  if (!fixed.empty()) {
    lines.emplace_back(base::joined(fixed, " and ") +
                       " came in the same order for all participants: an effect of the order cannot be seen.");
  }
  if (!lines.empty()) page.list(lines);
}

void addStopForces(HtmlPage& page, const ReportContext& context) {
  Table table{
      .caption = strong("Where they would stop.") + " " + marks(context, {Badge::kComputed, Badge::kSimulated}) +
                 " Beside the word of each force they said whether they would push on. Would stop at: the force "
                 "at which a participant stops half of the time. It is no part of the model.",
      .head = {{{.text = "Participant"},
                numberCell("Forces", true),
                numberCell("Would stop"),
                numberCell("Goes on up to, N"),
                numberCell("Stops from, N", true),
                numberCell("Would stop at, N")}},
      .body = {}};
  const auto newtons = [](const std::optional<double>& force_n) {
    return force_n ? base::formatFixed(*force_n, 2) : std::string("–");
  };
  for (const auto& one : context.in.in_order) {
    if (one.stops.empty()) continue;
    const auto force = experiments::stopForce(one.stops);
    table.body.push_back({headingCell(one.participant), numberCell(std::to_string(force.asked), true),
                          numberCell(std::to_string(force.stops)), numberCell(newtons(force.highest_on_n)),
                          numberCell(newtons(force.lowest_stop_n), true), numberCell(newtons(force.stop_force_n))});
  }
  if (table.body.empty()) return;
  page.section("Where they would stop");
  page.table(table);
}

void addDataFindings(HtmlPage& page, const ReportContext& context) {
  if (context.in.data.empty()) return;
  page.section("What to look at in the data");
  Table table{.caption = strong("Checks of the data.") + " Made before anything is computed; nothing was changed.",
              .head = {{{.text = "Kind"}, {.text = "Finding"}}},
              .body = {},
              .wide = true};
  for (const auto& finding : context.in.data) {
    table.body.push_back({headingCell(std::string(name(finding.severity))), {.text = study::text(finding)}});
  }
  page.table(table);
}

}  // namespace tactus::report
