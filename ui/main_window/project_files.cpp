// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/project_files.h"

#include "cad2slam/io/project_file.h"
#include "cad2slam/io/sha256.h"
#include "ui/convert.h"
#include "ui/dialogs/save_path.h"
#include "ui/dialogs/scale_dialog.h"
#include "ui/document/project_commands.h"
#include "ui/engine_sentences.h"
#include "ui/main_window/tour.h"
#include "ui/main_window/typing.h"
#include "ui/panels/message_bar.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>

#include <utility>

namespace cad2slam {
namespace {

constexpr int kRecentProjects = 8;
constexpr int kRememberAfter_ms = 2000;

bool isProject(const QString& path) {
  return path.endsWith(QStringLiteral(".c2sproj"), Qt::CaseInsensitive);
}
bool isYaml(const QString& path) {
  return path.endsWith(QStringLiteral(".yaml"), Qt::CaseInsensitive) ||
         path.endsWith(QStringLiteral(".yml"), Qt::CaseInsensitive);
}
/// Without the images that one of the map YAMLs among them names: with it they are one map.
QStringList withoutNamedImages(const QStringList& paths) {
  QStringList named;
  for (const QString& path : paths) {
    if (!isYaml(path)) continue;
    if (const Result<MapYaml> read = readMapYaml(toPath(QFileInfo(path).absoluteFilePath())))
      named += QFileInfo(toQString(read->metadata.image)).canonicalFilePath();
  }
  QStringList rest;
  for (const QString& path : paths)
    if (isYaml(path) || !named.contains(QFileInfo(path).canonicalFilePath())) rest += path;
  return rest;
}
QString problemId(Side side, const QString& map) {
  return QStringLiteral("image-%1-%2").arg(side == Side::kBlueprint ? 0 : 1).arg(map);
}

}  // namespace

ProjectFiles::ProjectFiles(Session& session, MessageBar& messages, QWidget& window, QMenu& recent_menu)
    : QObject(&window), session_(session), messages_(messages), window_(window), recent_menu_(recent_menu) {
  connect(&session_.rasters(), &RasterStore::problem, this, &ProjectFiles::showProblem);
  connect(&session_.rasters(), &RasterStore::problemsOver, this,
          [this](Side side) { messages_.showGroup(problemId(side, QString()), {}); });
  connect(&session_.rasters(), &RasterStore::warned, this, [this](const QString& sentence) {
    messages_.show({QStringLiteral("image-note-%1").arg(qHash(sentence)), Severity::kNote, sentence, {}, 0});
  });
  connect(&session_.document(), &ProjectDocument::changed, this, [this](const ChangeEvent& event) {
    if (event.what & Change::kEverything) lookAtFile();
  });
  connect(&recent_menu_, &QMenu::aboutToShow, this, &ProjectFiles::fillRecentMenu);
  remember_timer_.setSingleShot(true);
  connect(&remember_timer_, &QTimer::timeout, this, &ProjectFiles::writeRemembered);
}

ProjectFiles::~ProjectFiles() {
  writeRemembered();
}

QString ProjectFiles::folder() const {
  if (!session_.document().path().empty()) return toQString(session_.document().path().parent_path());
  if (session_.document().hasBlueprint())
    return toQString(session_.document().project().blueprint.metadata.image.parent_path());
  const QString last = QSettings().value(QStringLiteral("last_folder")).toString();
  return last.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation) : last;
}

void ProjectFiles::showError(const QString& id, const Error& error,
                             std::vector<std::pair<QString, std::function<void()>>> cures) {
  Message message{id, Severity::kError, toSentence(error), {}, 0};
  for (auto& [label, run] : cures) message.cures.push_back({label, std::move(run)});
  messages_.show(std::move(message));
}

bool ProjectFiles::openProject(const QString& path) {
  Result<Project> project = readProject(toPath(path));
  if (!project) {
    showError(QStringLiteral("open"), project.error());
    return false;
  }
  messages_.remove(QStringLiteral("open"));
  messages_.showGroup(QStringLiteral("image-"), {});
  session_.document().reset(*std::move(project), toPath(QFileInfo(path).absoluteFilePath()));
  remember(path);
  if (session_.document().pending())
    messages_.show({QStringLiteral("pending"),
                    Severity::kNote,
                    tr("One anchor has only one half: click its counterpart, or press Esc to drop it"),
                    {},
                    10'000});
  emit savedOrOpened();
  return true;
}

bool ProjectFiles::saveProjectTo(const QString& path) {
  if (before_save_) before_save_();
  const std::filesystem::path target = toPath(QFileInfo(path).absoluteFilePath());
  ProjectDocument& document = session_.document();
  Project project = document.projectToSave();
  project.name = toStd(QFileInfo(path).completeBaseName());
  if (const Result<void> written = writeProject(target, project); !written) {
    showError(QStringLiteral("save"), written.error(), {{tr("Save elsewhere..."), [this] { askSaveAs(); }}});
    return false;
  }
  messages_.remove(QStringLiteral("save"));
  document.markSaved(target);
  lookAtFile();
  remember(path);
  const bool half = document.pending().has_value();
  messages_.show({QStringLiteral("saved"),
                  Severity::kNote,
                  half ? tr("Saved, with one half of an anchor still waiting for its counterpart") : tr("Saved"),
                  {},
                  half ? 6000 : 2500});
  emit savedOrOpened();
  return true;
}

bool ProjectFiles::setImage(Side side, const QString& path, std::optional<double> resolution_m_per_px) {
  const QString id = QStringLiteral("choose-image");
  MapMetadata metadata;
  std::vector<std::string> warnings;
  if (isYaml(path)) {
    Result<MapYaml> read = readMapYaml(toPath(QFileInfo(path).absoluteFilePath()));
    if (!read) {
      showError(id, read.error());
      return false;
    }
    metadata = std::move(read->metadata);
    warnings = std::move(read->warnings);
  } else {
    metadata.image = toPath(QFileInfo(path).absoluteFilePath());
  }
  metadata.resolution_m_per_px = resolution_m_per_px.value_or(metadata.resolution_m_per_px);
  const Result<MapFrame> frame = readMapFrame(metadata);
  if (!frame) {
    showError(id, frame.error());
    return false;
  }
  if (!isYaml(path) && !resolution_m_per_px) {
    const std::optional<double> scale = ScaleDialog::ask(&window_, metadata.image, side);
    if (!scale) return false;
    metadata.resolution_m_per_px = *scale;
  }
  messages_.remove(id);
  QSettings().setValue(QStringLiteral("last_folder"), QFileInfo(path).absolutePath());
  ProjectRaster raster;
  raster.metadata = std::move(metadata);
  if (side == Side::kBlueprint) {
    edit::setBlueprint(session_.document(), raster);
  } else {
    const QFileInfo file(path);
    // Every site calls its files slam.yaml or map.pgm; the folder tells more than that.
    QString name = file.completeBaseName();
    if (name == QStringLiteral("slam") || name == QStringLiteral("map")) name = file.absoluteDir().dirName();
    edit::addSlamMap(session_.document(), toStd(name), raster);
  }
  for (const std::string& warning : warnings) {
    const QString sentence = QStringLiteral("%1: %2").arg(QFileInfo(path).fileName(), translatedSentence(warning));
    messages_.show({QStringLiteral("yaml-note-%1").arg(qHash(sentence)), Severity::kWarning, sentence, {}, 0});
  }
  return true;
}

void ProjectFiles::askNew() {
  if (!mayClose()) return;
  messages_.showGroup(QString(), {});
  session_.document().reset(Project{}, {});
  emit savedOrOpened();
}

void ProjectFiles::askOpen() {
  if (!mayClose()) return;
  const QString path =
      QFileDialog::getOpenFileName(&window_, tr("Open project"), folder(), tr("Projects (*.c2sproj);;All files (*)"));
  if (!path.isEmpty()) openProject(path);
}

void ProjectFiles::lookAtFile() {
  const std::filesystem::path& path = session_.document().path();
  file_sha256_ = path.empty() ? std::string() : sha256HexOfFile(path).value_or(std::string());
}

bool ProjectFiles::isFileReplaced() const {
  const Result<std::string> now = sha256HexOfFile(session_.document().path());
  return now && *now != file_sha256_;
}

bool ProjectFiles::askSave() {
  finishTyping();
  const QString path = toQString(session_.document().path());
  if (path.isEmpty()) return askSaveAs();
  if (!isFileReplaced()) return saveProjectTo(path);
  QMessageBox box(QMessageBox::Warning, tr("Project changed on disk"),
                  tr("%1 was saved by another program after it was opened here.").arg(QFileInfo(path).fileName()),
                  QMessageBox::Cancel, &window_);
  box.setObjectName(QStringLiteral("replacedQuestion"));
  box.setTextFormat(Qt::PlainText);
  box.setInformativeText(tr("To replace it loses what was done there."));
  const QPushButton* replace = box.addButton(tr("Replace"), QMessageBox::DestructiveRole);
  QPushButton* elsewhere = box.addButton(tr("Save elsewhere..."), QMessageBox::AcceptRole);
  box.setDefaultButton(elsewhere);
  box.exec();
  if (box.clickedButton() == elsewhere) return askSaveAs();
  return box.clickedButton() == replace && saveProjectTo(path);
}

QString ProjectFiles::folderToSaveIn(const QString& images, const std::optional<QString>& sample) {
  const QFileInfo folder(images);
  const bool installed = sample && QFileInfo(*sample).canonicalFilePath() == folder.canonicalFilePath();
  return installed || !folder.isWritable() ? QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)
                                           : images;
}

bool ProjectFiles::askSaveAs() {
  finishTyping();
  const std::filesystem::path& now = session_.document().path();
  const QString proposal =
      now.empty() ? folderToSaveIn(folder(), Tour::sampleFolder()) + QStringLiteral("/site.c2sproj") : toQString(now);
  const QString path =
      askSavePath(&window_, tr("Save project"), proposal, tr("Projects (*.c2sproj)"), QStringLiteral(".c2sproj"));
  return !path.isEmpty() && saveProjectTo(path);
}

void ProjectFiles::askImage(Side side) {
  const QString path = QFileDialog::getOpenFileName(
      &window_, side == Side::kBlueprint ? tr("Choose the blueprint") : tr("Add a SLAM map"), folder(),
      tr("Maps and images (*.yaml *.yml *.png *.pgm *.jpg *.jpeg *.tif *.tiff *.bmp);;All files (*)"));
  if (!path.isEmpty()) setImage(side, path);
}

bool ProjectFiles::mayClose() {
  finishTyping();
  if (!session_.document().isModified()) return true;
  QMessageBox box(QMessageBox::Question, tr("Unsaved changes"), tr("The project has changes that are not saved."),
                  QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, &window_);
  box.setObjectName(QStringLiteral("closeQuestion"));
  box.setInformativeText(tr("Save them before it is closed?"));
  box.setDefaultButton(QMessageBox::Save);
  switch (box.exec()) {
    case QMessageBox::Save:
      return askSave();
    case QMessageBox::Discard:
      return true;
    default:
      return false;
  }
}

void ProjectFiles::takeDropped(Side side, const QStringList& paths) {
  Side next = side;
  for (const QString& path : withoutNamedImages(paths)) {
    if (isProject(path)) {
      if (mayClose()) openProject(path);
      return;
    }
    setImage(next, path);
    next = Side::kSlam;  // two files dropped together on the left: the plan and the robot's map
    if (side == Side::kSlam && !session_.document().hasBlueprint()) next = Side::kBlueprint;
  }
}

/// Not at once: settings wait for the disk, and a project that has just been opened has its images to show.
void ProjectFiles::remember(const QString& path) {
  to_remember_.append(QFileInfo(path).absoluteFilePath());
  remember_timer_.start(kRememberAfter_ms);
}

void ProjectFiles::writeRemembered() {
  if (to_remember_.isEmpty()) return;
  QSettings settings;
  QStringList recent = settings.value(QStringLiteral("recent_projects")).toStringList();
  for (const QString& path : std::as_const(to_remember_)) {
    recent.removeAll(path);
    recent.prepend(path);
  }
  to_remember_.clear();
  settings.setValue(QStringLiteral("recent_projects"), QStringList(recent.mid(0, kRecentProjects)));
}

void ProjectFiles::fillRecentMenu() {
  writeRemembered();
  recent_menu_.clear();
  for (const QString& path : QSettings().value(QStringLiteral("recent_projects")).toStringList()) {
    QAction* action = recent_menu_.addAction(path, this, [this, path] {
      if (mayClose()) openProject(path);
    });
    action->setEnabled(QFileInfo::exists(path));
  }
  if (recent_menu_.isEmpty()) recent_menu_.addAction(tr("None yet"))->setEnabled(false);
}

void ProjectFiles::showProblem(const RasterProblem& problem) {
  Message message;
  message.id = problemId(problem.side, toQString(problem.map));
  message.severity = problem.kind == RasterProblem::Kind::kChanged ? Severity::kWarning : Severity::kError;
  message.text = problem.sentence;
  message.cures.push_back({tr("Find it..."), [this, problem] {
                             const QString path = QFileDialog::getOpenFileName(
                                 &window_, tr("Where is %1?").arg(toQString(problem.image.filename())), folder());
                             if (!path.isEmpty()) relocate(problem, path);
                           }});
  if (!problem.found_sha256.empty())
    message.cures.push_back({tr("Use this one"), [this, problem] { acceptChanged(problem); }});
  messages_.show(std::move(message));
}

/// Where the project still has the image that the problem is with.
const ProjectRaster* ProjectFiles::rasterOf(const RasterProblem& problem) const {
  const Project& project = session_.document().project();
  const ProjectRaster* raster = problem.side == Side::kBlueprint ? &project.blueprint : nullptr;
  for (const ProjectSlamMap& map : project.slam_maps)
    if (problem.side == Side::kSlam && map.name == problem.map) raster = &map.raster;
  return raster && raster->metadata.image == problem.image ? raster : nullptr;
}

void ProjectFiles::putRaster(const RasterProblem& problem, const ProjectRaster& raster) {
  messages_.remove(problemId(problem.side, toQString(problem.map)));
  problem.side == Side::kBlueprint ? edit::setBlueprint(session_.document(), raster)
                                   : edit::setSlamRaster(session_.document(), problem.map, raster);
}

void ProjectFiles::acceptChanged(const RasterProblem& problem) {
  const ProjectRaster* before = rasterOf(problem);
  if (!before) return;
  ProjectRaster raster = *before;
  raster.image_bytes = problem.found_bytes;
  raster.image_sha256 = problem.found_sha256;
  putRaster(problem, raster);
}

bool ProjectFiles::relocate(const RasterProblem& problem, const QString& path) {
  const ProjectRaster* before = rasterOf(problem);
  if (!before) return false;
  ProjectRaster raster = *before;
  const std::filesystem::path file = toPath(QFileInfo(path).absoluteFilePath());
  if (isYaml(path)) {
    const Result<MapYaml> read = readMapYaml(file);
    if (!read) {
      showError(QStringLiteral("relocate"), read.error());
      return false;
    }
    raster.metadata.image = read->metadata.image;
  } else {
    raster.metadata.image = file;
  }
  messages_.remove(QStringLiteral("relocate"));
  putRaster(problem, raster);
  return true;
}

}  // namespace cad2slam
