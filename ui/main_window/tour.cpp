// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/tour.h"

#include "cad2slam/io/map_yaml.h"
#include "cad2slam/io/project_file.h"
#include "ui/convert.h"
#include "ui/main_window/main_window.h"
#include "ui/main_window/project_files.h"
#include "ui/panels/message_bar.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <utility>

namespace cad2slam {
namespace {

constexpr int kSteps = 6;

/// The sample as a project, or nothing where it cannot be read. Of the two SLAM maps the one that lies as the plan
/// does: the other is turned by half a turn, and who takes its corners for the same-looking ones aligns it wrongly.
std::optional<Project> sampleProject(const QString& folder) {
  const Result<MapYaml> blueprint = readMapYaml(toPath(folder + QStringLiteral("/blueprint.yaml")));
  const Result<MapYaml> slam = readMapYaml(toPath(folder + QStringLiteral("/slam_2.yaml")));
  if (!blueprint || !slam) return std::nullopt;
  Project project;
  project.blueprint.metadata = blueprint->metadata;
  ProjectSlamMap map;
  map.name = "slam_2";
  map.raster.metadata = slam->metadata;
  project.slam_maps.push_back(std::move(map));
  return project;
}

}  // namespace

Tour::Tour(MainWindow& window, std::optional<QString> sample)
    : QObject(&window), window_(window), sample_(std::move(sample)) {}

std::optional<QString> Tour::sampleFolder() {
  const QString program = QCoreApplication::applicationDirPath();
  for (const QString& place : {QStringLiteral("/../share/cad2slam/sample_maps/office"),
                               QStringLiteral("/../../../sample_maps/office"), QStringLiteral("/sample_maps/office")})
    if (const QFileInfo folder(program + place);
        QFileInfo::exists(folder.absoluteFilePath() + QStringLiteral("/blueprint.yaml")))
      return folder.canonicalFilePath();
  return std::nullopt;
}

void Tour::start() {
  std::optional<Project> project = sample_ ? sampleProject(*sample_) : std::nullopt;
  if (!project) {
    window_.messages().show({QStringLiteral("tour"),
                             Severity::kNote,
                             tr("The sample building is not installed; drop your own two maps into the views"),
                             {},
                             8000});
    return deleteLater();
  }
  if (!window_.files().mayClose()) return deleteLater();
  window_.session().document().reset(*std::move(project), {});  // no edit: nothing to save, nothing to undo
  connect(&window_.session().document(), &ProjectDocument::changed, this, [this](const ChangeEvent& event) {
    if (event.what & Change::kEverything) return finish();
    refresh();
  });
  connect(&window_.session().alignment(), &Alignment::statusChanged, this, &Tour::refresh);
  refresh();
}

int Tour::stepOf() const {
  ProjectDocument& document = window_.session().document();
  const std::size_t count = document.anchors().size();
  if (count == 0) return document.pending() ? 1 : 0;
  if (count == 1) return 2;
  if (count < 4) return 3;
  return looked_ ? 5 : 4;
}

QString Tour::textOfStep(int step) const {
  switch (step) {
    case 0:
      return tr(
          "On the left the plan of an office, on the right what a robot has mapped. Click a corner of a room in "
          "the plan; the wheel zooms, dragging moves");
    case 1:
      return tr("Now find the same corner on the right and click it. Holding Z magnifies");
    case 2:
      return tr("That is an anchor. Make a second one far away from it");
    case 3:
      return tr(
          "From now on the other half is predicted: after the first click a blue mark shows it. Enter takes it, "
          "a click elsewhere corrects it. Make four anchors");
    case 4:
      return tr(
          "From four anchors on each is checked by the others: see \"Without it\" in the table. The preview shows "
          "both maps together, O changes how");
    default:
      return tr("More anchors where the preview is off make it better; Ctrl+E writes the file for the robots");
  }
}

void Tour::refresh() {
  const int step = stepOf();
  if (step == step_) return;
  step_ = step;
  Message message{QStringLiteral("tour"),
                  Severity::kNote,
                  tr("Step %1 of %2. %3").arg(step + 1).arg(kSteps).arg(textOfStep(step)),
                  {},
                  0};
  if (step == 4)
    message.cures.push_back({tr("Go on"), [this] {
                               looked_ = true;
                               refresh();
                             }});
  message.pinned = true;  // warnings come while one learns
  message.cures.push_back({step == kSteps - 1 ? tr("Done") : tr("End the tour"), [this] { finish(); }});
  window_.messages().show(std::move(message));
}

void Tour::finish() {
  window_.messages().remove(QStringLiteral("tour"));
  disconnect();
  window_.session().document().disconnect(this);
  window_.session().alignment().disconnect(this);
  deleteLater();
}

}  // namespace cad2slam
