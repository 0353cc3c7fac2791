// A procedure as data: what is inserted, along which way, in which words experts speak of it. A procedure is read from
// a pack, a folder of files (docs/procedure-packs.md). The code outside the packs knows no particular procedure.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/fuzzy/force_model.h"
#include "core/study/records.h"

namespace tactus::procedure {

/// A text by language (BCP 47: `en`, `zh-Hant`).
using Texts = std::map<std::string, std::string>;

/// The files of a pack by their path in it, `/` between folders.
using PackFiles = std::map<std::string, std::string>;

/// A named list of terms of the way. It has no term for a region that its form does not ask about.
struct TermSet {
  std::string id;
  std::string label;
  std::vector<fuzzy::Term> terms;

  bool operator==(const TermSet&) const = default;
};

/// The declared direction of the force for a growing input. No law: an expert's rules may say the opposite.
enum class Direction { kNone, kFalls, kRises };

/// How the levels of a condition are drawn beside its words.
enum class LevelPicture {
  kBars,    ///< `bars`: as many as the level
  kDrops,   ///< `drops`: of a lubricant
  kArrows,  ///< `arrows`: of a speed
  kPose,    ///< `pose`: the body, one picture for each level
};
inline constexpr LevelPicture kLevelPictures[] = {LevelPicture::kBars, LevelPicture::kDrops, LevelPicture::kArrows,
                                                  LevelPicture::kPose};

/// What a pack says of one input beside its variable.
struct InputNotes {
  Direction direction = Direction::kNone;
  double usual = 0;            ///< where curves along another input are shown
  std::string own_model = {};  ///< term at which a participant feels her own model; empty: `usual`
  LevelPicture picture = LevelPicture::kBars;
};

/// A step of the procedure, as the bench shows it.
struct Step {
  Texts title;
  Texts text;
  std::optional<double> from_mm;  ///< the step begins at this place of the tip; nothing: before the way
};

/// A structure along the way.
struct Landmark {
  Texts name;
  Texts what;
  double from_mm = 0;
  double to_mm = 0;
  std::string source;
};

/// A published figure of a model of this procedure: where its inputs stand, and what varies in it.
struct Figure {
  Texts name;                        ///< `Fig. 11`
  Texts shows;                       ///< in a few words
  std::map<std::string, double> at;  ///< value of each input that the figure sets, by its id
  std::string varied;                ///< id of the input that differs from curve to curve; empty: none
  std::vector<double> values;        ///< of that input, one for each curve
  std::vector<std::string> map;      ///< ids of the two axes of a map or surface; empty: the figure has curves
};

/// A force that somebody else published of a like procedure, for comparison. No part of the model.
struct PublishedForce {
  Texts label;         ///< what was measured
  std::string source;  ///< who published it
  Texts is_not;        ///< why it is not the force of this procedure
  double from_mm = 0;  ///< where along the way it was measured
  double to_mm = 0;
  double low_n = 0;  ///< the range; both ends are one where a single value was published
  double high_n = 0;
};

struct Point {
  double x = 0;
  double y = 0;
};

/// A part of a picture.
struct Box {
  double left = 0, top = 0, width = 0, height = 0;
};

inline bool holds(const Box& box, const Point& at) {
  return at.x >= box.left && at.x <= box.left + box.width && at.y >= box.top && at.y <= box.top + box.height;
}

/// Where in a picture the front of the body is.
enum class FrontSide { kLeft, kRight, kTop, kBottom };

/// A picture of the body with the way of the tip in it, from an SVG file. Coordinates are those of its view box.
struct Picture {
  std::string file;                ///< path in the pack
  study::ItemCondition pose = {};  ///< the condition that it shows; empty: the usual one
  double left = 0, top = 0, width = 0, height = 0;
  std::vector<Point> way;          ///< close points, from where the tip enters; a deeper tip stays at its end
  std::vector<double> way_mm;      ///< the place of each point, rising
  std::vector<double> way_across;  ///< how far each point lies before the plane of the picture
  std::vector<Point> approach;     ///< of the tool to where it enters; none: it comes straight
  std::optional<Box> near;         ///< the part that most questions are about; nothing: all regions
  std::map<std::string, std::string> regions;  ///< `d` of the outline of each region, by its id
  std::string svg;                             ///< the whole picture
  std::vector<Point> outline;                  ///< of the whole body, closed; none: there is no 3-D view
  std::optional<double> breadth;               ///< of the body across the picture, at its broadest
  FrontSide front = FrontSide::kLeft;
};

/// The body from another side, to look at.
struct OtherView {
  std::string file;         ///< path in the pack
  std::string word;         ///< id of the text that says from where
  bool of_regions = false;  ///< stands beside the names of the regions; otherwise beside the whole way
};

/// Where the tip is at `place_mm`; clamped to the way.
Point placeAt(const Picture& picture, double place_mm);

/// Reads the picture in `svg`, whose way lies between `from_mm` and `to_mm` and which has the regions `regions`; `file`
/// is its name in errors. Refused: what docs/procedure-packs.md does not allow.
base::Result<Picture> readPicture(std::string_view svg, const std::string& file, double from_mm, double to_mm,
                                  const std::vector<std::string>& regions);

struct Procedure;
/// The pictures and the other views that the manifest names, from the files of `procedure`.
base::Result<void> readPictures(Procedure& procedure);

/// The file with which a pack begins.
inline constexpr std::string_view kManifest = "procedure.json";

/// The words of the participant's screens, from the file `path` of `files`; empty: the pack has none. `name` is the
/// pack's name in errors. Refused: words in other languages than the pack's, and a pack without those that its inputs
/// and forms need.
base::Result<void> readWords(Procedure& procedure, const PackFiles& files, const std::string& path,
                             const std::string& name);

/// The points of a path that `readPicture` took.
std::vector<Point> pointsOf(std::string_view path);

struct Procedure {
  std::string id;
  int version = 1;  ///< of the pack
  std::string sha256;
  Texts title;
  std::vector<std::string> languages;   ///< first the one in which everything is worded
  std::vector<std::string> unreviewed;  ///< languages whose words no native expert has read
  std::string about;                    ///< what the procedure models, and what it does not
  std::vector<std::string> sources;

  std::vector<fuzzy::Variable> inputs;  ///< the way has the terms of its first set
  std::vector<InputNotes> input_notes;  ///< one per input
  fuzzy::Variable output;
  std::vector<TermSet> way_terms;      ///< at least one
  std::vector<study::Form> forms;      ///< at least one, the first is that of a new study
  std::vector<std::string> wordings;   ///< paths of the wordings of the forms (questionnaires/questionnaire.h)
  std::map<std::string, Texts> words;  ///< of the participant's screens: id of the text, then by language
  std::vector<Picture> pictures;       ///< none: a bar of regions stands for the body
  std::vector<OtherView> other_views;
  std::vector<Step> steps;
  std::vector<Landmark> landmarks;
  std::vector<PublishedForce> published;
  std::vector<Figure> figures;
  std::string protocol;     ///< JSON of the settings of a session; empty: the usual ones
  double device_scale = 1;  ///< 1 : scale; a device gives the forces divided by it, where they are beyond its strength
  /// Beside the word of a force the participant says whether this is where she would stop (Tefik et al. 2024).
  bool stop_question = false;
  std::vector<fuzzy::TubeEvent> events;  ///< on terms that each set of the way has

  PackFiles files;

  std::size_t way() const;                  ///< index of the input of the role `way`
  std::optional<std::size_t> rate() const;  ///< index of the input of the role `rate`
  const fuzzy::Variable& wayInput() const { return inputs[way()]; }
  const fuzzy::Variable* rateInput() const;
  std::vector<std::string> inputIds() const;  ///< the input columns of rules.csv
  const TermSet* wayTerms(std::string_view set) const;
  const study::Form* form(std::string_view form_id) const;
  std::string titleIn(std::string_view language) const;
};

/// The pictures of the procedure; of one without pictures a plain bar of its regions.
std::vector<Picture> picturesOf(const Procedure& procedure);

/// The regions about which `form` asks, in the order of the way.
std::vector<std::string> regionsOf(const Procedure& procedure, const study::Form& form);

/// The text in `language`, otherwise in English, otherwise in the first language there is; empty without any.
std::string textIn(const Texts& texts, std::string_view language);

/// Reads a procedure from the files of a pack; `name` is the pack's name in errors. Refused, each with one sentence:
/// what docs/procedure-packs.md does not allow.
base::Result<Procedure> readProcedure(PackFiles files, const std::string& name);

/// The same for the pack in the folder `path`. Refused as well: a link that leads out of the folder, a file above
/// kMostFileBytes, a pack above kMostPackBytes.
base::Result<Procedure> readPackFolder(const std::string& path);

inline constexpr std::size_t kMostFileBytes = std::size_t{4} << 20U;
inline constexpr std::size_t kMostPackBytes = std::size_t{16} << 20U;

/// The SHA-256 of the sorted list of paths and of the SHA-256 of each file.
std::string packSha256(const PackFiles& files);

// The packs that the program carries.

/// Their ids, first that of a study that names none.
std::vector<std::string> builtInIds();
/// Null for an unknown id. The procedure is kept as long as the program runs.
std::shared_ptr<const Procedure> builtIn(std::string_view id);
/// The procedure of a study that names none: nasogastric tube insertion.
const std::shared_ptr<const Procedure>& defaultProcedure();

/// The procedure itself, or that of a study that names none.
inline const Procedure& orDefault(const std::shared_ptr<const Procedure>& procedure) {
  return procedure != nullptr ? *procedure : *defaultProcedure();
}
/// The procedure of `study`.
inline const Procedure& of(const study::Study& study) { return orDefault(study.procedure); }

// What a model says of its procedure.

/// What the provenance of a model built under `procedure` says of it. A model of the default procedure says nothing.
fuzzy::NamedJson modelSetting(const Procedure& procedure);

struct ModelProcedure {
  std::string id;                               ///< empty if it cannot be read
  std::string sha256;                           ///< of its pack; empty: the default procedure, or not known
  std::map<std::string, Direction> directions;  ///< declared ones, by input
};

/// The procedure that the provenance of `model` names; the default one if it names none.
ModelProcedure procedureOf(const fuzzy::ForceModel& model);

}  // namespace tactus::procedure
