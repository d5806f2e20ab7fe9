// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/document/project_document.h"

#include "ui/document/anchor_commands.h"
#include "ui/document/anchor_selection.h"
#include "ui/document/project_commands.h"
#include "ui/support/documents.h"

#include <QSignalSpy>
#include <QTest>

#include <functional>
#include <random>

using namespace cad2slam;
using test::fingerprint;

namespace {

using Edit = std::function<void(ProjectDocument&)>;

MapFrame blueprintFrame(const ProjectDocument& document) {
  const MapMetadata& metadata = document.project().blueprint.metadata;
  return *MapFrame::create(metadata.resolution_m_per_px, 801, 600, metadata.metric_from_corner);
}

/// Everything an installer can do, once.
std::vector<std::pair<const char*, Edit>> edits() {
  return {
      {"add",
       [](auto& d) {
         edit::addAnchor(d, {1.1, 2.2}, {3.3, 4.4});
       }},
      {"add snapped",
       [](auto& d) {
         edit::addAnchor(d, {5.1, 0.3}, {-3.3, 1.7}, true);
       }},
      {"move",
       [](auto& d) {
         edit::moveAnchor(d, 1, Side::kSlam, {9.1, 9.7}, d.newGesture());
       }},
      {"type",
       [](auto& d) {
         edit::setCoordinates(d, 2, {0.1, 0.2}, {0.3, 0.4});
       }},
      {"disable",
       [](auto& d) {
         edit::setEnabled(d, {1, 3}, false);
       }},
      {"rename", [](auto& d) { edit::rename(d, 1, "pillar"); }},
      {"note", [](auto& d) { edit::setNote(d, 2, "behind the door"); }},
      {"swap", [](auto& d) { edit::swapCounterparts(d, 1, 2); }},
      {"import",
       [](auto& d) {
         edit::addAnchors(d, {Anchor{.id = 2}, Anchor{.id = 17}}, QStringLiteral("import"));
       }},
      {"delete many",
       [](auto& d) {
         edit::deleteAnchors(d, {1, 3});
       }},
      {"rescale", [](auto& d) { edit::rescaleBlueprint(d, 1.0 / 3.0); }},
      {"flip", [](auto& d) { edit::flipBlueprint(d, blueprintFrame(d)); }},
      {"settings",
       [](auto& d) {
         ProjectSettings settings{d.project().settings, 1.5, d.state().limits};
         settings.solver.lambda_y = 3.0;
         settings.limits.ok_m = 0.2;
         edit::changeSettings(d, settings);
       }},
      {"add map", [](auto& d) { edit::addSlamMap(d, "robot 1", {}); }},
      {"rename map", [](auto& d) { edit::renameSlamMap(d, d.currentMapName(), "robot 9"); }},
      {"remove map", [](auto& d) { edit::removeSlamMap(d, d.currentMapName()); }},
      {"other image", [](auto& d) { edit::setBlueprint(d, {}); }},
  };
}

}  // namespace

class ProjectDocumentTest : public QObject {
  Q_OBJECT

 private:
  ProjectDocument document_;

  void addThree() {
    edit::addAnchor(document_, {1, 1}, {2, 2});
    edit::addAnchor(document_, {3, 1}, {4, 2}, true);
    edit::addAnchor(document_, {3, 5}, {4, 6});
  }

 private slots:
  void init() { document_.reset(test::smallProject(), "/nowhere/site.c2sproj"); }

  void scenario8_everyEditUndoesAndRedoesToTheBit_data() {
    QTest::addColumn<int>("at");
    for (std::size_t i = 0; i < edits().size(); ++i) QTest::newRow(edits()[i].first) << int(i);
  }
  void scenario8_everyEditUndoesAndRedoesToTheBit() {
    QFETCH(int, at);
    addThree();
    const std::string before = fingerprint(document_);
    const int steps = document_.undoStack().index();
    edits()[std::size_t(at)].second(document_);
    const std::string after = fingerprint(document_);
    QVERIFY(before != after);
    QCOMPARE(document_.undoStack().index(), steps + 1);
    document_.undoStack().undo();
    QCOMPARE(fingerprint(document_), before);
    document_.undoStack().redo();
    QCOMPARE(fingerprint(document_), after);
  }

  void scenario8_aLongSessionUndoesToTheStart() {
    std::mt19937 random(7);
    const std::string start = fingerprint(document_);
    addThree();
    const auto all = edits();
    for (int i = 0; i < 400; ++i) all[random() % all.size()].second(document_);
    const std::string end = fingerprint(document_);
    while (document_.undoStack().canUndo()) document_.undoStack().undo();
    QCOMPARE(fingerprint(document_), start);
    while (document_.undoStack().canRedo()) document_.undoStack().redo();
    QCOMPARE(fingerprint(document_), end);
  }

  void eachEditIsAnnouncedOnceAndComplete() {
    addThree();
    for (const auto& [name, edit] : edits()) {
      QSignalSpy spy(&document_, &ProjectDocument::changed);
      int about_content = 0;
      edit(document_);
      for (const QList<QVariant>& call : spy)
        about_content += call.at(0).value<ChangeEvent>().what != Changes(Change::kSavedState);
      QVERIFY2(about_content == 1, name);
    }
  }

  void aDragIsOneStepAndOnlyItsEndAsksForTheFullAnswer() {
    addThree();
    const std::string before = fingerprint(document_);
    const int steps = document_.undoStack().index();
    const int gesture = document_.newGesture();
    QSignalSpy spy(&document_, &ProjectDocument::changed);
    for (int i = 1; i <= 20; ++i) edit::moveAnchor(document_, 2, Side::kSlam, {4.0 + i, 2.0}, gesture, true);
    edit::moveAnchor(document_, 2, Side::kSlam, {24.0, 2.0}, gesture, false, true);
    QCOMPARE(document_.undoStack().index(), steps + 1);
    QCOMPARE(spy.first().at(0).value<ChangeEvent>().interim, true);
    QCOMPARE(spy.last().at(0).value<ChangeEvent>().interim, false);
    QVERIFY(spy.last().at(0).value<ChangeEvent>().needsSolve());
    document_.undoStack().undo();
    QCOMPARE(fingerprint(document_), before);
    document_.undoStack().redo();
    QCOMPARE(document_.anchor(2)->in_slam, Eigen::Vector2d(24.0, 2.0));
  }

  void aDragBackToItsStartLeavesNoStep() {
    addThree();
    const std::string before = fingerprint(document_);
    const int steps = document_.undoStack().count();
    const int gesture = document_.newGesture();
    edit::moveAnchor(document_, 2, Side::kSlam, {40.0, 2.0}, gesture, true);
    edit::moveAnchor(document_, 2, Side::kSlam, {4.0, 2.0}, gesture, false, true);
    QCOMPARE(document_.undoStack().count(), steps);
    QCOMPARE(fingerprint(document_), before);
  }

  void twoDragsAreTwoSteps() {
    addThree();
    const int steps = document_.undoStack().index();
    edit::moveAnchor(document_, 2, Side::kSlam, {5, 2}, document_.newGesture());
    edit::moveAnchor(document_, 2, Side::kSlam, {6, 2}, document_.newGesture());
    QCOMPARE(document_.undoStack().index(), steps + 2);
  }

  void numbersAreNeverReused() {
    addThree();
    edit::deleteAnchors(document_, {3});
    QCOMPARE(edit::addAnchor(document_, {7, 7}, {8, 8}), AnchorId(4));
    const auto imported = edit::addAnchors(document_, {Anchor{.id = 1}, Anchor{.id = 30}}, QStringLiteral("import"));
    QCOMPARE(imported, (std::vector<AnchorId>{31, 30}));
    QCOMPARE(document_.nextId(), AnchorId(32));
    edit::deleteAnchors(document_, {30, 31});
    ProjectDocument reopened;
    reopened.reset(document_.projectToSave(), {});
    QCOMPARE(reopened.nextId(), AnchorId(32));
  }

  void theLargestNumberOfAFileIsNoEnd() {
    addThree();
    const auto imported = edit::addAnchors(
        document_, {Anchor{.id = kLargestAnchorId}, Anchor{.id = 1}, Anchor{.id = 2}}, QStringLiteral("import"));
    QCOMPARE(imported, (std::vector<AnchorId>{kLargestAnchorId, 4, 5}));
    QCOMPARE(edit::addAnchor(document_, {7, 7}, {8, 8}), AnchorId(6));
    edit::rename(document_, 6, "door");
    QCOMPARE(document_.nextId(), AnchorId(7));
    const Project saved = document_.projectToSave();
    const Result<Project> read = parseProject(formatProject(saved, "/nowhere/a.c2sproj"), "/nowhere/a.c2sproj");
    QVERIFY(read.has_value());
    ProjectDocument reopened;
    reopened.reset(*read, {});
    QCOMPARE(edit::addAnchor(reopened, {9, 9}, {8, 8}), AnchorId(7));
    document_.undoStack().undo();
    document_.undoStack().undo();
    document_.undoStack().undo();
    QCOMPARE(document_.nextId(), AnchorId(4));
  }

  void nothingHappensWhereNothingChanges() {
    addThree();
    const int steps = document_.undoStack().count();
    edit::setEnabled(document_, {1, 2, 3}, true);
    edit::rename(document_, 1, "");
    edit::deleteAnchors(document_, {99});
    edit::rescaleBlueprint(document_, 1.0);
    edit::rescaleBlueprint(document_, -2.0);
    edit::rescaleBlueprint(document_, 1e6);  // more than a project can hold
    edit::rescaleBlueprint(document_, 1e-6);
    edit::changeSettings(document_, {document_.project().settings, document_.project().cell_size_m, {}});
    QVERIFY(edit::renameSlamMap(document_, "robot 1", "robot 1"));
    QVERIFY(!edit::renameSlamMap(document_, "robot 1", ""));
    QCOMPARE(document_.undoStack().count(), steps);
  }

  void rescaleKeepsAnchorsOnTheirPixels() {
    addThree();
    const Eigen::Vector2d pixel = blueprintFrame(document_).pixelFromMetric(document_.anchor(3)->in_blueprint);
    edit::rescaleBlueprint(document_, 1.37);
    const Eigen::Vector2d after = blueprintFrame(document_).pixelFromMetric(document_.anchor(3)->in_blueprint);
    QVERIFY((pixel - after).norm() < 1e-9);
    QCOMPARE(document_.anchor(3)->in_slam, Eigen::Vector2d(4, 6));
  }

  void flipMirrorsAnchorsWithThePicture() {
    addThree();
    const Eigen::Vector2d pixel = blueprintFrame(document_).pixelFromMetric(document_.anchor(3)->in_blueprint);
    edit::flipBlueprint(document_, blueprintFrame(document_));
    const Eigen::Vector2d after = blueprintFrame(document_).pixelFromMetric(document_.anchor(3)->in_blueprint);
    QVERIFY(std::abs(pixel.x() + after.x() - 801.0) < 1e-9);
    QVERIFY(std::abs(pixel.y() - after.y()) < 1e-9);
    QVERIFY(document_.project().blueprint.metadata.mirrored);
  }

  void scenario28_modifiedOnlyWhileSomethingIsUnsaved() {
    QVERIFY(!document_.isModified());
    addThree();
    QVERIFY(document_.isModified());
    document_.markSaved("/nowhere/site.c2sproj");
    QVERIFY(!document_.isModified());
    document_.undoStack().undo();
    QVERIFY(document_.isModified());
    document_.undoStack().redo();
    QVERIFY(!document_.isModified());
    document_.setViewState({{QStringLiteral("zoom"), 3}});
    QVERIFY(!document_.isModified());
  }

  void undoSurvivesSaving() {
    addThree();
    document_.markSaved("/nowhere/site.c2sproj");
    document_.undoStack().undo();
    QCOMPARE(document_.anchors().size(), std::size_t(2));
  }

  void aHalfAnchorIsSavedButNoStep() {
    document_.setPending(PendingAnchor{true, 1.5, 2.5});
    QCOMPARE(document_.undoStack().count(), 0);
    QVERIFY(document_.isModified());
    QVERIFY(document_.projectToSave().slam_maps[0].pending.has_value());
    document_.setPending(std::nullopt);
    QVERIFY(!document_.pending());
  }

  void undoOfAnotherMapsEditShowsThatMap() {
    addThree();
    edit::addSlamMap(document_, "robot 2", {});
    QCOMPARE(document_.currentMapName(), std::string("robot 2"));
    document_.setCurrentMap("robot 1");
    edit::rename(document_, 1, "door");
    document_.setCurrentMap("robot 2");
    document_.undoStack().undo();
    QCOMPARE(document_.currentMapName(), std::string("robot 1"));
    QVERIFY(document_.anchor(1)->name.empty());
  }

  void undoThatGoesToAnotherMapSaysSo() {
    ProjectRaster other;
    other.metadata.image = "/nowhere/other.png";
    edit::addSlamMap(document_, "robot 2", other);
    document_.setCurrentMap("robot 1");
    edit::changeSettings(document_, {document_.project().settings, 1.5, document_.state().limits});
    document_.setCurrentMap("robot 2");
    const auto announced = [this](auto step) {
      Changes what;
      const auto seen =
          connect(&document_, &ProjectDocument::changed, this, [&](const ChangeEvent& event) { what |= event.what; });
      step();
      disconnect(seen);
      return what;
    };
    const Changes needed = Change::kCurrentMap | Change::kAnchors | Change::kPending;
    const auto undo = [this] { document_.undoStack().undo(); };
    const auto redo = [this] { document_.undoStack().redo(); };
    for (const auto& step : {std::function<void()>(undo), std::function<void()>(redo)}) {
      document_.setCurrentMap("robot 2");
      QVERIFY((announced(step) & needed) == needed);
      QCOMPARE(document_.currentMapName(), std::string("robot 1"));
    }
    // A new name is no other map; to go back to one that has got a new name is.
    const auto rename = [this] { QVERIFY(edit::renameSlamMap(document_, "robot 1", "cleaner")); };
    QVERIFY(!(announced(rename) & Change::kCurrentMap));
    QVERIFY(!(announced(undo) & Change::kCurrentMap));
    QVERIFY(!(announced(redo) & Change::kCurrentMap));
    document_.setCurrentMap("robot 2");
    QVERIFY((announced(undo) & needed) == needed);
    QCOMPARE(document_.currentMapName(), std::string("robot 1"));
    // The same map in another file.
    const auto choose = [this, other] { edit::setSlamRaster(document_, "robot 1", other); };
    QVERIFY(!(announced(choose) & Change::kCurrentMap));
    document_.setCurrentMap("robot 2");
    QVERIFY((announced(undo) & needed) == needed);
  }

  void whatIsKnownOfTheImagesSurvivesUndo() {
    const auto described = [](const ProjectRaster& raster, const char* hash) {
      ProjectRaster result = raster;
      result.image_bytes = 7;
      result.image_sha256 = hash;
      return result;
    };
    const auto hash_now = [this] { return document_.project().blueprint.image_sha256; };
    edit::addSlamMap(document_, "robot 2", document_.project().slam_maps[0].raster);
    ProjectRaster plan = document_.project().blueprint;
    document_.describeRasters("robot 2", described(plan, "plan"), described(document_.currentMap()->raster, "slam"));
    document_.undoStack().undo();
    QCOMPARE(hash_now(), std::string("plan"));
    QCOMPARE(document_.project().blueprint.image_bytes, std::uintmax_t(7));
    document_.undoStack().redo();
    QCOMPARE(hash_now(), std::string("plan"));
    QCOMPARE(document_.currentMap()->raster.image_sha256, std::string("slam"));
    // The same file chosen anew holds another picture; undo goes back to the first, redo to the second.
    edit::setBlueprint(document_, plan);
    QVERIFY(hash_now().empty());
    document_.describeRasters({}, described(plan, "plan as it is now"), {});
    document_.undoStack().undo();
    QCOMPARE(hash_now(), std::string("plan"));
    document_.undoStack().redo();
    QCOMPARE(hash_now(), std::string("plan as it is now"));
  }

  void lockedAnchorsStayWhoeverAsks() {
    addThree();
    document_.setLocked(true);
    const AnchorList before = document_.anchors();
    QSignalSpy refused(&document_, &ProjectDocument::editRefused);
    const int steps = document_.undoStack().count();
    edit::addAnchor(document_, {1.0, 2.0}, {3.0, 4.0});
    edit::addAnchors(document_, {Anchor{.id = 17}}, QStringLiteral("import"));
    edit::moveAnchor(document_, 1, Side::kSlam, {9.0, 9.0}, document_.newGesture());
    edit::setEnabled(document_, {1}, false);
    edit::swapCounterparts(document_, 1, 2);
    edit::deleteAnchors(document_, {1, 2});
    edit::rescaleBlueprint(document_, 2.0);
    edit::removeSlamMap(document_, document_.currentMapName());
    QCOMPARE(document_.undoStack().count(), steps);
    QCOMPARE(refused.size(), 8);
    QCOMPARE(document_.anchors().size(), before.size());
    for (std::size_t i = 0; i < before.size(); ++i) QVERIFY(document_.anchors()[i].in_slam == before[i].in_slam);
  }

  void aHalfAnchorStaysUnlessItsGroundMoves() {
    addThree();
    const PendingAnchor half{false, 1.0, 2.0};
    document_.setPending(half);
    QVERIFY(edit::renameSlamMap(document_, document_.currentMapName(), "cleaner"));
    QVERIFY(document_.pending() == half);
    edit::addSlamMap(document_, "robot 2", {});
    document_.setCurrentMap("cleaner");
    QVERIFY(document_.pending() == half);
    edit::rescaleBlueprint(document_, 2.0);
    QVERIFY(document_.pending() == half);  // it is in the SLAM map
    document_.setPending(PendingAnchor{true, 1.0, 2.0});
    edit::rescaleBlueprint(document_, 2.0);
    QVERIFY(!document_.pending());
  }

  void aHalfAnchorStaysWithItsImage() {
    addThree();
    ProjectRaster plan = document_.project().blueprint;
    plan.image_sha256 = "of the plan";
    edit::setBlueprint(document_, plan);
    document_.setPending(PendingAnchor{true, 1.0, 2.0});
    plan.metadata.image = "/moved/plan.png";
    edit::setBlueprint(document_, plan);
    QVERIFY(document_.pending());
    plan.metadata.image = "/moved/another_plan.png";
    plan.image_sha256 = "of another";
    edit::setBlueprint(document_, plan);
    QVERIFY(!document_.pending());
  }

  void nothingIsModifiedWhereNothingDiffersFromWhatIsSaved() {
    addThree();
    document_.markSaved("/nowhere/site.c2sproj");
    document_.setPending(PendingAnchor{});
    QVERIFY(document_.isModified());
    document_.setPending(std::nullopt);
    QVERIFY(!document_.isModified());
    document_.setLocked(true);
    QVERIFY(document_.isModified());
    document_.setLocked(false);
    QVERIFY(!document_.isModified());
  }

  void revisionCountsOnlyWhatASolveDependsOn() {
    addThree();
    const auto revision = document_.revision();
    edit::rename(document_, 1, "door");
    edit::setNote(document_, 1, "green");
    document_.setPending(PendingAnchor{});
    document_.setLocked(true);
    QCOMPARE(document_.revision(), revision);
    document_.setLocked(false);
    edit::setEnabled(document_, {1}, false);
    QVERIFY(document_.revision() > revision);
  }

  void scenario9_undoOfDeleteRestoresTheSelection() {
    AnchorSelection selection(document_);
    addThree();
    selection.set({1, 2, 3});
    edit::deleteAnchors(document_, {1, 2, 3});
    QVERIFY(selection.ids().empty());
    document_.undoStack().undo();
    QCOMPARE(selection.ids().size(), std::size_t(3));
  }

  void anotherProjectOrMapBeginsWithNothingSelected() {
    AnchorSelection selection(document_);
    addThree();
    Project other = document_.project();
    selection.set({1, 2});
    document_.reset(other, {});
    QVERIFY(selection.ids().empty());
    selection.set({1, 2});
    QVERIFY(edit::renameSlamMap(document_, "robot 1", "cleaner"));
    QCOMPARE(selection.ids().size(), std::size_t(2));
    other.slam_maps.push_back(other.slam_maps[0]);
    other.slam_maps[1].name = "robot 2";
    document_.reset(other, {});
    selection.set({1, 2});
    document_.setCurrentMap("robot 2");
    QVERIFY(selection.ids().empty());
    // Undo that goes to another map still selects what it brings back.
    edit::deleteAnchors(document_, {3});
    document_.setCurrentMap("robot 1");
    document_.undoStack().undo();
    QCOMPARE(selection.ids(), std::vector<AnchorId>{3});
  }

  void onlyAnchorsThatExistAreSelected() {
    addThree();
    AnchorSelection selection(document_);
    const AnchorId first = document_.anchors().front().id;
    selection.set({first, 0, document_.nextId()});
    QCOMPARE(selection.ids(), std::vector<AnchorId>{first});
    selection.toggle(document_.nextId());
    QCOMPARE(selection.ids(), std::vector<AnchorId>{first});
    edit::deleteAnchors(document_, {first});
    QVERIFY(selection.ids().empty());
  }
};

QTEST_GUILESS_MAIN(ProjectDocumentTest)
#include "project_document_test.moc"
