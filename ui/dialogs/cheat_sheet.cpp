// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/cheat_sheet.h"

#include "ui/main_window/actions.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QScreen>
#include <QScrollArea>
#include <QVBoxLayout>

namespace cad2slam {
namespace {

/// The name in the menu, without mnemonic and dots.
QString plainText(const QAction& action) {
  QString text = action.text().section(QStringLiteral(": "), 0, 0);  // of undo and redo, without the step
  text.remove(QLatin1Char('&'));
  while (text.endsWith(QLatin1Char('.'))) text.chop(1);
  return text;
}

QString column(const QString& heading, const QString& rows) {
  return QStringLiteral("<td style=\"padding-right: 22px\"><b>%1</b><table>%2</table></td>").arg(heading, rows);
}

}  // namespace

CheatSheet::CheatSheet(QWidget* parent, const Actions& actions) : QDialog(parent) {
  setWindowTitle(tr("Keys and mouse"));
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
  mouse += row(tr("Shift + wheel, drag the compass"), tr("Turn the map; a click on the compass turns it back"));
  mouse += row(tr("Arrow keys"), tr("Nudge the selected anchor by 1 pixel; Shift 10, Ctrl 0.1"));
  mouse += row(tr("Tab"), tr("Nudge the other half"));
  mouse += row(tr("Ctrl + click"), tr("Select several anchors"));
  mouse += row(tr("Hold Z"), tr("Loupe under the cursor"));
  mouse += row(tr("Hold Alt"), tr("Suspend snapping"));
  mouse += row(tr("Hold B"), tr("Blink the preview"));
  mouse += row(tr("Space in the table"), tr("Use the anchor or not"));
  QStringList keys;
  for (const QAction* action : actions.all()) {
    if (action->shortcut().isEmpty()) continue;
    QStringList all;
    for (const QKeySequence& key : action->shortcuts()) all += key.toString(QKeySequence::NativeText);
    keys += row(all.join(QStringLiteral(", ")), plainText(*action));
  }
  // Two columns of keys, so that a small screen holds the page.
  const auto half = (keys.size() + 1) / 2;
  auto* page =
      new QLabel(QStringLiteral("<table><tr>%1%2%3</tr></table>")
                     .arg(column(tr("In the views"), mouse), column(tr("Keys"), keys.mid(0, half).join(QString())),
                          column(QStringLiteral("&nbsp;"), keys.mid(half).join(QString()))),
                 this);
  page->setTextFormat(Qt::RichText);
  page->setWordWrap(true);
  page->setMargin(6);
  page->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  page->setAccessibleName(windowTitle());
  page->setMinimumWidth(fontMetrics().averageCharWidth() * 175);
  auto* area = new QScrollArea(this);
  area->setWidget(page);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(area);
  layout->addWidget(buttons);
  const QSize frame(layout->contentsMargins().left() + layout->contentsMargins().right() + 2,
                    layout->contentsMargins().top() + layout->contentsMargins().bottom() + layout->spacing() +
                        buttons->sizeHint().height() + 2);
  const int width = page->minimumWidth();
  const QSize whole = QSize(width, page->heightForWidth(width) + fontMetrics().height()) + frame;
  // Never larger than the screen; it scrolls there.
  resize(screen() ? whole.boundedTo(screen()->availableSize() * 0.95) : whole);
}

}  // namespace cad2slam
