// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/coordinate_delegate.h"

#include "ui/models/number_text.h"

#include <QLineEdit>
#include <QToolTip>

namespace cad2slam {

QValidator::State NumberValidator::validate(QString& text, int&) const {
  return parseNumber(text) ? Acceptable : Intermediate;  // never Invalid: typing is not blocked, leaving is
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
