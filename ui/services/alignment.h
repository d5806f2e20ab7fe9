// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/document/project_document.h"
#include "ui/services/solve_service.h"

#include <QObject>

#include <map>
#include <memory>
#include <optional>
#include <string>

namespace cad2slam {

enum class AlignmentStatus {
  kNotReady,   ///< an image is missing or still loading
  kNoAnchors,  ///< nothing to solve
  kSolving,
  kUpToDate,
  kFailed,     ///< the last good result, if any, is still there
  kCancelled,  ///< the installer stopped the solve; the last good result is still there, of the document as it was
};

/// Keeps a document solved: asks for a solve after every edit that needs one and holds the last good result of each
/// SLAM map. A result of an older revision is kept for drawing until the next one lands; isCurrent() tells.
class Alignment : public QObject {
  Q_OBJECT

 public:
  explicit Alignment(ProjectDocument& document, QObject* parent = nullptr);

  /// The loaded images; null or empty while there is none. Asks for a solve when both are there.
  void setImages(std::shared_ptr<const OccupancyGrid> blueprint, std::optional<MapFrame> slam_frame);

  [[nodiscard]] AlignmentStatus status() const { return status_; }
  /// The last good result of the current SLAM map, or null.
  [[nodiscard]] const SolveResultPtr& result() const { return result_; }
  /// Whether the result is a full one of the document as it is.
  [[nodiscard]] bool isCurrent() const;
  [[nodiscard]] const std::optional<Error>& error() const { return error_; }  ///< with kFailed
  /// Last good results by SLAM map, of this blueprint.
  [[nodiscard]] const std::map<std::string, SolveResultPtr>& results() const { return results_; }

  /// Whether the SLAM maps that are not being edited are to be solved as well, when there is time. Edits of theirs and
  /// of the settings are followed; what is no longer asked for is dropped.
  void setOthersWanted(bool wanted);
  /// How a SLAM map that is not being edited stands; kNotReady while nobody wants it.
  [[nodiscard]] AlignmentStatus otherStatus(const std::string& map) const;
  [[nodiscard]] bool areOthersBusy() const;

  /// What a full solve of the current SLAM map is asked.
  [[nodiscard]] SolveRequest currentRequest() const { return requestFor(*document_.currentMap(), Quality::kFull); }

  void solveNow();  ///< again, although nothing changed
  void cancel();    ///< the other SLAM maps as well
  void requestSigma(const QPointF& point_in_blueprint);

 signals:
  void othersChanged();  ///< results or states of SLAM maps that are not being edited
  void resultChanged();
  void statusChanged();
  void progressed(int iteration);
  void sigmaKnown(const QPointF& point_in_blueprint, double sigma_m);

 private:
  void onChanged(const ChangeEvent& event);
  void ask(Quality quality);
  struct Other {
    AlignmentStatus status = AlignmentStatus::kNotReady;
    SolveRequest asked;
  };
  void askOthers();
  [[nodiscard]] SolveRequest requestFor(const ProjectSlamMap& map, Quality quality) const;
  void finishOther(const std::string& map, AlignmentStatus status);
  void setStopped();
  void setStatus(AlignmentStatus status);
  void setResult(SolveResultPtr result);

  ProjectDocument& document_;
  SolveService service_;
  std::shared_ptr<const OccupancyGrid> blueprint_;
  std::optional<MapFrame> slam_frame_;
  AlignmentStatus status_ = AlignmentStatus::kNotReady;
  SolveResultPtr result_;
  double full_solve_s_ = 0.0;  // of the last one
  std::map<std::string, SolveResultPtr> results_;
  std::optional<Error> error_;
  bool others_wanted_ = false;
  std::map<std::string, Other> others_;  // by SLAM map
};

}  // namespace cad2slam
