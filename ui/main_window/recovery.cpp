// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/recovery.h"

#include "ui/convert.h"
#include "ui/panels/message_bar.h"

#include <QFileInfo>
#include <QLocale>
#include <QStringList>

#include <utility>
#include <vector>

namespace cad2slam {
namespace {

/// By what one knows a project that has no name; empty for an empty one.
QString contentOf(const Project& project) {
  QStringList images;
  if (!project.blueprint.metadata.image.empty()) images += toQString(project.blueprint.metadata.image.filename());
  std::size_t anchors = 0;
  for (const ProjectSlamMap& map : project.slam_maps) {
    images += toQString(map.raster.metadata.image.filename());
    anchors += map.anchors.size();
  }
  if (images.isEmpty()) return {};
  constexpr qsizetype kListed = 3;
  const QString more = images.size() > kListed ? QStringLiteral(", ...") : QString();
  return Recovery::tr("Images: %1; anchors: %2")
      .arg(images.mid(0, kListed).join(QStringLiteral(", ")) + more, QString::number(anchors));
}

}  // namespace

Recovery::Recovery(Session& session, MessageBar& messages, std::function<bool()> may_replace, QObject* parent)
    : QObject(parent),
      session_(session),
      messages_(messages),
      may_replace_(std::move(may_replace)),
      autosave_(session.document(), Autosave::defaultRoot()) {
  connect(&autosave_, &Autosave::failed, this, [this](const QString& sentence) {
    messages_.show(
        {QStringLiteral("autosave"), Severity::kWarning, tr("Autosave does not work: %1").arg(sentence), {}, 0});
  });
  connect(&autosave_, &Autosave::written, this, [this] { messages_.remove(QStringLiteral("autosave")); });
}

bool Recovery::offer() {
  const std::vector<Recoverable> found = Autosave::findRecoverable(Autosave::defaultRoot());
  for (const Recoverable& recoverable : found) {
    const QString id = QStringLiteral("recovery-") + QFileInfo(recoverable.folder).fileName();
    const QString name = recoverable.project_path.isEmpty() ? tr("a project that was never saved")
                                                            : QFileInfo(recoverable.project_path).fileName();
    const auto when = [](const QDateTime& time) { return QLocale().toString(time, QLocale::ShortFormat); };
    QString text = tr("The program ended unexpectedly; %1 was last edited %2").arg(name, when(recoverable.last_edit));
    if (!recoverable.unreadable.isEmpty()) {
      text = tr("What a program that ended unexpectedly has left of %1 cannot be read: %2")
                 .arg(name, recoverable.unreadable);
    } else if (recoverable.isOvertaken()) {
      text += QStringLiteral(". ") + tr("It was saved again %1, so what is recovered will be a project of its own")
                                         .arg(when(QFileInfo(recoverable.project_path).lastModified()));
    }
    if (const QString content = contentOf(recoverable.project); recoverable.unreadable.isEmpty() && !content.isEmpty())
      text += QStringLiteral(". ") + content;
    std::vector<Cure> cures;
    if (recoverable.unreadable.isEmpty())
      cures.push_back({tr("Recover"), [this, recoverable, id] {
                         if (!may_replace_()) return;
                         messages_.remove(id);
                         recover(recoverable);
                       }});
    cures.push_back({tr("Discard"), [this, recoverable, id] {
                       messages_.remove(id);
                       Autosave::discard(recoverable);
                     }});
    messages_.show({id, Severity::kWarning, text, std::move(cures), 0});
  }
  return !found.empty();
}

void Recovery::recover(const Recoverable& recoverable) {
  // Ctrl+S must not put it over what was saved later.
  const QString path = recoverable.isOvertaken() ? QString() : recoverable.project_path;
  session_.document().reset(recoverable.project, toPath(path), true);
  // The edits are now in this run's journal; until they are on disk there, the old one stays.
  if (autosave_.flush()) Autosave::discard(recoverable);
}

}  // namespace cad2slam
