// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/export_dialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace cad2slam {
namespace {

using Verdict = ExportCheck::Verdict;

bool has(const std::vector<ExportCheck>& checks, Verdict verdict) {
  return std::any_of(checks.begin(), checks.end(), [&](const ExportCheck& check) { return check.verdict == verdict; });
}

}  // namespace

ExportDialog::ExportDialog(QWidget* parent, const std::vector<ExportCheck>& checks) : QDialog(parent) {
  setWindowTitle(tr("Export projector"));
  setMinimumWidth(520);
  const bool refused = has(checks, Verdict::kRefused);
  const bool warned = has(checks, Verdict::kWarning);
  auto* heading = new QLabel(refused  ? tr("There is nothing to export yet")
                             : warned ? tr("The projector can be written, but look at this first")
                                      : tr("Ready to export"));
  QFont font = heading->font();
  font.setBold(true);
  heading->setFont(font);

  auto* list = new QGridLayout;
  list->setColumnStretch(1, 1);
  for (const ExportCheck& check : checks) {
    const int row = list->rowCount();
    static constexpr const char16_t* kSigns[] = {u"✓", u"ℹ", u"▲", u"■"};
    static constexpr const char* kColors[] = {"#00796b", "#2a78c8", "#b26a00", "#c2185b"};
    const auto at = static_cast<std::size_t>(check.verdict);
    auto* mark = new QLabel(QString::fromUtf16(kSigns[at]), this);
    mark->setStyleSheet(QStringLiteral("color: %1").arg(QLatin1String(kColors[at])));
    auto* sentence = new QLabel(check.sentence, this);
    sentence->setTextFormat(Qt::PlainText);
    sentence->setWordWrap(true);
    list->addWidget(mark, row, 0, Qt::AlignTop);
    list->addWidget(sentence, row, 1);
  }

  auto* buttons = new QDialogButtonBox(refused ? QDialogButtonBox::Close : QDialogButtonBox::Cancel, this);
  if (!refused) {
    auto* go = buttons->addButton(warned ? tr("Export &anyway...") : tr("&Export..."), QDialogButtonBox::AcceptRole);
    // Without another default the first button that accepts would be it.
    QPushButton* default_button = warned ? buttons->button(QDialogButtonBox::Cancel) : go;
    default_button->setDefault(true);
    default_button->setFocus();
  }
  if (std::any_of(checks.begin(), checks.end(), [](const ExportCheck& check) { return check.solving_helps; })) {
    QPushButton* solve = buttons->addButton(tr("&Solve again"), QDialogButtonBox::ActionRole);
    solve->setDefault(true);
    solve->setFocus();
    connect(solve, &QPushButton::clicked, this, [this] { done(kSolveAgain); });
  }
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(heading);
  layout->addLayout(list);
  if (warned && !refused) {
    auto* note = new QLabel(tr("The warnings are written into the file."), this);
    note->setForegroundRole(QPalette::PlaceholderText);
    layout->addWidget(note);
  }
  if (!refused) {
    map_wanted_ = new QCheckBox(tr("Also write the blueprint as a &map in the robot's frame (YAML and PNG)"), this);
    map_wanted_->setObjectName(QStringLiteral("mapWanted"));
    layout->addWidget(map_wanted_);
  }
  layout->addStretch(1);
  layout->addWidget(buttons);
}

bool ExportDialog::isMapWanted() const {
  return map_wanted_ && map_wanted_->isChecked();
}

}  // namespace cad2slam
