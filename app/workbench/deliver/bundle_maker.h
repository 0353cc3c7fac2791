// Makes the bundle of the open model in the background and reads it back.
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <optional>
#include <stop_token>
#include <vector>

#include "app/workbench/base/columns.h"
#include "app/workbench/base/worker.h"
#include "core/fuzzy/force_model.h"

namespace tactus::workbench {

// The folder of a bundle that the user makes in the window.

/// The folder of the bundle of the model file or study `model_path`, for the folder that the user chose: `chosen`
/// itself if it is empty or holds an earlier bundle, otherwise a folder `NAME-bundle` in it.
QString bundleFolder(const QString& chosen, const QString& model_path);
/// What is proposed for the bundle of this model: `ngt-bundle`.
QString bundleName(const QString& model_path);

/// The files of a bundle as a table: what each promises, and what was found.
struct DeliveredFile {
  QString path;
  QString rule;                   ///< `exact`, `midpoint:1000`, …; empty for a file without forces
  std::optional<double> error_n;  ///< the largest found; nothing for a file without forces
  double tolerance_n = 0;
  bool ok = true;
  QString wrong;  ///< one sentence where `ok` is false
};

std::vector<Column<DeliveredFile>> deliveredColumns();

/// An error in newtons with two digits: `0.0025 N`, `1.1e-12 N`, `0 N`.
QString errorText(double newtons);

/// How a reader of the file computes the centroid: `exact`, `1000 middles`, `101 points`, `grid, linear between`.
QString centroidText(const QString& rule);

class EditController;

/// A bundle that was read back.
struct Delivered {
  QString folder;
  QString fingerprint;  ///< of its manifest, in four groups
  bool made = false;    ///< by this program just before; otherwise it was there
  bool ok = false;      ///< each file is unaltered and within its tolerance
  std::vector<DeliveredFile> files;
  QStringList warnings;     ///< files that were left out, and why
  fuzzy::ForceModel model;  ///< of the folder
};

/// Thread: gui.
class BundleMaker : public QObject {
  Q_OBJECT

 public:
  enum class Doing { kNothing, kMaking, kWriting, kReadingBack };

  explicit BundleMaker(EditController& edits, QObject* parent = nullptr);
  /// Cancels a bundle in progress.
  ~BundleMaker() override;

  Doing doing() const { return doing_; }
  /// Of the files to be made.
  std::size_t done() const { return done_; }
  std::size_t all() const { return all_; }
  /// What the work in progress, or the last one, was begun for: kMaking, or kReadingBack alone.
  Doing asked() const { return asked_; }
  /// Where the work in progress goes.
  const QString& folder() const { return folder_; }
  /// Nothing is written yet, and `cancel` has not been called.
  bool mayCancel() const;

  /// The last bundle; nothing before the first, or if the last work failed.
  const std::optional<Delivered>& delivered() const { return delivered_; }
  /// The open model has other forces or is felt in another way.
  bool isOld() const { return delivered_ && old_; }
  /// Why the last work failed, in one sentence; empty if it did not.
  const QString& failure() const { return failure_; }

  /// Makes the bundle of the open model in `folder`, whole or not at all, and reads it back. Ignored while working.
  void make(const QString& folder);
  /// Reads the bundle in `folder`.
  void readBack(const QString& folder);
  /// The folder stays as it was.
  void cancel();

 signals:
  /// Any of the above.
  void changed();

 private:
  struct End {
    std::optional<Delivered> delivered;
    QString failure;
  };
  static End readBackIn(const QString& folder);
  void begin(Doing doing, const QString& folder);
  void tell(Doing doing, std::size_t done, std::size_t all);
  void onEnd(End end);
  void compare();

  EditController& edits_;
  Doing doing_ = Doing::kNothing;
  Doing asked_ = Doing::kNothing;
  std::size_t done_ = 0;
  std::size_t all_ = 0;
  QString folder_;
  std::optional<Delivered> delivered_;
  bool old_ = false;
  QString failure_;
  std::stop_source stop_;
  CallQueue answers_;
  Background worker_;  ///< last: its end waits for the job, which posts to `answers_`
};

}  // namespace tactus::workbench
