// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/cheat_sheet.h"

#include "ui/main_window/actions.h"

#include <QDialogButtonBox>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace cad2slam {

CheatSheet::CheatSheet(QWidget* parent, const Actions& actions) : QDialog(parent) {
  setWindowTitle(tr("Keys and mouse"));
  resize(860, 680);
  const auto row = [](const QString& key, const QString& meaning) {
    return QStringLiteral("<tr><td style=\"padding: 1px 14px 1px 0\"><b>%1</b></td><td>%2</td></tr>")
        .arg(key.toHtmlEscaped(), meaning.toHtmlEscaped());
  };
  QString mouse;
  mouse += row(tr("Click"), tr("Place one half of an anchor; the click in the other view completes it"));
  mouse += row(tr("Enter"), tr("Take the predicted place for the other half"));
  mouse += row(tr("Esc, right click"), tr("Drop the half that waits; never closes the window"));
  mouse += row(tr("Drag an anchor"), tr("Move it; Esc while dragging puts it back"));
  mouse += row(tr("Drag elsewhere, middle button, Space + drag"), tr("Move the map"));
  mouse += row(tr("Wheel"), tr("Zoom at the cursor"));
  mouse += row(tr("Arrow keys"), tr("Nudge the selected anchor by 1 pixel; Shift 10, Ctrl 0.1"));
  mouse += row(tr("Tab"), tr("Nudge the other half"));
  mouse += row(tr("Ctrl + click"), tr("Select several anchors"));
  mouse += row(tr("Hold Z"), tr("Loupe under the cursor"));
  mouse += row(tr("Hold Alt"), tr("Suspend snapping"));
  mouse += row(tr("Hold B"), tr("Blink the preview"));
  mouse += row(tr("Space in the table"), tr("Use the anchor or not"));
  QString keys;
  for (const QAction* action : actions.all()) {
    if (action->shortcut().isEmpty()) continue;
    QStringList all;
    for (const QKeySequence& key : action->shortcuts()) all += key.toString(QKeySequence::NativeText);
    const QString tip = action->toolTip().section(QStringLiteral(" ("), 0, 0);
    keys += row(all.join(QStringLiteral(", ")), tip);
  }
  auto* page = new QTextBrowser(this);
  page->setHtml(QStringLiteral("<table width=\"100%\"><tr><td valign=\"top\" width=\"48%\"><h3>%1</h3><table>%2</table>"
                               "</td><td valign=\"top\"><h3>%3</h3><table>%4</table></td></tr></table>")
                    .arg(tr("In the views"), mouse, tr("Keys"), keys));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(page);
  layout->addWidget(buttons);
}

}  // namespace cad2slam
