// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cad2slam/core/result.h"
#include "ui/document/change_event.h"
#include "ui/document/document_state.h"

#include <QJsonObject>
#include <QObject>
#include <QUndoStack>

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace cad2slam {

/// The project being edited: its state, its undo stack and where it is saved. Holds no pixels.
/// Only commands change what undo restores (see anchor_commands.h and project_commands.h); every change is announced
/// once, after it is complete.
class ProjectDocument : public QObject {
  Q_OBJECT

 public:
  explicit ProjectDocument(QObject* parent = nullptr);
  ~ProjectDocument() override;

  [[nodiscard]] const DocumentState& state() const { return state_; }
  [[nodiscard]] const Project& project() const { return state_.project; }
  [[nodiscard]] bool hasBlueprint() const { return !project().blueprint.metadata.image.empty(); }

  /// The SLAM map being edited, or nullptr while the project has none.
  [[nodiscard]] const ProjectSlamMap* currentMap() const;
  [[nodiscard]] std::string currentMapName() const;  ///< empty while the project has no SLAM map
  void setCurrentMap(const std::string& name);       ///< an unknown name is ignored

  [[nodiscard]] const AnchorList& anchors() const;  ///< of the current SLAM map
  [[nodiscard]] const Anchor* anchor(AnchorId id) const;
  [[nodiscard]] bool isSnapped(AnchorId id) const;
  /// What the next anchor is called; above all others, and where a file has used up the numbers, the lowest free one.
  [[nodiscard]] AnchorId nextId() const;

  /// Counts edits that make earlier results out of date.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }

  [[nodiscard]] QUndoStack& undoStack() { return undo_stack_; }
  [[nodiscard]] int newGesture() { return ++last_gesture_; }  ///< names a drag or a burst of key presses

  /// The half anchor is saved with the project, but it is no edit: undo does not know it.
  [[nodiscard]] std::optional<PendingAnchor> pending() const;
  void setPending(std::optional<PendingAnchor> pending);

  /// No anchor may be changed: for looking only.
  [[nodiscard]] bool isLocked() const { return locked_; }
  void setLocked(bool locked);
  /// Commands ask before they touch an anchor; where they may not, editRefused() tells the user why.
  [[nodiscard]] bool mayEditAnchors();

  /// What the window wants to remember with the project (zoom, overlay, ...). Changing it does not modify the document.
  [[nodiscard]] const QJsonObject& viewState() const { return view_state_; }
  void setViewState(const QJsonObject& view_state) { view_state_ = view_state; }

  /// Replaces everything and empties the undo stack. `path` empty: not saved yet. `recovered`: counts as modified.
  void reset(Project project, const std::filesystem::path& path, bool recovered = false);
  void markSaved(const std::filesystem::path& path);
  /// Fills in size and hash of an image that a worker has found out; no edit.
  void describeRasters(const std::string& map_name, const ProjectRaster& blueprint, const ProjectRaster& slam);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] bool isModified() const;
  /// The project as it should be written, view state and all.
  [[nodiscard]] Project projectToSave() const;

 signals:
  void changed(const cad2slam::ChangeEvent& event);
  void editRefused();

 private:
  friend class EditAnchorsCommand;
  friend class EditProjectCommand;

  enum class Direction { kRedo, kUndo };
  void applyAnchorChanges(const std::string& map, const std::vector<AnchorChange>& changes, AnchorId next_id,
                          Direction direction, ChangeEvent event);
  void applyState(const DocumentState& state, const std::string& current_map, ChangeEvent event);

  [[nodiscard]] ProjectSlamMap* mapNamed(const std::string& name);
  [[nodiscard]] std::map<std::string, PendingAnchor> pendingOfAllMaps() const;
  void announce(const ChangeEvent& event);

  DocumentState state_;
  QUndoStack undo_stack_;
  std::filesystem::path path_;
  QJsonObject view_state_;
  std::string current_map_;
  std::uint64_t revision_ = 0;
  int last_gesture_ = 0;
  bool locked_ = false;
  bool never_saved_ = false;  // recovered after a crash
  // What is saved but no step of undo, as it was when last saved.
  bool saved_locked_ = false;
  std::map<std::string, PendingAnchor> saved_pending_;
};

}  // namespace cad2slam

Q_DECLARE_METATYPE(cad2slam::ChangeEvent)
