// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/coordinate_delegate.h"

#include "ui/models/anchor_table_model.h"
#include "ui/models/number_text.h"
#include "ui/panels/marker_class.h"
#include "ui/views/marker_painter.h"

#include <QLineEdit>
#include <QToolTip>

namespace cad2slam {

QValidator::State NumberValidator::validate(QString& text, int&) const {
  return parseNumber(text) ? Acceptable : Intermediate;  // never Invalid: typing is not blocked, leaving is
}

void CellDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const {
  const auto* line = qobject_cast<const QLineEdit*>(editor);
  // The view also calls this whenever results of a solve change what the table shows.
  if (line && (line->isModified() || line->text() == index.data(Qt::EditRole).toString())) return;
  QStyledItemDelegate::setEditorData(editor, index);
}

void FlagDelegate::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const {
  CellDelegate::initStyleOption(option, index);
  const QVariant judged = index.data(AnchorTableModel::kClassRole);
  if (!judged.isValid()) return;
  const QColor color = colorOf(markerClass(static_cast<AnchorClass>(judged.toInt())));
  const bool on_light = option->palette.color(QPalette::Base).lightness() > 128;
  option->palette.setColor(QPalette::Text, on_light ? color.darker(145) : color.lighter(150));
}

QWidget* CoordinateDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&, const QModelIndex&) const {
  auto* editor = new QLineEdit(parent);
  editor->setFrame(false);
  editor->setAlignment(Qt::AlignRight);
  editor->setValidator(new NumberValidator(editor));
  connect(editor, &QLineEdit::textChanged, editor, [editor] {
    const bool good = editor->hasAcceptableInput();
    editor->setStyleSheet(good ? QString() : QStringLiteral("QLineEdit { color: white; background: #a00040; }"));
    if (good) {
      QToolTip::hideText();
    } else {
      QToolTip::showText(editor->mapToGlobal(QPoint(0, editor->height())), tr("This is not a number of metres"),
                         editor);
    }
  });
  return editor;
}

}  // namespace cad2slam
