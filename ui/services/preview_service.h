// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QTimer>

#include "ui/services/preview_renderer.h"
#include "ui/views/latest_job.h"

namespace cad2slam {

/// Makes preview pictures on a thread of its own; the newest request wins. Where a sharp picture takes long, a coarse
/// one comes first, so that the preview follows a drag.
class PreviewService : public QObject {
  Q_OBJECT

 public:
  explicit PreviewService(QObject* parent = nullptr);

  /// What to draw from now on; null stops.
  void setScene(std::shared_ptr<const PreviewScene> scene);
  [[nodiscard]] const std::shared_ptr<const PreviewScene>& scene() const { return wanted_.scene; }
  /// The part of the map, with its margin. Asking for the same again draws it again.
  void request(PreviewKind kind, const ViewState& state, const QSize& size, double ratio);
  [[nodiscard]] bool isBusy() const { return job_.isBusy(); }

 signals:
  void pictureReady(const cad2slam::PreviewPicture& picture);
  void failed(const QString& sentence);
  void idle();  ///< the newest request has its sharp picture

 private:
  struct Task {
    PreviewRequest request;
    bool sharp = true;
  };
  struct Answer {
    Result<PreviewPicture> picture;
    Task of;
  };
  void start();
  void take(const Answer& answer);

  PreviewRequest wanted_;
  double sharp_seconds_ = 0.0;  // of the last sharp picture
  QTimer sharpen_;              // after a coarse one, when nothing else is asked for
  LatestJob<Task, Answer> job_;
};

}  // namespace cad2slam
