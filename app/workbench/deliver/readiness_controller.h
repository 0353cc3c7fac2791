// The readiness of the open model, kept up to date, and the acceptance of its holes by name.
#pragma once

#include <QObject>
#include <string>
#include <vector>

#include "app/workbench/base/messages.h"
#include "app/workbench/deliver/readiness.h"

namespace tactus::workbench {

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
  BuildNotes notes_;
  std::vector<ReadinessLine> lines_;
};

}  // namespace tactus::workbench
