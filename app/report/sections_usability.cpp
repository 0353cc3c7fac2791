// What participants think of the simulator: Table 3 of the paper.
#include <algorithm>

#include "app/report/report_sections.h"
#include "core/base/text.h"
#include "questionnaires/form_file.h"

namespace tactus::report {

void addUsability(HtmlPage& page, const ReportContext& context) {
  if (context.in.usability.empty()) return;
  const auto form = questionnaires::usabilityForm();
  page.section("Usability of the simulator");
  Table table{.caption = strong("Usability.") + " " + marks(context, {Badge::kComputed, Badge::kSimulated}) +
                         " Answers from 1 (" + form.low + ") to " + std::to_string(form.points) + " (" + form.high +
                         "), as in Table 3 of Choi et al.",
              .head = {{{.text = "Statement"},
                        numberCell("Answers", true),
                        numberCell("Mean"),
                        numberCell("SD"),
                        numberCell("Min"),
                        numberCell("Max")}},
              .body = {},
              .note = "SD with n − 1. A participant who skipped a statement is not counted there."};
  for (const auto& row : context.in.usability) {
    const auto item =
        std::find_if(form.items.begin(), form.items.end(), [&](const auto& one) { return one.number == row.item; });
    const std::string statement = item == form.items.end() ? std::string() : ". " + item->text;
    const bool some = row.n > 0;
    const auto number = [some](const std::string& text) { return numberCell(some ? text : "–"); };
    table.body.push_back({{.text = std::to_string(row.item) + statement},
                          numberCell(std::to_string(row.n), true),
                          number(base::formatFixed(row.mean, 2)),
                          number(base::formatFixed(row.sd, 2)),
                          number(std::to_string(row.min)),
                          number(std::to_string(row.max))});
  }
  page.table(table);
}

}  // namespace tactus::report
