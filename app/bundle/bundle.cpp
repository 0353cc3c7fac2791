#include "app/bundle/bundle.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <filesystem>
#include <iterator>
#include <set>
#include <system_error>
#include <utility>

#include "app/bundle/file_errors.h"
#include "app/bundle/sources.h"
#include "app/bundle/zip.h"
#include "core/analysis/check_points.h"
#include "core/analysis/coverage.h"
#include "core/base/error.h"
#include "core/base/files/checksums.h"
#include "core/base/files/file.h"
#include "core/base/files/unfinished.h"
#include "core/base/tables/csv.h"
#include "core/base/text.h"
#include "core/fuzzy/validate.h"
#include "core/model_io/model_file.h"
#include "core/procedure/procedure.h"

namespace tactus::bundle {
namespace {

namespace fs = std::filesystem;

base::Error failed(const std::string& folder, const std::error_code& reason) {
  return {base::ErrorCode::kIo, folder, {}, reason.message(), "a folder that can be written"};
}

/// Puts `made` in the place of `folder`; what was there goes.
base::Result<void> replace(const std::string& made, const std::string& folder) {
  const base::Exchange exchange;
  std::error_code error;
  const bool old = fs::exists(folder, error);
  const std::string aside = made + "-old";
  if (old) fs::rename(folder, aside, error);
  if (error) return tl::unexpected(failed(folder, error));
  fs::rename(made, folder, error);
  std::error_code ignored;
  if (error) {
    if (old) fs::rename(aside, folder, ignored);
    return tl::unexpected(failed(folder, error));
  }
  if (old) fs::remove_all(aside, ignored);
  base::syncFolderOf(folder);
  return {};
}

}  // namespace

base::Result<void> mayHoldBundle(const std::string& folder) {
  std::error_code ignored;
  if (!fs::exists(folder, ignored) || fs::is_empty(folder, ignored)) return {};
  const auto refused = [&folder](std::string found) {
    return tl::unexpected(base::Error{base::ErrorCode::kIo,
                                      folder,
                                      {},
                                      std::move(found),
                                      "a new or empty folder, or one with an earlier bundle and nothing else"});
  };
  if (!fs::is_directory(folder, ignored)) return refused("a file");
  const std::string path = folder + "/" + std::string(model_io::kManifestName);
  const auto text = base::readFile(path, std::size_t{4} << 20U);
  const auto manifest = text ? model_io::parseManifest(*text, path) : tl::unexpected(text.error());
  if (!manifest) return refused("a folder that holds other files");
  std::set<std::string> own = {std::string(model_io::kManifestName), std::string(model_io::kSignatureName)};
  for (const model_io::BundleFile& file : manifest->files) own.insert(file.path);
  for (const auto& entry : fs::recursive_directory_iterator(folder, ignored)) {
    if (entry.is_directory(ignored)) continue;
    const std::string name = fs::relative(entry.path(), folder, ignored).generic_string();
    if (!own.contains(name)) return refused("a bundle with a file that is not its own, " + base::quoted(name));
  }
  return {};
}

base::Result<void> writeBundle(const Bundle& bundle, const std::string& folder_name, const std::stop_token& stop) {
  // Without a slash at its end, so that names beside it can be made.
  std::string folder = fs::path(folder_name).lexically_normal().string();
  while (folder.size() > 1 && folder.back() == '/') folder.pop_back();
  if (const auto ok = mayHoldBundle(folder); !ok) return ok;
  const fs::path parent = fs::path(folder).parent_path();
  if (!parent.empty()) {
    if (const auto made = base::makeFolder(parent.string()); !made) return made;
  }
  const base::Unfinished work = base::makeUnfinishedFolder(folder, base::kUnfinishedEnding);
  if (!work.descriptor.isOpen()) return tl::unexpected(failed(folder, {errno, std::generic_category()}));
  std::error_code ignored;
  for (const auto& [path, bytes] : bundle.files) {
    const std::string file = work.path + "/" + path;
    auto done = base::makeFolder(fs::path(file).parent_path().string());
    if (done) done = base::writeFileAtomically(file, bytes);
    if (done && stop.stop_requested())
      done = base::fail(base::ErrorCode::kCancelled, "bundle", "a request to stop", "time to end");
    if (!done) {
      fs::remove_all(work.path, ignored);
      return done;
    }
  }
  fs::permissions(work.path,
                  fs::perms::owner_all | fs::perms::group_read | fs::perms::group_exec | fs::perms::others_read |
                      fs::perms::others_exec,
                  ignored);
  auto replaced = replace(work.path, folder);
  if (!replaced) fs::remove_all(work.path, ignored);
  return replaced;
}

base::Result<void> writeBundleZip(const Bundle& bundle, const std::string& file) {
  const fs::path path(file);
  const auto bytes = zipped(bundle.files, path.stem().string());
  if (!bytes) return base::inFile(bytes.error(), file);
  if (path.has_parent_path()) {
    if (const auto made = base::makeFolder(path.parent_path().string()); !made) return made;
  }
  return base::writeFileAtomically(file, *bytes);
}

namespace {

constexpr std::string_view kModelPath = "model.tactus.json";

/// Takes the accepted names into the model. Refused: a hole that is not accepted, a name that is no hole.
base::Result<void> acceptHoles(fuzzy::ForceModel& model, const std::vector<std::string>& accept, Bundle& bundle) {
  std::vector<std::size_t> counted;
  for (std::size_t e = 0; e < model.experts.size(); ++e) {
    if (model.experts[e].weight > 0) counted.push_back(e);
  }
  const auto coverage = analysis::coverage(model, counted);
  bundle.every_hole_is_known = coverage.complete;
  if (!coverage.complete)
    bundle.warnings.emplace_back("the search for holes was cut off, because the model is too finely divided");
  std::vector<std::string>& holes = bundle.holes;
  for (const analysis::Hole& hole : coverage.holes) holes.push_back(describe(hole, model));
  const auto among = [](const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  for (const std::string& name : accept) {
    if (!among(holes, name)) {
      return base::fail(
          base::ErrorCode::kReference, "--accept-hole", base::quoted(name),
          holes.empty() ? "no name, because the model has no hole" : "one of the holes: " + base::joined(holes, "; "));
    }
    if (!among(model.accepted_holes, name)) model.accepted_holes.push_back(name);
  }
  for (const std::string& hole : holes) {
    if (among(model.accepted_holes, hole)) continue;
    return base::fail(base::ErrorCode::kData, "coverage", "a hole at " + hole + ", where no rule of any expert fires",
                      "a rule there, or --accept-hole " + base::quoted(hole));
  }
  return {};
}

/// Collects the files with their promises.
class Collector {
 public:
  Collector(Bundle& bundle, const BundleSettings& settings, std::size_t all)
      : bundle_(bundle), settings_(settings), all_(all) {}

  /// Before each file: reports the progress. Returns false to cancel.
  bool next() {
    if (settings_.progress) settings_.progress(done_++, all_);
    return !settings_.stop.stop_requested();
  }

  void add(std::string path, std::string kind, std::string bytes, std::optional<model_io::Promise> promise = {},
           std::string expert = {}) {
    bundle_.manifest.files.push_back(
        {path, base::sha256(bytes), std::move(kind), std::move(expert), std::move(promise)});
    bundle_.files.emplace_back(std::move(path), std::move(bytes));
  }

  /// A text that may not be possible; then a warning says why.
  void addOrWarn(std::string path, std::string kind, base::Result<std::string> bytes, model_io::Promise promise,
                 std::string expert) {
    if (bytes) return add(std::move(path), std::move(kind), std::move(*bytes), std::move(promise), std::move(expert));
    bundle_.warnings.push_back(path + " is left out: " + bytes.error().message());
  }

 private:
  Bundle& bundle_;
  const BundleSettings& settings_;
  std::size_t all_;
  std::size_t done_ = 0;
};

base::Error cancelled() { return {base::ErrorCode::kCancelled, {}, "bundle", "a request to stop", "time to end"}; }

std::string checksText(const fuzzy::ForceModel& model, const std::vector<fuzzy::Check>& checks) {
  std::vector<std::string> columns;
  for (const fuzzy::Variable& input : model.inputs) columns.push_back(input.id);
  columns.insert(columns.end(), {"force", "fired"});
  base::CsvWriter csv(columns);
  for (const fuzzy::Check& check : checks) {
    for (const double value : check.in) csv.cell(value);
    csv.cell(check.force).cell(check.fired ? 1 : 0).endRow();
  }
  return csv.text();
}

/// A file name from an expert's id, different from the others.
std::string fileName(const std::string& id, std::vector<std::string>& taken) {
  std::string name;
  for (const char c : id) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_';
    name += plain ? c : '_';
  }
  const std::string first = name;
  const auto known = [&](const std::string& one) {
    return std::find(taken.begin(), taken.end(), base::lowered(one)) != taken.end();
  };
  for (int copy = 2; known(name); ++copy) name = first + "_" + std::to_string(copy);
  taken.push_back(base::lowered(name));
  return name;
}

void addExperts(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                const std::vector<std::vector<double>>& points, const exchange::Origin& origin, Collector& collector) {
  const std::vector<std::string> names = expertFileNames(model);
  for (std::size_t e = 0; e < model.experts.size(); ++e) {
    const std::string& id = model.experts[e].id;
    const std::string start = "experts/" + names[e];
    for (const exchange::Dialect dialect : exchange::kDialects) {
      if (!collector.next()) return;
      collector.addOrWarn(start + std::string(suffix(dialect)), std::string(name(dialect)),
                          exchange::format(model, e, dialect, origin), promiseOf(dialect, compiled, e, points), id);
    }
  }
}

/// The sources in C and JavaScript, and the insertions. Returns false to cancel.
bool addSources(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
                const std::vector<std::vector<double>>& points, const BundleSettings& settings,
                const exchange::Origin& origin, Bundle& bundle, Collector& collector) {
  if (!collector.next()) return false;
  const std::optional<FeltTraces> felt = feltTraces(model);
  if (felt) collector.add("checks_tube.csv", "tube-checks", formatTubeChecks(*felt), exactPromise(model));
  const Sources sources = sourcesOf(model, origin);
  SourceRuns runs(sources, points, felt, settings.stop);
  for (const SourceFile& file : sources.files) {
    std::optional<model_io::Promise> promise;
    if (file.gives != SourceFile::Gives::kNothing) {
      if (!collector.next()) return false;
      promise = promiseOf(runs, file, compiled);
    }
    collector.add(file.path, file.kind, file.bytes, promise);
  }
  bundle.warnings.insert(bundle.warnings.end(), sources.warnings.begin(), sources.warnings.end());
  return true;
}

/// Why the table is further off than wanted.
std::string tableWarning(const BoundedTable& made, double wanted_n) {
  return "table/force_table.csv may be " + base::roundedNumber(made.bound.bound_n) + " N off, more than the wanted " +
         base::formatNumber(wanted_n) + " N: " +
         (made.bound.jumps ? "the force jumps, which no table follows"
                           : "a closer one has more than " + std::to_string(kMostNodes) + " nodes");
}

void addTable(const fuzzy::ForceModel& model, const fuzzy::CompiledModel& compiled,
              const std::vector<std::vector<double>>& points, const BundleSettings& settings,
              const exchange::Origin& origin, Bundle& bundle, Collector& collector) {
  const double wanted_n = settings.table_error_n.value_or(usualTableErrorN(model));
  const BoundedTable made = boundedTable(model, compiled, wanted_n, kMostNodes, settings.stop);
  if (settings.stop.stop_requested()) return;
  if (made.bound.bound_n > wanted_n) bundle.warnings.push_back(tableWarning(made, wanted_n));
  const ForceTable& table = made.table;
  const model_io::Promise promise = promiseOf(made, compiled, points);
  std::string lines;
  for (std::size_t i = 0; i < table.lines.size(); ++i) {
    lines += "  " + base::oneLine(model.inputs[i].id) + ": " + std::to_string(table.lines[i].size()) + " values from " +
             base::formatNumber(table.lines[i].front()) + " to " + base::formatNumber(table.lines[i].back()) + " " +
             base::oneLine(model.inputs[i].unit) + "\n";
  }
  collector.add("table/force_table.csv", "table", formatTable(model, table), promise);
  collector.add(
      "table/README.txt", "text",
      "force_table.csv: the averaged force on a grid, one row per node, the last input running fastest.\n"
      "Interpolate linearly in every input between the two nearest values, and clamp values outside.\n"
      "So read, the table is nowhere more than " +
          base::formatNumber(promise.tolerance_n) +
          " N off (proved for the whole box of the inputs).\nA node may be off as well: the errors are spread "
          "to both sides.\n\n" +
          lines + "\nLargest error at the " + std::to_string(points.size()) + " points of checks.csv: " +
          base::formatNumber(promise.largest_error_n) + " N.\nWhere no rule fires the table holds the default force" +
          (made.bound.jumps ? "; beside such a place, and where a term has a vertical edge, the force jumps "
                              "and the table does not.\n"
                            : ".\n") +
          "Any other file of the bundle is more accurate: take the table where nothing else is possible.\n\n" +
          originText(origin) + "\n");
}

/// The pack that the model names, in the folder `procedure`; nothing of the default procedure.
void addPack(const fuzzy::ForceModel& model, const BundleSettings& settings, Bundle& bundle, Collector& collector) {
  const procedure::ModelProcedure named = procedure::procedureOf(model);
  if (named.sha256.empty()) return;
  for (const auto& known : {settings.procedure, procedure::builtIn(named.id)}) {
    if (known == nullptr || known->sha256 != named.sha256) continue;
    for (const auto& [path, bytes] : known->files) collector.add("procedure/" + path, "procedure", bytes);
    return;
  }
  bundle.warnings.push_back("procedure/ is left out: the pack of " + base::quoted(named.id) +
                            " with which the model was made is not at hand; the study has it");
}

}  // namespace

std::vector<std::string> expertFileNames(const fuzzy::ForceModel& model) {
  std::vector<std::string> taken;
  std::vector<std::string> names;
  for (const fuzzy::Expert& expert : model.experts) names.push_back(fileName(expert.id, taken));
  return names;
}

base::Result<Bundle> makeBundle(fuzzy::ForceModel model, const BundleSettings& settings) {
  Bundle bundle;
  if (const auto ok = fuzzy::validate(model); !ok) return tl::unexpected(ok.error());
  if (const auto ok = acceptHoles(model, settings.accept_holes, bundle); !ok) return tl::unexpected(ok.error());
  model.checks = analysis::ownChecks(model);
  bundle.model = std::move(model);
  const fuzzy::ForceModel& made = bundle.model;
  TACTUS_TRY(const auto compiled, fuzzy::compile(made));

  bundle.manifest = {std::string(kModelPath), settings.created_utc, settings.generator, {}};
  // The model, the checks, the insertions, four sources, the table and the report, beside the experts.
  Collector collector(bundle, settings, 9 + made.experts.size() * std::size(exchange::kDialects));
  collector.next();
  const std::string text = model_io::formatModel(made);
  // What is written must read, with its checks.
  if (const auto read = model_io::parseModel(text, std::string(kModelPath)); !read) return tl::unexpected(read.error());
  collector.add(std::string(kModelPath), "model", text, exactPromise(made));
  bundle.model_sha256 = base::sha256(text);
  const exchange::Origin origin{bundle.model_sha256, made.created_utc, settings.generator};
  if (!collector.next()) return tl::unexpected(cancelled());
  const auto points = analysis::checkPoints(made);
  collector.add("checks.csv", "checks", checksText(made, analysis::checksAt(made, points)), exactPromise(made));
  addExperts(made, compiled, points, origin, collector);
  if (!addSources(made, compiled, points, settings, origin, bundle, collector)) return tl::unexpected(cancelled());
  if (!collector.next()) return tl::unexpected(cancelled());
  addTable(made, compiled, points, settings, origin, bundle, collector);
  if (!collector.next()) return tl::unexpected(cancelled());
  bundle.approvals = settings.approvals;
  if (!bundle.approvals.empty()) {
    collector.add(std::string(model_io::kApprovalsName), "approvals", model_io::formatApprovals(bundle.approvals));
  }
  addPack(made, settings, bundle, collector);
  collector.add("report.html", "report", bundleReport(bundle, compiled));
  bundle.files.emplace_back(std::string(model_io::kManifestName), model_io::formatManifest(bundle.manifest));
  bundle.fingerprint = base::sha256(bundle.files.back().second);
  return bundle;
}

}  // namespace tactus::bundle
