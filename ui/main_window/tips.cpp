// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/main_window/tips.h"

#include "ui/main_window/session.h"
#include "ui/panels/message_bar.h"

#include <QSettings>
#include <QStringList>

#include <utility>

namespace cad2slam {
namespace {

constexpr int kShown_ms = 15'000;

QString wantedKey() {
  return QStringLiteral("tips");
}
QString toldKey() {
  return QStringLiteral("tips_told");
}

}  // namespace

Tips::Tips(Session& session, MessageBar& messages, QObject* parent)
    : QObject(parent), session_(session), messages_(messages) {
  connect(&session_.document(), &ProjectDocument::changed, this, &Tips::onChanged);
}

void Tips::setWanted(bool wanted) {
  QSettings().setValue(wantedKey(), wanted);
}

void Tips::onChanged(const ChangeEvent& event) {
  if (event.added.size() != 1 || event.by_history || event.what.testFlag(Change::kEverything)) return;
  switch (session_.document().anchors().size()) {
    case 1:
      return tell("nudge", tr("Arrow keys move the selected anchor by one pixel; hold Z to see it four times larger"));
    case 3:
      return tell("preview", tr("O shows the next way to compare the maps; hold B to see one map alone"));
    case 5:
      return tell("worst", tr("N goes to the anchor with the largest error, and shows it in both views"));
    case 7:
      return tell("pose", tr("R shows a robot to drag: where it is in one map, and where in the other"));
    case 9:
      return tell("keys", tr("F1 shows all keys"));
    default:
      return;
  }
}

void Tips::tell(const char* key, const QString& text) {
  QSettings settings;
  if (!settings.value(wantedKey(), true).toBool()) return;
  QStringList told = settings.value(toldKey()).toStringList();
  if (told.contains(QLatin1String(key))) return;
  settings.setValue(toldKey(), told << QLatin1String(key));
  const QString id = QStringLiteral("tip");
  Message message{id, Severity::kNote, tr("Tip: %1").arg(text), {}, kShown_ms};
  message.cures.push_back({tr("No more tips"), [this, id] {
                             setWanted(false);
                             messages_.remove(id);
                           }});
  messages_.show(std::move(message));
}

}  // namespace cad2slam
