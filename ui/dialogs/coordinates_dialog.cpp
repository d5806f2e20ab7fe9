// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/coordinates_dialog.h"

#include "ui/models/number_text.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QPushButton>

#include <algorithm>

namespace cad2slam {

CoordinatesDialog::CoordinatesDialog(QWidget* parent, const Anchor* anchor, AnchorId next_id) : QDialog(parent) {
  setWindowTitle(anchor ? tr("Coordinates of anchor %1").arg(anchor->id) : tr("New anchor %1").arg(next_id));
  const std::array<QString, 4> labels{tr("Blueprint &x (m):"), tr("Blueprint &y (m):"), tr("&SLAM map x (m):"),
                                      tr("SLAM &map y (m):")};
  auto* form = new QFormLayout(this);
  if (anchor) values_ = {anchor->in_blueprint.x(), anchor->in_blueprint.y(), anchor->in_slam.x(), anchor->in_slam.y()};
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    fields_[i] = new QLineEdit(this);
    if (anchor) texts_[i] = numberText(values_[i], 4);
    fields_[i]->setText(texts_[i]);
    connect(fields_[i], &QLineEdit::textChanged, this, &CoordinatesDialog::refresh);
    form->addRow(labels[i], fields_[i]);
  }
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  ok_ = buttons->button(QDialogButtonBox::Ok);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  form->addRow(buttons);
  refresh();
}

double CoordinatesDialog::value(std::size_t at) const {
  // A field left alone keeps the digits it does not show.
  if (!texts_[at].isEmpty() && fields_[at]->text() == texts_[at]) return values_[at];
  return parseNumber(fields_[at]->text()).value_or(0.0);
}

Eigen::Vector2d CoordinatesDialog::inBlueprint() const {
  return {value(0), value(1)};
}
Eigen::Vector2d CoordinatesDialog::inSlam() const {
  return {value(2), value(3)};
}

void CoordinatesDialog::refresh() {
  ok_->setEnabled(std::all_of(fields_.begin(), fields_.end(),
                              [](const QLineEdit* field) { return parseNumber(field->text()).has_value(); }));
}

}  // namespace cad2slam
