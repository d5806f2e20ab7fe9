// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0

// Drives the real window and prints what an installer would feel as one JSON object on stdout.
// usage: gui_bench [FOLDER]   FOLDER holds blueprint.yaml, slam.yaml (or slam_1.yaml) and anchors.csv (or
// anchors_1.csv)
// With a second argument it only writes the project there that the benchmark starts with.

#include "cad2slam/io/anchors_csv.h"
#include "ui/convert.h"
#include "ui/document/anchor_commands.h"
#include "ui/document/project_commands.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/process_setup.h"
#include "ui/main_window/project_files.h"
#include "ui/main_window/recovery.h"
#include "ui/main_window/tips.h"
#include "ui/panels/preview_panel.h"
#include "ui/views/map_view.h"

#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTimer>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <vector>

using namespace cad2slam;

namespace {

double now(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

/// How long [ms] this thread was ready to run while all processors were taken. The file stays open: this is asked a
/// thousand times a second.
double waitedForProcessor() {
  static const int statistics = open("/proc/thread-self/schedstat", O_RDONLY | O_CLOEXEC);
  std::array<char, 128> text{};
  if (pread(statistics, text.data(), text.size() - 1, 0) <= 0) return 0.0;
  return 1e-6 * QByteArray(text.data()).split(' ').value(1).toDouble();
}

/// The longest time [ms] the event loop was away, on the wall and on the processor, and how much of the longest on the
/// wall was waiting for a processor. On a busy machine only the second is the program's own.
class Heartbeat {
 public:
  Heartbeat() {
    QObject::connect(&timer_, &QTimer::timeout, &timer_, [this] { beat(); });
    timer_.setTimerType(Qt::PreciseTimer);
    timer_.start(1);
    reset();
  }
  void stop() { timer_.stop(); }
  void reset() {
    wall_ = now(CLOCK_MONOTONIC);
    own_ = now(CLOCK_THREAD_CPUTIME_ID);
    waited_ = waitedForProcessor();
    longest_wall_ = longest_own_ = longest_waited_ = 0.0;
  }
  [[nodiscard]] QJsonObject longest() const {
    return {{QStringLiteral("wall_ms"), longest_wall_},
            {QStringLiteral("of_it_waiting_for_processor_ms"), longest_waited_},
            {QStringLiteral("gui_thread_cpu_ms"), longest_own_}};
  }

 private:
  void beat() {
    const double wall = now(CLOCK_MONOTONIC);
    const double own = now(CLOCK_THREAD_CPUTIME_ID);
    const double waited = waitedForProcessor();
    if (wall - wall_ > longest_wall_) longest_waited_ = waited - waited_;
    longest_wall_ = std::max(longest_wall_, wall - wall_);
    longest_own_ = std::max(longest_own_, own - own_);
    wall_ = wall;
    own_ = own;
    waited_ = waited;
  }

  QTimer timer_;
  double wall_ = 0.0;
  double own_ = 0.0;
  double longest_wall_ = 0.0;
  double longest_own_ = 0.0;
  double waited_ = 0.0;
  double longest_waited_ = 0.0;
};

/// Sleeps between events as the program's own event loop does: a spinning one would take a processor from the workers.
bool waitFor(const std::function<bool()>& done, int patience_ms = 60'000) {
  QTimer alarm;  // so that it never sleeps for longer, whatever else happens
  alarm.start(20);
  QElapsedTimer since;
  since.start();
  while (!done()) {
    if (since.elapsed() > patience_ms) return false;
    QCoreApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents);
  }
  return true;
}

void idleFor(int ms) {
  QEventLoop loop;
  QTimer::singleShot(ms, &loop, &QEventLoop::quit);
  loop.exec();
}

double residentMegabytes(const char* field) {
  QFile status(QStringLiteral("/proc/self/status"));
  if (!status.open(QIODevice::ReadOnly)) return std::nan("");
  for (const QByteArray& line : status.readAll().split('\n'))
    if (line.startsWith(field)) return line.simplified().split(' ').value(1).toDouble() / 1024.0;
  return std::nan("");
}

QString firstThatExists(const QString& folder, const QStringList& names) {
  for (const QString& name : names)
    if (QFile::exists(folder + QLatin1Char('/') + name)) return folder + QLatin1Char('/') + name;
  return {};
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

/// By a window of its own, in a process of its own: what it leaves in memory is not the measured window's.
bool writeProject(const QString& folder, const AnchorList& anchors, const QString& project) {
  MainWindow window;
  window.files().setImage(Side::kBlueprint, folder + QStringLiteral("/blueprint.yaml"));
  window.files().setImage(Side::kSlam,
                          firstThatExists(folder, {QStringLiteral("slam.yaml"), QStringLiteral("slam_1.yaml")}));
  edit::addAnchors(window.session().document(), anchors, QStringLiteral("import"));
  return window.files().saveProjectTo(project);
}

}  // namespace

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", qEnvironmentVariable("QT_QPA_PLATFORM", QStringLiteral("offscreen")).toLocal8Bit());
  QStandardPaths::setTestModeEnabled(true);
  setUpProcess();
  QApplication app(argc, argv);
  QCoreApplication::setOrganizationName(QStringLiteral("cad2slam-bench"));
  const QTemporaryDir scratch;
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, scratch.path());
  Tips::setWanted(false);
  const QString folder = argc > 1 ? QString::fromLocal8Bit(argv[1]) : QStringLiteral(CAD2SLAM_SAMPLE_MAPS "/office");
  const auto anchors =
      readAnchors(toPath(firstThatExists(folder, {QStringLiteral("anchors.csv"), QStringLiteral("anchors_1.csv")})));
  if (!anchors) {
    std::fprintf(stderr, "gui_bench: %s\n", anchors.error().sentence().c_str());
    return 1;
  }
  QJsonObject report{{QStringLiteral("folder"), folder}};

  if (argc > 2) return writeProject(folder, anchors->anchors, QString::fromLocal8Bit(argv[2])) ? 0 : 1;
  const QString project = scratch.filePath(QStringLiteral("bench.c2sproj"));
  if (QProcess::execute(QCoreApplication::applicationFilePath(), {folder, project}) != 0) return 1;

  QElapsedTimer since;
  since.start();
  MainWindow window;
  window.resize(1400, 900);
  window.show();
  QCoreApplication::processEvents();
  Heartbeat heart;  // before it there is no window that could hang
  window.files().openProject(project);
  Session& session = window.session();
  const auto is_solved = [&] { return session.alignment().status() == AlignmentStatus::kUpToDate; };
  if (!waitFor([&] { return session.isReady(); })) return 1;
  QCoreApplication::processEvents();
  report.insert(QStringLiteral("start_to_usable_ms"), static_cast<double>(since.nsecsElapsed()) / 1e6);
  if (!waitFor(is_solved)) return 1;
  idleFor(2000);
  report.insert(QStringLiteral("longest_block_load"), heart.longest());
  report.insert(QStringLiteral("resident_mb"), residentMegabytes("VmRSS:"));

  // As many nodes as asked for in the issue.
  ProjectDocument& document = session.document();
  double cell = session.alignment().result()->mesh->lattice().cell_size;
  for (int i = 0; i < 4; ++i) {
    const double nodes = static_cast<double>(session.alignment().result()->mesh->nodeCount());
    cell *= std::sqrt(nodes / 4000.0);
    ProjectSettings settings{document.project().settings, cell, document.state().limits};
    edit::changeSettings(document, settings);
    if (!waitFor(is_solved)) return 1;
  }
  report.insert(QStringLiteral("nodes"), static_cast<int>(session.alignment().result()->mesh->nodeCount()));

  std::vector<double> to_first_answer;  // where the full one takes long, a rough one comes before it
  std::vector<double> to_table;
  std::vector<double> to_preview;
  std::vector<double> solve;
  heart.reset();
  for (int i = 0; i < 20; ++i) {
    idleFor(100);
    const Anchor& anchor = document.anchors()[static_cast<std::size_t>(i) % document.anchors().size()];
    const QImage before = window.preview().view().picture().image;
    since.restart();
    edit::moveAnchor(document, anchor.id, Side::kSlam, anchor.in_slam + Eigen::Vector2d(0.05, 0.0),
                     document.newGesture());
    const SolveResultPtr last = session.alignment().result();
    if (!waitFor([&] { return session.alignment().result() != last; })) return 1;
    to_first_answer.push_back(static_cast<double>(since.nsecsElapsed()) / 1e6);
    if (!waitFor(is_solved)) return 1;
    to_table.push_back(static_cast<double>(since.nsecsElapsed()) / 1e6);
    solve.push_back(1e3 * session.alignment().result()->seconds);
    if (!waitFor([&] { return window.preview().view().picture().image.cacheKey() != before.cacheKey(); }, 5000)) break;
    to_preview.push_back(static_cast<double>(since.nsecsElapsed()) / 1e6);
  }
  report.insert(QStringLiteral("click_to_first_answer_ms"), median(to_first_answer));
  report.insert(QStringLiteral("click_to_table_ms"), median(to_table));
  report.insert(QStringLiteral("of_it_solve_ms"), median(solve));
  if (!to_preview.empty()) report.insert(QStringLiteral("click_to_preview_ms"), median(to_preview));

  // A new anchor changes which nodes hang together, which a moved one does not.
  std::vector<double> added_to_table;
  for (int i = 0; i < 10; ++i) {
    const Anchor anchor = document.anchors()[static_cast<std::size_t>(i) % document.anchors().size()];
    edit::deleteAnchors(document, {anchor.id});
    if (!waitFor(is_solved)) return 1;
    idleFor(100);
    since.restart();
    edit::addAnchors(document, {anchor}, QStringLiteral("import"));
    if (!waitFor(is_solved)) return 1;
    added_to_table.push_back(static_cast<double>(since.nsecsElapsed()) / 1e6);
  }
  report.insert(QStringLiteral("new_anchor_to_table_ms"), median(added_to_table));
  report.insert(QStringLiteral("longest_block_solve"), heart.longest());

  heart.reset();
  MapView& view = window.view(Side::kSlam);
  int frames = 0;
  since.restart();
  while (since.elapsed() < 3000) {
    const double turn = static_cast<double>(since.elapsed()) / 500.0;
    ViewState state = view.viewState();
    state.center_m += QPointF(10.0 * state.m_per_px * std::cos(turn), 10.0 * state.m_per_px * std::sin(turn));
    view.setViewState(state);
    QCoreApplication::processEvents();
    ++frames;
  }
  report.insert(QStringLiteral("pan_frames_per_s"), frames / (static_cast<double>(since.nsecsElapsed()) / 1e9));
  report.insert(QStringLiteral("longest_block_pan"), heart.longest());

  heart.stop();  // it wakes a thousand times a second itself
  idleFor(3000);
  report.insert(QStringLiteral("resident_peak_mb"), residentMegabytes("VmHWM:"));
  {
    const double begin = now(CLOCK_PROCESS_CPUTIME_ID);
    idleFor(4000);
    report.insert(QStringLiteral("idle_cpu_percent"), (now(CLOCK_PROCESS_CPUTIME_ID) - begin) / 40.0);
  }
  window.recovery().autosave().clear();
  std::printf("%s", QJsonDocument(report).toJson().constData());
  return 0;
}
