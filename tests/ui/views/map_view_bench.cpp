// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
//
// Measures how a MapView loads, pans, zooms and turns a large raster: cad2slam_map_view_bench [IMAGE [SIDE]]
// Without an image it writes and reads a synthetic plan of SIDE x SIDE pixels (default 20 000). Prints one JSON object.
#include <time.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <vector>

#include <QApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTimer>

#include <opencv2/imgcodecs.hpp>

#include "ui/convert.h"
#include "ui/support/rasters.h"
#include "ui/views/map_view.h"

namespace cad2slam {
namespace {

double cpuMs(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) / 1e6;
}
double processCpuMs() {
  return cpuMs(CLOCK_PROCESS_CPUTIME_ID);
}

/// Longest turn of the event loop, in time of the GUI thread: what it would be on an idle machine.
class Heartbeat : public QObject {
 public:
  Heartbeat() {
    timer_.setInterval(4);
    connect(&timer_, &QTimer::timeout, this, [this] {
      const double now = cpuMs(CLOCK_THREAD_CPUTIME_ID);
      longest_ms_ = std::max(longest_ms_, now - last_ms_);
      last_ms_ = now;
    });
    timer_.start();
  }
  void reset() {
    last_ms_ = cpuMs(CLOCK_THREAD_CPUTIME_ID);
    longest_ms_ = 0.0;
  }
  [[nodiscard]] double longestMs() const { return longest_ms_; }

 private:
  QTimer timer_;
  double last_ms_ = cpuMs(CLOCK_THREAD_CPUTIME_ID);
  double longest_ms_ = 0.0;
};

QJsonObject summary(std::vector<double> frames_ms) {
  std::sort(frames_ms.begin(), frames_ms.end());
  const auto last = static_cast<double>(frames_ms.size() - 1);
  const auto at = [&](double part) { return frames_ms[static_cast<std::size_t>(part * last)]; };
  return {{QStringLiteral("frames"), static_cast<qint64>(frames_ms.size())},
          {QStringLiteral("median_ms"), at(0.5)},
          {QStringLiteral("p95_ms"), at(0.95)},
          {QStringLiteral("max_ms"), at(1.0)}};
}

QJsonObject measured(MapView& view, int frames, const std::function<void(int)>& step) {
  std::vector<double> times;
  double cpu_ms = 0.0;
  for (int i = 0; i < frames; ++i) {
    QElapsedTimer timer;
    timer.start();
    const double cpu_start_ms = processCpuMs();
    step(i);
    view.repaint();
    times.push_back(static_cast<double>(timer.nsecsElapsed()) / 1e6);
    cpu_ms += processCpuMs() - cpu_start_ms;
    QCoreApplication::processEvents(QEventLoop::AllEvents, 5);
  }
  QJsonObject result = summary(times);
  result[QStringLiteral("mean_cpu_ms")] = cpu_ms / frames;  // of all threads: tells on a busy machine as well
  return result;
}

double residentMib(const char* key) {
  QFile status(QStringLiteral("/proc/self/status"));
  if (!status.open(QFile::ReadOnly)) return 0.0;
  for (const QByteArray& line : status.readAll().split('\n')) {
    if (line.startsWith(key))
      return line.mid(static_cast<int>(qstrlen(key)) + 1).simplified().split(' ')[0].toDouble() / 1024.0;
  }
  return 0.0;
}

int run(const QStringList& arguments) {
  QTemporaryDir folder;
  QString image = arguments.value(1);
  if (image.isEmpty() || image == QStringLiteral("-")) {
    const int side = std::max(100, arguments.value(2, QStringLiteral("20000")).toInt());
    image = folder.filePath(QStringLiteral("plan.png"));
    if (!cv::imwrite(image.toStdString(), test::floorPlan(side, side), {cv::IMWRITE_PNG_COMPRESSION, 3})) return 1;
  }
  QJsonObject report{{QStringLiteral("rss_before_mib"), residentMib("VmRSS:")}};

  MapView view;
  view.resize(1920, 1080);
  view.setEmptyText(QStringLiteral("Loading"));
  view.show();
  view.repaint();  // fonts are loaded before the measurement
  Heartbeat heartbeat;
  QElapsedTimer timer;
  timer.start();
  const double cpu_start_ms = processCpuMs();
  const std::shared_ptr<TilePyramid> pyramid = TilePyramid::load(toPath(image));
  double first_ms = 0.0;
  QObject::connect(pyramid.get(), &TilePyramid::sizeKnown, &view, [&] {
    const double before_ms = cpuMs(CLOCK_THREAD_CPUTIME_ID);
    view.setImage(pyramid);
    view.setFrame(*MapFrame::create(0.05, pyramid->size().width(), pyramid->size().height(), {}));
    view.fit();
    view.repaint();
    if (first_ms == 0.0) report[QStringLiteral("first_paint_ms")] = cpuMs(CLOCK_THREAD_CPUTIME_ID) - before_ms;
    heartbeat.reset();
    if (first_ms == 0.0) first_ms = static_cast<double>(timer.nsecsElapsed()) / 1e6;
  });
  while (pyramid->state() == TilePyramid::State::kLoading)
    QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
  if (pyramid->state() == TilePyramid::State::kFailed) {
    std::fprintf(stderr, "%s\n", qPrintable(pyramid->error()));
    return 1;
  }
  report[QStringLiteral("width")] = pyramid->size().width();
  report[QStringLiteral("height")] = pyramid->size().height();
  report[QStringLiteral("first_view_ms")] = first_ms;
  report[QStringLiteral("loaded_ms")] = static_cast<double>(timer.nsecsElapsed()) / 1e6;
  report[QStringLiteral("loaded_cpu_ms")] = processCpuMs() - cpu_start_ms;
  report[QStringLiteral("longest_block_loading_ms")] = heartbeat.longestMs();

  std::vector<Marker> markers;
  for (int i = 0; i < 200; ++i) {
    Marker marker;
    marker.id = i + 1;
    marker.text = QString::number(i + 1);
    marker.point_m = toQPointF(view.frame()->metricFromPixel(
        {std::fmod(i * 137.0, 20.0) / 20.0 * view.frame()->width(), (i / 200.0) * view.frame()->height()}));
    marker.judged = static_cast<MarkerClass>(i % 4);
    markers.push_back(marker);
  }
  view.setMarkers(markers);

  const auto panBy = [&](double x, double y) {
    ViewState state = view.viewState();
    const QPointF way = view.metresFromWidget(QPointF(x, y)) - view.metresFromWidget(QPointF(0, 0));
    state.center_m += way;
    view.setViewState(state);
  };
  const QPointF middle = view.viewState().center_m;
  view.fit();
  report[QStringLiteral("pan_whole")] = measured(view, 120, [&](int i) { panBy(i < 60 ? 4 : -4, i % 3); });
  view.showActualSize();
  view.centerOn(middle, false);
  report[QStringLiteral("pan_100_percent")] = measured(view, 300, [&](int) { panBy(31, 17); });
  view.setViewState({middle, 0.05 * 2.6, 0.0});
  report[QStringLiteral("pan_between_levels")] = measured(view, 300, [&](int) { panBy(-23, 19); });
  view.setViewState({middle, 0.05 * 1.3, 0.6});
  report[QStringLiteral("pan_turned")] = measured(view, 200, [&](int) { panBy(13, 29); });
  view.fit();
  report[QStringLiteral("zoom")] = measured(view, 200, [&](int i) { view.zoomBy(i < 100 ? 1.06 : 1.0 / 1.06); });
  report[QStringLiteral("turn")] = measured(view, 100, [&](int i) { view.setRotation(0.02 * i); });
  view.setRotation(0.0);

  auto mesh = std::make_shared<MeshOverlay>();
  constexpr int kSide = 225;  // 225 x 225 nodes: 100 800 edges
  for (int row = 0; row < kSide; ++row) {
    for (int column = 0; column < kSide; ++column) {
      const auto here = static_cast<std::uint32_t>(row * kSide + column);
      mesh->nodes_m.push_back(
          toQPointF(view.frame()->metricFromPixel({(column + 0.3 * std::sin(row * 0.2)) / kSide * view.frame()->width(),
                                                   row * 1.0 / kSide * view.frame()->height()})));
      if (column > 0) mesh->edges.push_back({here - 1, here});
      if (row > 0) mesh->edges.push_back({here - kSide, here});
    }
  }
  mesh->strain.assign(mesh->edges.size(), 0.02F);
  view.setMesh(mesh);
  view.fit();
  report[QStringLiteral("mesh_edges")] = static_cast<qint64>(mesh->edges.size());
  report[QStringLiteral("pan_with_mesh")] = measured(view, 120, [&](int i) { panBy(i < 60 ? 4 : -4, i % 3); });
  report[QStringLiteral("zoom_with_mesh")] =
      measured(view, 100, [&](int i) { view.zoomBy(i < 50 ? 1.06 : 1.0 / 1.06); });

  report[QStringLiteral("packed_mib")] = static_cast<double>(pyramid->store()->packedBytes()) / (1 << 20);
  report[QStringLiteral("unpacked_mib")] = static_cast<double>(pyramid->store()->unpackedBytes()) / (1 << 20);
  report[QStringLiteral("spilled_mib")] = static_cast<double>(pyramid->store()->spilledBytes()) / (1 << 20);
  report[QStringLiteral("rss_mib")] = residentMib("VmRSS:");
  report[QStringLiteral("peak_rss_mib")] = residentMib("VmHWM:");
  std::printf("%s", QJsonDocument(report).toJson().constData());
  return 0;
}

}  // namespace
}  // namespace cad2slam

int main(int argc, char** argv) {
  QApplication app(argc, argv);
  return cad2slam::run(QCoreApplication::arguments());
}
