#include "app/report/report_sections.h"

namespace tactus::report {

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

}  // namespace tactus::report
