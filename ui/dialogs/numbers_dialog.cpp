// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/numbers_dialog.h"

#include "ui/models/number_text.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include <algorithm>

namespace cad2slam {

NumbersDialog::NumbersDialog(QWidget* parent, const QString& title, const std::vector<Field>& fields)
    : QDialog(parent) {
  setWindowTitle(title);
  auto* form = new QFormLayout(this);
  auto* heading = new QLabel(title, this);  // the title bar of a dialog so small is cut
  heading->setTextFormat(Qt::PlainText);
  form->addRow(heading);
  for (const Field& field : fields) {
    Entry entry{new QLineEdit(this), {}, field.value.value_or(0.0)};
    if (field.value) entry.text = numberText(*field.value, 4);
    entry.edit->setText(entry.text);
    connect(entry.edit, &QLineEdit::textChanged, this, &NumbersDialog::refresh);
    form->addRow(field.label, entry.edit);
    entries_.push_back(entry);
  }
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  ok_ = buttons->button(QDialogButtonBox::Ok);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  form->addRow(buttons);
  refresh();
}

double NumbersDialog::value(std::size_t field) const {
  const Entry& entry = entries_.at(field);
  if (!entry.text.isEmpty() && entry.edit->text() == entry.text) return entry.value;
  return parseNumber(entry.edit->text()).value_or(0.0);
}

void NumbersDialog::refresh() {
  ok_->setEnabled(std::all_of(entries_.begin(), entries_.end(),
                              [](const Entry& entry) { return parseNumber(entry.edit->text()).has_value(); }));
}

}  // namespace cad2slam
