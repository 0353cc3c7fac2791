// The stroke in which a hand feels the largest difference between the two sides of the comparison, and how far they
// differ anywhere: searched in the background. Method: docs/tell.md.
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <cstddef>
#include <memory>
#include <vector>

#include "app/workbench/base/computed.h"
#include "app/workbench/model/open_model.h"
#include "app/workbench/tune/history/compare_controller.h"
#include "core/contracts/telling_stroke.h"

class QDialog;
class QWidget;

namespace tactus::workbench {

/// A moment of the stroke with both forces.
struct ToldMoment {
  contracts::StrokeMoment at;
  fuzzy::Evaluation a;
  fuzzy::Evaluation b;
  bool felt = false;  ///< the forces differ by one just-noticeable difference or more
};

struct Told {
  contracts::TellingStroke found;
  contracts::StrokeInputs inputs;
  std::vector<ToldMoment> moments;  ///< equally spaced in time, both ends
};

/// Thread: gui.
class TellController : public QObject {
  Q_OBJECT

 public:
  /// Both outlive this.
  TellController(CompareController& compare, EditController& edits, QObject* parent = nullptr);

  /// What was compared.
  struct Question {
    std::shared_ptr<const OpenModel> a;
    std::shared_ptr<const OpenModel> b;
    QString a_name;
    QString b_name;
  };

  /// Searches for the present sides of the comparison as long as `hold` holds. Returns whether there are two models to
  /// compare; else `refused` says why not.
  bool begin();
  void cancel() { search_.cancel(); }
  void hold(QObject& holder, bool held = true) { search_.hold(holder, held); }

  bool isBusy() const { return search_.isBusy(); }
  double progress() const { return search_.progress(); }
  /// Null before the first.
  const Question* question() const { return question_.get(); }
  /// Null without a result.
  const Told* told() const { return search_.value().get(); }
  /// Another pair is compared now, or the open model was edited.
  bool isOld() const { return old_; }

  // The result in words; empty without one.

  /// `Felt: 3.02 JND in the mean square over its time`, or `None felt: …`.
  QString verdict() const;
  /// How far the two differ at most at any place, certainly.
  QString bound() const;
  /// One line each: the way and the speed, the conditions, the largest difference, places without a force.
  QStringList details() const;
  /// Why there is no result; empty if there is one or none was asked for.
  QString failure() const { return search_.failure(); }

 signals:
  void changed();
  void refused(const QString& sentence);
  /// What the user wants to do with the stroke; there is a result.
  void playAsked();
  void duelAsked();
  void keepAsked();

 private:
  using Search = Computed<std::shared_ptr<const Question>, Told>;
  static Search::Answer answerOf(const std::shared_ptr<const Question>& question, const RunOf<Told>& run);

  CompareController& compare_;
  EditController& edits_;
  std::shared_ptr<const Question> question_;
  CompareChoice sides_[2];
  bool old_ = false;
  Search search_;
};

/// The window of the search and its result; it holds the search while it is visible. `parent` owns it.
QDialog* makeTellWindow(TellController& tell, QWidget* parent);

}  // namespace tactus::workbench
