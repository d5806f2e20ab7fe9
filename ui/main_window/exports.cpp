// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/exports.h"

#include "cad2slam/io/anchors_csv.h"
#include "cad2slam/io/projector_file.h"
#include "cad2slam/io/qgis_points.h"
#include "ui/convert.h"
#include "ui/dialogs/save_path.h"
#include "ui/document/anchor_commands.h"
#include "ui/engine_sentences.h"
#include "ui/main_window/typing.h"
#include "ui/models/number_text.h"
#include "ui/panels/message_bar.h"
#include "ui/services/blueprint_map.h"
#include "ui/services/guarded.h"
#include "ui/services/solve_worker.h"
#include "ui/views/lane.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QEventLoop>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QFutureWatcher>
#include <QLocale>
#include <QProgressDialog>
#include <QScopeGuard>
#include <QStandardPaths>
#include <QTimeZone>
#include <QTimer>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace cad2slam {
namespace {

constexpr double kReadBackTolerance = 1e-9;   // metres and radians: the file holds doubles
constexpr double kRoundTripTolerance = 1e-6;  // metres

using Verdict = ExportCheck::Verdict;

/// Of the image that was solved on.
FrameInfo frameInfo(const std::string& name, const RasterStore& rasters, Side side) {
  const MapFrame& frame = *rasters.frame(side);
  return {name, rasters.imageHash(side), frame.resolution(), frame.width(), frame.height(), frame.metricFromCorner()};
}

/// In the words of the system, local time; what is no date is shown as it is.
QString dateText(const std::string& iso_utc) {
  if (iso_utc.empty()) return Exports::tr("an unknown date");
  const QDateTime created = QDateTime::fromString(toQString(iso_utc), Qt::ISODate);
  return created.isValid() ? QLocale().toString(created.toLocalTime(), QLocale::ShortFormat) : toQString(iso_utc);
}

/// The largest difference between what was meant and what a robot will compute from the file [m, rad].
Result<double> readBackDifference(const std::filesystem::path& path, const Projector& meant, const Mesh& mesh) {
  const Result<Projector> read = loadProjector(path);
  if (!read) return failAs(read);
  double largest = 0.0;
  for (const Eigen::Vector2d& center : mesh.centers()) {
    const Projection a = meant.slamFromBlueprint(Pose2{center, 0.5}, OutsidePolicy::kRigid);
    const Projection b = read->slamFromBlueprint(Pose2{center, 0.5}, OutsidePolicy::kRigid);
    if (a.status != b.status) return fail(ErrorCode::kInternal, "The file reads back with other values");
    if (!a.ok()) continue;
    largest = std::max({largest, (a.pose.translation - b.pose.translation).norm(),
                        std::abs(wrapAngle(a.pose.heading - b.pose.heading))});
    const Projection back = read->blueprintFromSlam(b.pose, OutsidePolicy::kRigid);
    if (back.ok() && (back.pose.translation - center).norm() > kRoundTripTolerance && read->foldedTileCount() == 0)
      return fail(ErrorCode::kInternal, "Going there and back through the file does not return to the start");
  }
  return largest;
}

/// Not what the blueprint itself may be called.
QString blueprintMapBeside(const QString& projector_path) {
  const QFileInfo file(projector_path);
  return file.dir().filePath(file.completeBaseName() + QStringLiteral("-blueprint-in-slam.yaml"));
}

ExportCheck whyNotCurrent(AlignmentStatus status) {
  switch (status) {
    case AlignmentStatus::kSolving:
      return {Verdict::kRefused, Exports::tr("The alignment is still being computed: wait for the green chip")};
    case AlignmentStatus::kCancelled:
      return {Verdict::kRefused, Exports::tr("The last solve was stopped, so there is nothing current to export"),
              true};
    case AlignmentStatus::kFailed:
      return {Verdict::kRefused, Exports::tr("The last solve failed, so there is nothing current to export")};
    default:
      return {Verdict::kRefused, Exports::tr("There is no alignment yet: place anchors first")};
  }
}

}  // namespace

std::vector<ExportCheck> exportChecks(Session& session, const QStringList& findings) {
  std::vector<ExportCheck> checks;
  if (!session.isReady()) {  // also where an image that was solved with breaks off later
    checks.push_back({Verdict::kRefused, Exports::tr("An image is missing, or still being read")});
    return checks;
  }
  if (!session.alignment().isCurrent()) {
    checks.push_back(whyNotCurrent(session.alignment().status()));
    return checks;
  }
  const SolveResultPtr& result = session.alignment().result();
  const AlignmentSummary& summary = session.summary();
  if (summary.used < 3) {
    checks.push_back(
        {Verdict::kWarning, Exports::tr("Only %1 anchors are used: the map is not bent to fit; 4 or more are "
                                        "needed for checked results")
                                .arg(summary.used)});
  } else if (!summary.median_leave_one_out_m) {
    checks.push_back({Verdict::kWarning, Exports::tr("%1 anchors are used, RMS of the residuals %2")
                                             .arg(summary.used)
                                             .arg(lengthText(summary.rms_residual_m.value_or(0.0)))});
  } else {
    // A mesh bends to whatever it is given: only what an anchor is missed by without itself tells how good it is.
    const double slam_m_per_px = session.rasters().frame(Side::kSlam)->resolution();
    const bool unpredicted = isUnpredicted(summary, session.document().state().limits, slam_m_per_px);
    checks.push_back({unpredicted ? Verdict::kWarning : Verdict::kGood,
                      Exports::tr("Without itself, an anchor is typically %1 off; %2 anchors are used, RMS of the "
                                  "residuals %3")
                          .arg(lengthText(*summary.median_leave_one_out_m))
                          .arg(summary.used)
                          .arg(lengthText(summary.rms_residual_m.value_or(0.0)))});
  }
  QStringList bad;
  for (const auto& [id, judgement] : session.judgements())
    if (judgement.judged == AnchorClass::kBad) bad += QString::number(id);
  if (!bad.isEmpty())
    checks.push_back(
        {Verdict::kWarning, Exports::tr("These anchors fit badly: %1").arg(bad.join(QStringLiteral(", ")))});
  const std::size_t folded = result->projector.foldedTileCount();
  if (folded > 0) {
    checks.push_back({Verdict::kWarning,
                      Exports::tr("The mesh folds over itself in %1 places: no answer is given there").arg(folded)});
  } else {
    checks.push_back({Verdict::kGood, Exports::tr("The mesh does not fold")});
  }
  for (const QString& finding : findings) checks.push_back({Verdict::kWarning, finding});
  if (session.rasters().isImageChanged(Side::kBlueprint))
    checks.push_back({Verdict::kWarning, Exports::tr("The blueprint is not the image this project was made with")});
  if (session.rasters().isImageChanged(Side::kSlam))
    checks.push_back({Verdict::kWarning, Exports::tr("The SLAM map is not the image this project was made with")});
  if (!result->solution.converged)
    checks.push_back({Verdict::kWarning, Exports::tr("The optimisation stopped before it had converged")});
  if (session.document().pending())
    checks.push_back(
        {Verdict::kWarning, Exports::tr("One half anchor is still waiting for its counterpart and is left out")});
  for (const std::string& warning : result->solution.warnings)
    checks.push_back({Verdict::kWarning, translatedSentence(warning)});
  if (session.document().isModified())
    checks.push_back({Verdict::kNote, Exports::tr("The project has changes that are not saved")});
  return checks;
}

Exports::Exports(Session& session, MessageBar& messages, QWidget& window)
    : QObject(&window), session_(session), messages_(messages), window_(window) {}

void Exports::showError(const QString& id, const Error& error) {
  messages_.show({id, Severity::kError, toSentence(error), {}, 0});
}

QString Exports::suggestion(const QString& extension) const {
  ProjectDocument& document = session_.document();
  const QString folder = document.path().empty() ? QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)
                                                 : toQString(document.path().parent_path());
  const QString stem = document.path().empty() ? QStringLiteral("site") : toQString(document.path().stem());
  const QString map =
      document.project().slam_maps.size() > 1 ? QLatin1Char('-') + toQString(document.currentMapName()) : QString();
  return folder + QLatin1Char('/') + stem + map + extension;
}

Result<AnchorImport> Exports::readAnchorFile(const QString& path, QString& how) const {
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly) || !looksLikeQgisPoints(toStd(QString::fromUtf8(file.read(4096)))))
    return readAnchors(toPath(path));
  const std::optional<MapFrame>& blueprint = session_.rasters().frame(Side::kBlueprint);
  const std::optional<MapFrame>& slam = session_.rasters().frame(Side::kSlam);
  if (!blueprint || !slam)
    return fail(ErrorCode::kDegenerate, "Points of QGIS are pixels: load both images first", toStd(path));
  Result<QgisImport> read = readQgisPoints(toPath(path), *blueprint, *slam);
  if (!read) return failAs(read);
  how = QStringLiteral(", ") + (read->reading.slam_is_source ? tr("read as the SLAM map bent onto the blueprint")
                                                             : tr("read as the blueprint bent onto the SLAM map"));
  return std::move(read->import);
}

bool Exports::importAnchors(const QString& path) {
  const QString id = QStringLiteral("import");
  if (!session_.document().currentMap()) {
    messages_.show({id, Severity::kWarning, tr("Choose a SLAM map first: anchors belong to one"), {}, 8000});
    return false;
  }
  if (!session_.document().mayEditAnchors()) return false;
  QString how;
  Result<AnchorImport> read = readAnchorFile(path, how);
  if (!read) {
    showError(id, read.error());
    return false;
  }
  const std::size_t count = read->anchors.size();
  edit::addAnchors(session_.document(), std::move(read->anchors), tr("import %n anchor(s)", nullptr, int(count)));
  session_.selection().clear();  // dozens of selected anchors would hide the maps
  QString text = tr("%n anchor(s) imported", nullptr, int(count)) + how;
  if (!read->rejected.empty()) {
    QStringList lines;
    for (const RejectedLine& line : read->rejected)
      lines += tr("line %1: %2").arg(line.line).arg(translatedSentence(line.reason));
    constexpr int kListed = 4;
    text += QStringLiteral(". ") + tr("Left out: %1").arg(lines.mid(0, kListed).join(QStringLiteral("; ")));
    if (lines.size() > kListed) text += tr(" and %n more", nullptr, int(lines.size()) - kListed);
  }
  messages_.show(
      {id, read->rejected.empty() ? Severity::kNote : Severity::kWarning, text, {}, read->rejected.empty() ? 5000 : 0});
  return true;
}

bool Exports::exportAnchors(const QString& path) {
  const QString id = QStringLiteral("export-anchors");
  if (const Result<void> written = writeAnchorsCsv(toPath(path), session_.document().anchors()); !written) {
    showError(id, written.error());
    return false;
  }
  messages_.show({id, Severity::kNote, tr("Anchors written to %1").arg(path), {}, 5000});
  return true;
}

ProjectorOptions Exports::projectorOptions(const QString& overridden) const {
  ProjectDocument& document = session_.document();
  const ProjectSlamMap& map = *document.currentMap();
  ProjectorOptions options;
  options.blueprint = frameInfo("blueprint", session_.rasters(), Side::kBlueprint);
  options.slam = frameInfo(map.name, session_.rasters(), Side::kSlam);
  options.creator = "cad2slam " + toStd(QCoreApplication::applicationVersion());
  options.created = toStd(QDateTime::currentDateTimeUtc().toString(Qt::ISODate));
  options.project = document.path().filename().string();
  options.note = toStd(overridden);
  return options;
}

template <class Outcome>
std::optional<Outcome> Exports::inWorker(const QString& label, LateCancel late,
                                         std::function<Outcome(const IsStopped&)> work) {
  QFutureWatcher<Outcome> watcher;
  QEventLoop until_done;
  connect(&watcher, &QFutureWatcherBase::finished, &until_done, &QEventLoop::quit);
  QProgressDialog progress(label, tr("Cancel"), 0, 0, &window_);
  progress.setWindowModality(Qt::WindowModal);
  // The dialog's own timer starts with the first step, which there is none of here, and waits four seconds. What is
  // edited before it comes up does no harm: the request holds everything that is exported.
  constexpr int kUsualWait_ms = 500;
  QTimer::singleShot(kUsualWait_ms, &progress, [&progress] {
    if (!progress.wasCanceled()) progress.show();
  });
  progress_ = &progress;
  const auto forget = qScopeGuard([this] { progress_ = nullptr; });
  window_.installEventFilter(this);  // see there
  connect(&progress, &QProgressDialog::canceled, &watcher, [&watcher] { watcher.cancel(); });
  // Not the future's own result, which a cancel drops even where the work is done by then.
  std::optional<Outcome> outcome;
  Lane lane;
  watcher.setFuture(lane.run<Outcome>([&work, &outcome](QPromise<Outcome>& promise) {
    outcome = guarded([&]() -> Outcome { return work([&promise] { return promise.isCanceled(); }); });
  }));
  until_done.exec();
  window_.removeEventFilter(this);
  if (!watcher.isFinished()) watcher.cancel();  // the program ends
  lane.waitForDone();
  return late == LateCancel::kDropsOutcome && watcher.isCanceled() ? std::nullopt : outcome;
}

Result<SolveResultPtr> Exports::solveAfresh(const SolveRequest& request) {
  const auto solved = inWorker<Result<SolveResultPtr>>(
      tr("Solving the alignment from nothing…"), LateCancel::kDropsOutcome, [&request](const IsStopped& is_stopped) {
        return SolveWorker().solveAside(request, [&is_stopped](const IterationReport&) {
          return is_stopped() ? NextStep::kStop : NextStep::kContinue;
        });
      });
  return solved ? *solved : fail(ErrorCode::kCancelled, "The export was cancelled, nothing was written");
}

Result<void> Exports::writeMap(const QString& yaml, const SolveRequest& request, const Projector& projector) {
  const auto written = inWorker<Result<void>>(
      tr("Drawing the blueprint as a map…"), LateCancel::kKeepsOutcome, [&](const IsStopped& is_stopped) {
        return writeBlueprintMap(toPath(yaml), projector, *request.blueprint, *request.slam_frame, is_stopped);
      });
  return written ? *written : fail(ErrorCode::kCancelled, "Drawing the map was cancelled, it is not written");
}

bool Exports::eventFilter(QObject* watched, QEvent* event) {
  if (watched != &window_ || event->type() != QEvent::Close || !progress_) return QObject::eventFilter(watched, event);
  // Closing would drop the export unseen: it can be waited for or cancelled in the dialog.
  progress_->show();
  event->ignore();
  return true;
}

bool Exports::exportProjector(const QString& path, const QString& overridden, const QString& map_yaml) {
  const QString id = QStringLiteral("export-projector");
  if (exporting_) {  // the last one is still solving
    if (progress_) progress_->show();
    return false;
  }
  if (!session_.isReady() || !session_.alignment().isCurrent()) {
    showError(id, {ErrorCode::kDegenerate, "There is no up-to-date alignment to export", {}});
    return false;
  }
  exporting_ = true;
  const auto over = qScopeGuard([this] { exporting_ = false; });
  const ProjectorOptions options = projectorOptions(overridden);
  const SolveRequest request = session_.alignment().currentRequest();
  const Result<SolveResultPtr> solved = solveAfresh(request);
  if (!solved) {
    showError(id, solved.error());
    return false;
  }
  const SolveResult& result = **solved;
  const Result<ProjectorData> data = makeProjectorData(*result.mesh, result.solution, result.anchors, options);
  if (!data) {
    showError(id, data.error());
    return false;
  }
  if (const Result<void> written = writeProjectorFile(toPath(path), *data); !written) {
    showError(id, written.error());
    return false;
  }
  const Result<double> difference = readBackDifference(toPath(path), result.projector, *result.mesh);
  if (!difference) {
    showError(id, difference.error());
    return false;
  }
  if (*difference > kReadBackTolerance) {
    showError(id, {ErrorCode::kInternal, "The file reads back with other values: do not use it", toStd(path)});
    return false;
  }
  QString text =
      tr("Projector written to %1, read again and compared at %2 places").arg(path).arg(result.mesh->nodeCount());
  if (!map_yaml.isEmpty()) {
    if (const Result<void> written = writeMap(map_yaml, request, result.projector); !written) {
      messages_.show({id, Severity::kError, text + QStringLiteral(". ") + toSentence(written.error()), {}, 0});
      return false;
    }
    text += QStringLiteral(". ") + tr("The blueprint as a map is in %1").arg(QFileInfo(map_yaml).fileName());
  }
  messages_.show({id, Severity::kNote, text, {}, 10'000});
  return true;
}

bool Exports::inspectProjector(const QString& path) {
  const QString id = QStringLiteral("inspect");
  const Result<ProjectorData> data = readProjectorFile(toPath(path));
  if (!data) {
    showError(id, data.error());
    return false;
  }
  const ProjectorInfo& info = data->info;
  const auto isSame = [this](const FrameInfo& frame, Side side) -> std::optional<bool> {
    const std::string& now = session_.rasters().imageHash(side);
    if (frame.image_sha256.empty() || now.empty()) return std::nullopt;
    return frame.image_sha256 == now;
  };
  const std::optional<bool> same_blueprint = isSame(info.blueprint, Side::kBlueprint);
  const std::optional<bool> same_slam = isSame(info.slam, Side::kSlam);
  QStringList verdicts;
  if (same_blueprint == false) verdicts += tr("Its blueprint is not the image of this project");
  if (same_slam == false) verdicts += tr("Its SLAM map is not the one being edited");
  const bool other = !verdicts.isEmpty();
  if (!other)
    verdicts += same_blueprint && same_slam ? tr("It was made from the images that are shown here")
                                            : tr("Whether it fits the images of this project is not known");
  const auto hash = [](const FrameInfo& frame) {
    constexpr int kShown = 12;  // enough to compare by eye
    return frame.image_sha256.empty() ? tr("not known") : toQString(frame.image_sha256).left(kShown);
  };
  QStringList lines;
  lines += QFileInfo(path).fileName() + QStringLiteral(": ") + verdicts.join(QStringLiteral(". "));
  if (!info.note.empty()) lines += tr("Exported in spite of: %1").arg(toQString(info.note));
  lines += tr("To SLAM map \"%1\": %2 nodes, %3 anchors; from project %4, %5, by %6")
               .arg(toQString(info.slam.name), QString::number(data->node_slam.size()),
                    QString::number(data->anchors.size()),
                    info.project.empty() ? tr("(not saved)") : toQString(info.project), dateText(info.created),
                    toQString(info.creator));
  lines += tr("SHA-256 of the images: blueprint %1, SLAM map %2").arg(hash(info.blueprint), hash(info.slam));
  messages_.show({id, other ? Severity::kWarning : Severity::kNote, lines.join(QLatin1Char('\n')), {}, 0});
  return true;
}

void Exports::askImportAnchors() {
  const QString path = QFileDialog::getOpenFileName(&window_, tr("Import anchors"), suggestion(QString()),
                                                    tr("Anchors (*.csv *.txt *.data *.points);;All files (*)"));
  if (!path.isEmpty()) importAnchors(path);
}

void Exports::askExportAnchors() {
  finishTyping();
  const QString path = askSavePath(&window_, tr("Export anchors"), suggestion(QStringLiteral("-anchors.csv")),
                                   tr("Anchors (*.csv)"), QStringLiteral(".csv"));
  if (!path.isEmpty()) exportAnchors(path);
}

void Exports::askExportProjector() {
  finishTyping();
  const std::vector<ExportCheck> checks = exportChecks(session_, findings_ ? findings_() : QStringList());
  ExportDialog dialog(&window_, checks);
  const int answer = dialog.exec();
  if (answer == ExportDialog::kSolveAgain) session_.alignment().solveNow();
  if (answer != QDialog::Accepted) return;
  const QString path = askSavePath(&window_, tr("Export projector"), suggestion(QStringLiteral(".c2s")),
                                   tr("Projectors (*.c2s)"), QStringLiteral(".c2s"));
  if (path.isEmpty()) return;
  QString map_yaml;
  if (dialog.isMapWanted()) {
    map_yaml = blueprintMapBeside(path);
    const QString image = toQString(imageOfBlueprintMap(toPath(map_yaml)));
    if (!mayReplace(&window_, tr("Export projector"), {map_yaml, image})) return;
  }
  QStringList overridden;
  for (const ExportCheck& check : checks)
    if (check.verdict == Verdict::kWarning) overridden += check.sentence;
  exportProjector(path, overridden.join(QStringLiteral("; ")), map_yaml);
}

void Exports::askInspectProjector() {
  const QString path = QFileDialog::getOpenFileName(&window_, tr("Inspect a projector"), suggestion(QString()),
                                                    tr("Projectors (*.c2s);;All files (*)"));
  if (!path.isEmpty()) inspectProjector(path);
}

}  // namespace cad2slam
