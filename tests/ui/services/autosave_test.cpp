// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/services/autosave.h"

#include "ui/convert.h"
#include "ui/document/anchor_commands.h"
#include "ui/support/documents.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <memory>

using namespace cad2slam;

/// A journal is what a killed program leaves: here it is read while its program lives, as a copy without its lock.
class AutosaveTest : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<ProjectDocument> document_;
  std::unique_ptr<Autosave> autosave_;

  [[nodiscard]] QString root() const { return folder_->filePath(QStringLiteral("journals")); }
  /// Anchors of the newest version in the journal; none where there is no journal.
  [[nodiscard]] std::optional<std::size_t> journaled() {
    autosave_->flush();
    const QDir journal(autosave_->folder());
    if (autosave_->folder().isEmpty() || !journal.exists()) return std::nullopt;
    const QStringList versions = journal.entryList({QStringLiteral("*.c2sproj")}, QDir::Files, QDir::Name);
    if (versions.isEmpty()) return std::nullopt;
    const Result<Project> project = readProject(toPath(journal.filePath(versions.last())));
    return project ? std::optional(project->slam_maps.at(0).anchors.size()) : std::nullopt;
  }
  void addAnchor() { edit::addAnchor(*document_, {1.0, 1.0}, {2.0, 2.0}); }
  void save() { document_->markSaved("/nowhere/site.c2sproj"); }

 private slots:
  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    document_ = std::make_unique<ProjectDocument>();
    autosave_ = std::make_unique<Autosave>(*document_, root());
    document_->reset(test::smallProject(), "/nowhere/site.c2sproj");
  }
  void cleanup() {
    autosave_.reset();
    document_.reset();
  }

  void nothingUnsavedIsNoJournal() { QVERIFY(!journaled()); }

  void theFirstEditIsJournaled() {
    addAnchor();
    QCOMPARE(journaled(), std::optional<std::size_t>(1));
    addAnchor();
    QCOMPARE(journaled(), std::optional<std::size_t>(2));
  }

  void theFirstEditAfterASaveIsJournaled() {
    addAnchor();
    save();
    QVERIFY(!journaled());
    addAnchor();
    QCOMPARE(journaled(), std::optional<std::size_t>(2));
  }

  void undoAndRedoThatLeaveWhatIsSavedAreJournaled() {
    addAnchor();
    addAnchor();
    save();
    document_->undoStack().undo();
    QVERIFY(document_->isModified());
    QCOMPARE(journaled(), std::optional<std::size_t>(1));
    document_->undoStack().redo();
    QVERIFY(!document_->isModified());
    QVERIFY(!journaled());
    document_->undoStack().undo();
    save();
    document_->undoStack().redo();
    QCOMPARE(journaled(), std::optional<std::size_t>(2));
  }

  void aDragIsJournaledAtItsEnd() {
    addAnchor();
    save();
    const int gesture = document_->newGesture();
    for (int i = 1; i <= 5; ++i) edit::moveAnchor(*document_, 1, Side::kSlam, {2.0 + i, 2.0}, gesture, true);
    edit::moveAnchor(*document_, 1, Side::kSlam, {9.0, 2.0}, gesture, false, true);
    QVERIFY(journaled());
    const QDir journal(autosave_->folder());
    const QStringList versions = journal.entryList({QStringLiteral("*.c2sproj")}, QDir::Files, QDir::Name);
    const Result<Project> last = readProject(toPath(journal.filePath(versions.last())));
    QCOMPARE(last->slam_maps.at(0).anchors.at(0).in_slam, Eigen::Vector2d(9.0, 2.0));
  }
};

QTEST_GUILESS_MAIN(AutosaveTest)
#include "autosave_test.moc"
