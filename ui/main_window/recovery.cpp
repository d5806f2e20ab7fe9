// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/recovery.h"

#include "ui/convert.h"
#include "ui/panels/message_bar.h"

#include <QFileInfo>
#include <QLocale>

#include <utility>

namespace cad2slam {

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
    messages_.show({id,
                    Severity::kWarning,
                    tr("The program ended unexpectedly; %1 was last edited %2")
                        .arg(name, QLocale().toString(recoverable.last_edit, QLocale::ShortFormat)),
                    {{tr("Recover"),
                      [this, recoverable, id] {
                        if (!may_replace_()) return;
                        messages_.remove(id);
                        recover(recoverable);
                      }},
                     {tr("Discard"),
                      [this, recoverable, id] {
                        messages_.remove(id);
                        Autosave::discard(recoverable);
                      }}},
                    0});
  }
  return !found.empty();
}

void Recovery::recover(const Recoverable& recoverable) {
  session_.document().reset(recoverable.project, toPath(recoverable.project_path), true);
  // The edits are now in this run's journal; until they are on disk there, the old one stays.
  if (autosave_.flush()) Autosave::discard(recoverable);
}

}  // namespace cad2slam
