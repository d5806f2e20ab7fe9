// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/services/preview_service.h"

#include <exception>

#include "ui/engine_sentences.h"

namespace cad2slam {
namespace {

constexpr double kSlow_s = 0.045;      // a sharp picture that takes longer is preceded by a coarse one
constexpr double kCoarse = 1.0 / 3.0;  // of the resolution
constexpr int kRest_ms = 60;           // without a request, before a slow sharp picture is begun

}  // namespace

PreviewService::PreviewService(QObject* parent)
    : QObject(parent),
      job_(
          [](const Task& task) -> Answer {
            try {
              return {renderPreview(task.request), task};
            } catch (const std::exception& failure) {
              return {fail(ErrorCode::kInternal, failure.what()), task};
            }
          },
          [this](const Answer& answer) { take(answer); }, Lane::Threads::kOwn) {
  sharpen_.setSingleShot(true);
  sharpen_.setInterval(kRest_ms);
  connect(&sharpen_, &QTimer::timeout, this, [this] {
    if (wanted_.scene) job_.request({wanted_, true});
  });
}

void PreviewService::setScene(std::shared_ptr<const PreviewScene> scene) {
  wanted_.scene = std::move(scene);
  if (!wanted_.scene) {
    sharpen_.stop();
    job_.cancel();
  } else if (!wanted_.size.isEmpty()) {
    start();
  }
}

void PreviewService::request(PreviewKind kind, const ViewState& state, const QSize& size, double ratio) {
  wanted_.kind = kind;
  wanted_.state = state;
  wanted_.size = size;
  wanted_.ratio = ratio;
  if (wanted_.scene && !size.isEmpty()) start();
}

void PreviewService::start() {
  sharpen_.stop();
  Task task{wanted_, true};
  if (sharp_seconds_ > kSlow_s) {
    task.request.ratio *= kCoarse;
    task.sharp = false;
  }
  job_.request(std::move(task));
}

void PreviewService::take(const Answer& answer) {
  const bool newest = !job_.isBusy();
  const bool same_scene = answer.of.request.scene == wanted_.scene;
  if (!answer.picture) {
    if (newest) emit failed(toSentence(answer.picture.error()));
    return;
  }
  if (answer.of.sharp) sharp_seconds_ = answer.picture->seconds;
  if (same_scene || !newest) emit pictureReady(*answer.picture);
  if (!newest) return;
  if (answer.of.sharp) {
    emit idle();
  } else {
    sharpen_.start();
  }
}

}  // namespace cad2slam
