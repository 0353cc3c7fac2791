// Whether the open model is ready for a simulator: one line for each thing to know before it is delivered.
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/workbench/base/messages.h"

namespace tactus::workbench {

enum class ReadinessTopic {
  kHoles,
  kForceSteps,
  kConflicts,
  kExpertsApart,
  kContracts,
  kSignOff,
  kData,
  kMethod,
  kOrigin,
  kChecks,
};
inline constexpr std::size_t kReadinessTopics = 10;

enum class Readiness {
  kReady,
  kLook,     ///< the researcher should know it; the bundle can be made
  kBlocks,   ///< no bundle before it is settled
  kUnknown,  ///< still being looked for
};

struct ReadinessLine {
  ReadinessTopic topic = ReadinessTopic::kHoles;
  Readiness state = Readiness::kUnknown;
  QString name;      ///< `Holes`
  QString sentence;  ///< one sentence
  QString act;       ///< of the button, which leads to the place or to the act

  bool operator==(const ReadinessLine&) const = default;
};

/// What the lint says about the open model.
struct DeliverFindings {
  /// A place where no rule of any expert fires.
  struct Hole {
    std::string name;  ///< as analysis::describe gives it, and as --accept-hole takes it
    QString words;     ///< the same with the labels of the model
    bool accepted = false;

    bool operator==(const Hole&) const = default;
  };

  bool current = false;  ///< they are of the open model; otherwise they are being looked for
  bool complete = true;  ///< false: the search for holes was cut off
  std::vector<Hole> holes;
  std::size_t conflicts = 0;
  std::size_t apart = 0;  ///< places where two experts are more than two just-noticeable differences apart
  QString most_apart;     ///< the largest of these differences, with its unit
  std::size_t steps = 0;  ///< places where the force steps as it is felt, or steeper than the renderer can
  QString largest_step;   ///< with its unit

  bool operator==(const DeliverFindings&) const = default;
};

/// Whether the open model keeps its contracts.
struct DeliverContracts {
  bool current = true;  ///< all are checked; otherwise that is on its way
  std::size_t proved = 0;
  std::size_t broken = 0;
  std::size_t open = 0;
  QString first_broken;  ///< its sentence

  bool operator==(const DeliverContracts&) const = default;
};

struct ReadinessFacts {
  DeliverFindings findings;
  DeliverContracts contracts;
  std::size_t experts = 0;
  QString default_force;                            ///< where no rule fires
  std::size_t edits = 0;                            ///< since the last sign-off on the way to the current state
  std::optional<QString> signed_by;                 ///< of the current state
  bool signed_felt = true;                          ///< that sign-off says that the state was felt
  std::size_t data_notes = 0;                       ///< on the study's data, where the open study keeps the model
  std::size_t build_notes = 0;                      ///< of the build from them
  QString first_note;                               ///< the weightiest on the data
  QStringList unlike_published;                     ///< settings of the build that are not those of the paper
  std::optional<QString> newtons_unlike_published;  ///< by which they move the force, with its unit
  bool simulated = false;
  QStringList without_force;  ///< real persons on a device that gives no force
  bool origin_known = true;   ///< the file says what data the model is from
  /// The bundle that was made or read back last.
  struct Bundle {
    QString folder;      ///< its name
    bool holds = false;  ///< each file is within its tolerance
    bool old = false;    ///< the model has changed since
  };
  std::optional<Bundle> bundle;
};

/// A line for each topic, in the order of the topics.
std::vector<ReadinessLine> readinessLines(const ReadinessFacts& facts);

/// The lines in one heading: what stops the bundle, or else how many things are open.
QString readinessSummary(const std::vector<ReadinessLine>& lines);

/// `Ready`, `Look at it`, …: the state for people who do not see its sign.
QString readinessName(Readiness state);

// The readiness of the open model, kept up to date, and the acceptance of its holes by name.

class BundleMaker;
class EditController;
class ModelController;

/// Thread: gui.
class ReadinessController : public QObject {
  Q_OBJECT

 public:
  /// All three outlive this.
  ReadinessController(const ModelController& models, EditController& edits, const BundleMaker& maker,
                      QObject* parent = nullptr);

  /// What the lint says now.
  void setFindings(DeliverFindings findings);
  const DeliverFindings& findings() const { return findings_; }

  void setContracts(DeliverContracts contracts);

  /// What the open study says about the model that it keeps; empty where it keeps another one.
  void setNotes(BuildNotes notes);
  const BuildNotes& notes() const { return notes_; }

  /// Empty if no model is open.
  const std::vector<ReadinessLine>& lines() const { return lines_; }
  /// A line says that something has to be settled before a bundle can be made.
  bool blocks() const;

 public slots:
  /// Accepts the hole as an edit of the model, with undo and author.
  void acceptHole(const std::string& name);

 signals:
  void changed();

 private:
  void update();
  ReadinessFacts facts() const;

  const ModelController& models_;
  EditController& edits_;
  const BundleMaker& maker_;
  DeliverFindings findings_;
  DeliverContracts contracts_;
  BuildNotes notes_;
  std::vector<ReadinessLine> lines_;
};

}  // namespace tactus::workbench
