// A certificate as one printed page.
#include <algorithm>

#include "app/certify/certificate.h"
#include "app/report/html.h"
#include "core/base/text.h"

namespace tactus::certify {
namespace {

using report::Cell;
using report::headingCell;
using report::Markup;
using report::numberCell;

std::string count(std::size_t number) { return std::to_string(number); }

/// The heading of a column of numbers.
Cell numberHeading(const std::string& text) { return {text, 1, true, true}; }

/// The two kinds of questions, side by side.
struct Kinds {
  const Certificate& certificate;

  /// A row of `text(answers)` for each kind.
  template <class Text>
  std::vector<Cell> row(const std::string& name, Text text) const {
    std::vector<Cell> out = {headingCell(name), numberCell(text(certificate.points))};
    if (certificate.has_tube) out.push_back(numberCell(text(certificate.steps)));
    return out;
  }
  std::vector<Cell> head() const {
    std::vector<Cell> out = {headingCell(""), numberHeading("points")};
    if (certificate.has_tube) out.push_back(numberHeading("steps of the tube"));
    return out;
  }
};

report::Table answersTable(const Certificate& certificate) {
  const Kinds kinds{certificate};
  report::Table table;
  table.caption = "What was asked, and what came back. Right: within " + base::formatNumber(certificate.tolerance) +
                  " N, and mm of depth, in time.";
  table.head = {kinds.head()};
  table.body = {kinds.row("questions", [](const Answers& one) { return count(one.all); }),
                kinds.row("right", [](const Answers& one) { return count(one.right); }),
                kinds.row("wrong", [](const Answers& one) { return count(one.wrong); }),
                kinds.row("late", [](const Answers& one) { return count(one.late); }),
                kinds.row("missing", [](const Answers& one) { return count(one.missing); }),
                kinds.row("not asked any more", [](const Answers& one) { return count(one.unasked()); }),
                kinds.row("largest error", [](const Answers& one) { return scientific(one.largest_error_n) + " N"; })};
  return table;
}

report::Table timesTable(const Certificate& certificate) {
  report::Table table;
  table.caption =
      "Times in µs. Latency: from question to answer, the way there and back included. Jitter: the difference of one "
      "latency to the next.";
  table.head = {{headingCell(""), numberHeading("50 %"), numberHeading("99 %"), numberHeading("99.9 %"),
                 numberHeading("largest")}};
  const auto row = [&table](const std::string& name, const Percentiles& of) {
    const auto cell = [](double us) { return numberCell(base::formatFixed(us, 1)); };
    table.body.push_back({headingCell(name), cell(of.half), cell(of.p99), cell(of.p999), cell(of.largest)});
  };
  row("latency, points", certificate.points.latency());
  row("jitter, points", certificate.points.jitter());
  if (!certificate.steps.latency_us.empty()) {
    row("latency, steps", certificate.steps.latency());
    row("jitter, steps", certificate.steps.jitter());
  }
  return table;
}

}  // namespace

std::string certificatePage(const Certificate& certificate) {
  const std::string name = certificate.target.substr(certificate.target.rfind('/') + 1);
  report::HtmlPage page("Certificate of " + (certificate.program.empty() ? name : certificate.program),
                        "Against " + certificate.model_name + ", " + certificate.utc + ", " + certificate.generator);
  const Answers& felt = certificate.has_tube ? certificate.steps : certificate.points;
  const double largest_n = std::max(certificate.points.largest_error_n, certificate.steps.largest_error_n);
  page.keyNumbers(
      {{certificate.ok() ? "Certified" : "Not certified", certificate.has_tube ? "forces and tube" : "forces alone"},
       {scientific(largest_n) + " N", "largest error"},
       {base::formatFixed(felt.latency().p999, 0) + " µs", "99.9 % of the answers within"}});
  if (certificate.ok()) {
    page.paragraph(certificate.verdict());
  } else {
    page.notice(certificate.verdict());
  }
  page.section("What was examined");
  std::vector<Markup> what = {"Program: " + certificate.target +
                                  (certificate.program.empty() ? ", which did not say what it is"
                                                               : ", which says it is " + certificate.program),
                              "Model: " + certificate.model_name + ", SHA-256 " + certificate.model_sha256,
                              "Machine: " + certificate.machine};
  if (!certificate.has_tube) {
    what.emplace_back(certificate.program_has_tube ? "The model has no tube: it lacks depth or speed."
                                                   : "The program says that it has no tube.");
  }
  page.list(what);
  page.section("Forces");
  page.table(answersTable(certificate));
  std::vector<Markup> where;
  const auto add = [&where](const std::string& of, const Answers& one) {
    if (!one.where.empty())
      where.emplace_back("Largest error of the " + of + ": " + scientific(one.largest_error_n) + " N at " + one.where +
                         ".");
  };
  add("points", certificate.points);
  add("tube", certificate.steps);
  if (certificate.largest_depth_error_mm > 0)
    where.emplace_back("Largest error of the depth: " + base::formatNumber(certificate.largest_depth_error_mm) +
                       " mm.");
  if (!where.empty()) page.list(where);
  if (!certificate.points.latency_us.empty()) {
    page.section("Times");
    page.table(timesTable(certificate));
  }
  return page.html();
}

}  // namespace tactus::certify
