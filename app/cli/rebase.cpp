#include "app/editing/rebase.h"

#include <algorithm>
#include <chrono>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/model_arguments.h"
#include "app/cli/output_file.h"
#include "app/cli/terminal.h"
#include "app/version.h"
#include "core/base/clock.h"
#include "core/base/error.h"
#include "core/base/json/json_writer.h"
#include "core/base/text.h"
#include "core/model_io/model_file.h"

namespace tactus::cli {
namespace {

using base::ErrorCode;
using base::formatFixed;
using editing::CarriedEdit;
using editing::EditImpact;

constexpr std::size_t kNumberWidth = 4;
constexpr std::size_t kOutcomeWidth = 16;
constexpr std::size_t kForceWidth = 10;
constexpr std::size_t kIndent = kNumberWidth + kOutcomeWidth + 2 * kForceWidth + 2;

/// What the command found, with the price of each edit that applies.
struct Carried {
  editing::Rebase rebase;
  std::vector<std::size_t> chosen;
  std::vector<EditImpact> prices;  ///< one for each edit; empty where it does not apply
  EditImpact together;             ///< of the chosen ones
};

std::string editText(const CarriedEdit& edit) { return edit.what + ": " + edit.before + " to " + edit.after; }

std::string forceOf(const Carried& carried, double force) {
  return formatFixed(force, 3) + ' ' + base::oneLine(carried.rebase.target->model.output.unit);
}

std::string placeOf(const Carried& carried, const EditImpact& price) {
  std::vector<std::string> parts;
  const auto& inputs = carried.rebase.target->model.inputs;
  for (std::size_t i = 0; i < price.at.size(); ++i) {
    parts.push_back(base::oneLine(inputs[i].id) + ' ' + formatFixed(price.at[i], 3));
  }
  return base::joined(parts, ", ");
}

std::string rowText(const Carried& carried, std::size_t index) {
  const CarriedEdit& edit = carried.rebase.edits[index];
  const EditImpact& price = carried.prices[index];
  std::string first = padded(std::to_string(index + 1), kNumberWidth) +
                      padded(editing::name(edit.outcome), kOutcomeWidth) +
                      rightAligned(edit.canApply() ? forceOf(carried, price.largest_n) : "", kForceWidth) +
                      rightAligned(edit.canApply() ? formatFixed(price.noticeable, 2) : "", kForceWidth) + "  ";
  std::string text = wrapped(editText(edit), first, kIndent);
  const std::string indent(kIndent, ' ');
  if (!edit.note.empty()) text += wrapped(edit.note, indent, kIndent);
  if (!price.at.empty()) text += wrapped("Most at " + placeOf(carried, price), indent, kIndent);
  if (price.opened > 0) text += wrapped("Leaves places without a force.", indent, kIndent);
  return text;
}

std::string asText(const Carried& carried) {
  const auto& edits = carried.rebase.edits;
  if (edits.empty()) return "The tuned version has no edit that can be carried over.\n";
  std::string text = padded("#", kNumberWidth) + padded("", kOutcomeWidth) + rightAligned("max dF", kForceWidth) +
                     rightAligned("JND", kForceWidth) + "  edit\n";
  for (std::size_t e = 0; e < edits.size(); ++e) text += rowText(carried, e);
  std::string sentence =
      std::to_string(carried.chosen.size()) + " of " + std::to_string(edits.size()) + " edits carried over";
  if (!carried.chosen.empty()) {
    sentence += carried.together.at.empty()
                    ? "; together they do not change the force"
                    : "; together they move the force by at most " + forceOf(carried, carried.together.largest_n) +
                          " (" + formatFixed(carried.together.noticeable, 2) + " just-noticeable differences), at " +
                          placeOf(carried, carried.together);
  }
  return text + "\n" + wrapped(sentence + ".", "", 0);
}

void writePrice(base::JsonWriter& json, const Carried& carried, const EditImpact& price) {
  json.key("largest_n").value(price.largest_n).key("noticeable").value(price.noticeable).key("at").beginObject();
  const auto& inputs = carried.rebase.target->model.inputs;
  for (std::size_t i = 0; i < price.at.size(); ++i) json.key(inputs[i].id).value(price.at[i]);
  json.endObject().key("opened").value(price.opened).key("closed").value(price.closed);
}

std::string asJson(const RebaseOptions& options, const Carried& carried) {
  base::JsonWriter json;
  json.beginObject().key("base").value(options.base).key("tuned").value(options.tuned);
  json.key("target").value(options.target).key("edits").beginArray();
  for (std::size_t e = 0; e < carried.rebase.edits.size(); ++e) {
    const CarriedEdit& edit = carried.rebase.edits[e];
    const bool chosen = std::count(carried.chosen.begin(), carried.chosen.end(), e) > 0;
    json.beginObject().key("what").value(edit.what).key("before").value(edit.before).key("after").value(edit.after);
    json.key("outcome").value(editing::name(edit.outcome)).key("note").value(edit.note).key("carried").value(chosen);
    if (edit.canApply()) writePrice(json, carried, carried.prices[e]);
    json.endObject();
  }
  json.endArray().key("together").beginObject();
  writePrice(json, carried, carried.together);
  return json.endObject().endObject().text();
}

/// The edits of `--only`, or all, that apply.
base::Result<std::vector<std::size_t>> chosenOf(const RebaseOptions& options, const editing::Rebase& rebase) {
  std::vector<std::size_t> wanted(rebase.edits.size());
  std::iota(wanted.begin(), wanted.end(), std::size_t{0});
  if (!options.only.empty()) wanted.clear();
  for (const std::size_t number : options.only) {
    if (number == 0 || number > rebase.edits.size()) {
      return base::fail(ErrorCode::kValue, "--only", std::to_string(number),
                        rebase.edits.empty() ? "an edit, but there is none"
                                             : "a number from 1 to " + std::to_string(rebase.edits.size()));
    }
    const CarriedEdit& edit = rebase.edits[number - 1];
    if (!edit.canApply())
      return base::fail(ErrorCode::kValue, "--only", std::to_string(number) + ": " + edit.note, "an edit that applies");
    wanted.push_back(number - 1);
  }
  std::erase_if(wanted, [&](std::size_t e) { return !rebase.edits[e].canApply(); });
  return wanted;
}

/// The text of the new model with the edits. Its checks keep their points and get the new forces.
base::Result<std::string> carriedText(const RebaseOptions& options, const Carried& carried) {
  TACTUS_TRY(auto edit, editing::carryOver(carried.rebase, carried.chosen));
  editing::refreshChecks(edit.model, edit.compiled);
  edit.model.created_utc = base::formatUtc(std::chrono::system_clock::now());
  edit.model.generator = kGenerator;
  if (auto& from = edit.model.provenance) {
    for (const std::size_t e : carried.chosen) {
      from->notes += (from->notes.empty() ? "" : " ") + ("Carried over: " + editText(carried.rebase.edits[e])) + ".";
    }
  }
  return model_io::modelText(edit.model, options.out);
}

}  // namespace

base::Result<Output> rebase(const RebaseOptions& options) {
  if (auto ok = requireOutput(options.out, {options.base, options.tuned, options.target}); !ok)
    return tl::unexpected(ok.error());
  TACTUS_TRY(const auto before, openedModel(options.base));
  TACTUS_TRY(const auto tuned, openedModel(options.tuned));
  TACTUS_TRY(auto target, openedModel(options.target));
  std::vector<std::string> warnings = before.warnings;
  for (const auto& more : {tuned.warnings, target.warnings}) warnings.insert(warnings.end(), more.begin(), more.end());
  auto found = editing::rebase(before.model, tuned.model,
                               std::make_shared<const editing::ReadyModel>(
                                   editing::ReadyModel{std::move(target.model), std::move(target.compiled)}));
  if (!found) return base::inFile(found.error(), options.tuned);
  Carried carried{std::move(*found), {}, {}, {}};
  TACTUS_TRY(auto chosen, chosenOf(options, carried.rebase));
  carried.chosen = std::move(chosen);
  for (std::size_t e = 0; e < carried.rebase.edits.size(); ++e) {
    TACTUS_TRY(auto price, editing::priceOf(carried.rebase, std::span(&e, 1)));
    carried.prices.push_back(std::move(price));
  }
  auto together = editing::priceOf(carried.rebase, carried.chosen);
  if (!together) return base::inFile(together.error(), options.target);
  carried.together = std::move(*together);
  Output said{options.json ? asJson(options, carried) : asText(carried), std::move(warnings)};
  if (options.out.empty()) return said;
  TACTUS_TRY(const auto text, carriedText(options, carried));
  return written(options.out, text, std::move(said), options.json);
}

}  // namespace tactus::cli
