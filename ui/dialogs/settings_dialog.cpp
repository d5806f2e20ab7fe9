// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/settings_dialog.h"

#include "ui/models/limits_text.h"
#include "ui/models/number_text.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTabWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace cad2slam {
namespace {

QString optionalText(const std::optional<double>& value) {
  return value ? shortNumberText(*value) : QString();
}

std::optional<double> numberIn(const NumberRange& range, const QLineEdit* field) {
  const std::optional<double> value = parseNumber(field->text());
  return value && range.holds(*value) ? value : std::nullopt;
}

std::optional<double> positive(const QLineEdit* field, const NumberRange& range = kWeightRange) {
  const std::optional<double> value = numberIn(range, field);
  return value && *value > 0.0 ? value : std::nullopt;
}

/// What takes no part in the model is zero.
std::optional<double> zeroOrMore(const QLineEdit* field) {
  return numberIn(kWeightRange, field);
}

}  // namespace

SettingsDialog::SettingsDialog(QWidget* parent, const ProjectSettings& settings, const Appearance& appearance)
    : QDialog(parent), before_(settings) {
  setWindowTitle(tr("Settings"));
  auto* tabs = new QTabWidget(this);
  tabs->addTab(solverPage(), tr("&Alignment"));
  tabs->addTab(limitsPage(), tr("&Limits"));
  tabs->addTab(appearancePage(), tr("A&ppearance"));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  ok_ = buttons->button(QDialogButtonBox::Ok);

  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(tabs);
  layout->addWidget(buttons);

  fill(settings.solver);
  cell_size_->setText(optionalText(settings.cell_size_m));
  ok_m_->setText(shortNumberText(settings.limits.ok_m));
  ok_cells_->setText(shortNumberText(settings.limits.ok_cells));
  look_m_->setText(shortNumberText(settings.limits.look_m));
  look_cells_->setText(shortNumberText(settings.limits.look_cells));
  theme_->setCurrentIndex(static_cast<int>(appearance.theme));
  language_->setCurrentIndex(std::max(0, language_->findData(appearance.language)));
  connect(model_, &QComboBox::activated, this,
          [this](int at) { fill(defaultSettings(at == 0 ? Model::kStretch : Model::kRigid)); });
  refresh();
}

QLineEdit* SettingsDialog::numberField(QFormLayout& form, const QString& label, const QString& tip,
                                       const QString& object_name) {
  auto* field = new QLineEdit(this);
  field->setObjectName(object_name);
  field->setToolTip(tip);
  connect(field, &QLineEdit::textChanged, this, &SettingsDialog::refresh);
  form.addRow(label, field);
  return field;
}

QWidget* SettingsDialog::solverPage() {
  auto* page = new QWidget(this);
  auto* form = new QFormLayout(page);
  model_ = new QComboBox(this);
  model_->setObjectName(QStringLiteral("model"));
  model_->addItem(tr("Stretch: bends and stretches (recommended)"));
  model_->addItem(tr("Rigid: bends only, as in the paper"));
  form->addRow(tr("&Model:"), model_);
  stiffness_ = new QComboBox(this);
  stiffness_->setObjectName(QStringLiteral("stiffness"));
  const auto add = [&](const QString& text, Stiffness stiffness) {
    stiffness_->addItem(text, static_cast<int>(stiffness));
  };
  add(tr("Automatic: what predicts the anchors best (recommended)"), Stiffness::kAutomatic);
  add(tr("Local: corridors that drifted each by themselves"), Stiffness::kLocal);
  add(tr("Smooth: halls that bend as a whole"), Stiffness::kSmooth);
  add(tr("Loose: clicks that are noisier than the map is bent"), Stiffness::kLoose);
  add(tr("The numbers below"), Stiffness::kGiven);
  form->addRow(tr("S&tiffness:"), stiffness_);
  connect(stiffness_, &QComboBox::activated, this, &SettingsDialog::showStiffness);
  scale_rule_ = new QComboBox(this);
  scale_rule_->addItem(tr("The plan is to scale"));
  scale_rule_->addItem(tr("Unknown: find it from the anchors"));
  scale_rule_->addItem(tr("A number I know"));
  connect(scale_rule_, &QComboBox::currentIndexChanged, this, &SettingsDialog::refresh);
  form->addRow(tr("&Scale of the blueprint:"), scale_rule_);
  fixed_scale_ = numberField(*form, tr("SLAM metres per blueprint metre:"), tr("1 where both are true to scale"),
                             QStringLiteral("fixedScale"));
  cell_size_ = numberField(*form, tr("&Cell size of the mesh (m):"), tr("Smaller follows finer bends and takes longer"),
                           QStringLiteral("cellSize"));
  cell_size_->setPlaceholderText(tr("automatic"));
  anchor_information_ = numberField(*form, tr("Pull of an anchor:"), tr("Larger trusts the clicks more"),
                                    QStringLiteral("anchorInformation"));
  loss_width_ = numberField(*form, tr("Bad anchors start at (m):"),
                            tr("An anchor off by more than this loses its pull; empty trusts every anchor"),
                            QStringLiteral("lossWidth"));
  loss_width_->setPlaceholderText(tr("never"));
  lambda_x_ = numberField(*form, tr("Stiffness along an edge:"), {}, QStringLiteral("lambdaX"));
  lambda_y_ = numberField(*form, tr("Stiffness across an edge:"), {}, QStringLiteral("lambdaY"));
  lambda_theta_ = numberField(*form, tr("Stiffness of bending:"), tr("Empty follows the size of the building"),
                              QStringLiteral("lambdaTheta"));
  lambda_theta_->setPlaceholderText(tr("automatic"));
  lambda_stretch_ = numberField(*form, tr("Smoothness of the stretch:"), {}, QStringLiteral("lambdaStretch"));
  prior_ = numberField(*form, tr("Resistance to stretch:"), {}, QStringLiteral("prior"));
  auto* defaults = new QPushButton(tr("&Defaults of the model"), this);
  defaults->setObjectName(QStringLiteral("defaults"));
  defaults->setAutoDefault(false);
  defaults->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  connect(defaults, &QPushButton::clicked, this,
          [this] { fill(defaultSettings(model_->currentIndex() == 0 ? Model::kStretch : Model::kRigid)); });
  form->addRow(QString(), defaults);
  return page;
}

QWidget* SettingsDialog::limitsPage() {
  auto* page = new QWidget(this);
  auto* form = new QFormLayout(page);
  auto* text =
      new QLabel(tr("An anchor is judged by the error without it, from four anchors on. The larger of a length "
                    "and a number of SLAM map pixels counts. When most anchors are beyond the last limit, a message "
                    "says so. These limits are kept in the project."),
                 page);
  text->setWordWrap(true);
  form->addRow(text);
  ok_m_ = numberField(*form, tr("● OK up to (m):"), {}, QStringLiteral("okMetres"));
  ok_cells_ = numberField(*form, tr("● OK up to (pixels):"), {}, QStringLiteral("okCells"));
  look_m_ = numberField(*form, tr("◆ Have a look up to (m):"), {}, QStringLiteral("lookMetres"));
  look_cells_ = numberField(*form, tr("◆ Have a look up to (pixels):"), {}, QStringLiteral("lookCells"));
  auto* rule = new QLabel(badRuleText(), page);
  rule->setObjectName(QStringLiteral("badRule"));
  rule->setWordWrap(true);
  form->addRow(rule);
  return page;
}

QWidget* SettingsDialog::appearancePage() {
  auto* page = new QWidget(this);
  auto* form = new QFormLayout(page);
  theme_ = new QComboBox(this);
  theme_->addItems({tr("As the system"), tr("Light"), tr("Dark"), tr("High contrast, for sunlight")});
  form->addRow(tr("&Colours:"), theme_);
  language_ = new QComboBox(this);
  language_->addItem(tr("As the system"), QString());
  language_->addItem(QStringLiteral("English"), QStringLiteral("en"));
  language_->addItem(QStringLiteral("Deutsch"), QStringLiteral("de"));
  language_->addItem(QStringLiteral("Español"), QStringLiteral("es"));
  form->addRow(tr("&Language (from the next start):"), language_);
  return page;
}

void SettingsDialog::fill(const SolverSettings& solver) {
  model_->setCurrentIndex(solver.model == Model::kStretch ? 0 : 1);
  stiffness_->setCurrentIndex(stiffness_->findData(static_cast<int>(solver.stiffness)));
  scale_rule_->setCurrentIndex(static_cast<int>(solver.scale.rule));
  fixed_scale_->setText(shortNumberText(solver.scale.fixed_scale));
  anchor_information_->setText(shortNumberText(solver.anchor_information));
  loss_width_->setText(optionalText(solver.loss_width_m));
  lambda_x_->setText(shortNumberText(solver.lambda_x));
  lambda_y_->setText(shortNumberText(solver.lambda_y));
  lambda_theta_->setText(optionalText(solver.lambda_theta));
  lambda_stretch_->setText(shortNumberText(solver.lambda_stretch));
  prior_->setText(shortNumberText(solver.prior_strength));
  refresh();  // another model with the same numbers
}

Stiffness SettingsDialog::stiffness() const {
  return static_cast<Stiffness>(stiffness_->currentData().toInt());
}

void SettingsDialog::showStiffness() {
  // The numbers a name stands for, to look at or to begin with.
  const SolverSettings named = withStiffness(settings().solver, stiffness());
  lambda_x_->setText(shortNumberText(named.lambda_x));
  lambda_y_->setText(shortNumberText(named.lambda_y));
  lambda_theta_->setText(optionalText(named.lambda_theta));
  lambda_stretch_->setText(shortNumberText(named.lambda_stretch));
  prior_->setText(shortNumberText(named.prior_strength));
  refresh();
}

ProjectSettings SettingsDialog::settings() const {
  ProjectSettings result = before_;
  SolverSettings& solver = result.solver;
  solver.model = model_->currentIndex() == 0 ? Model::kStretch : Model::kRigid;
  solver.stiffness = stiffness();
  solver.scale.rule = static_cast<ScaleRule>(scale_rule_->currentIndex());
  solver.scale.fixed_scale = positive(fixed_scale_, kFixedScaleRange).value_or(solver.scale.fixed_scale);
  solver.anchor_information = positive(anchor_information_).value_or(solver.anchor_information);
  solver.loss_width_m = positive(loss_width_);
  solver.lambda_x = positive(lambda_x_).value_or(solver.lambda_x);
  solver.lambda_y = positive(lambda_y_).value_or(solver.lambda_y);
  solver.lambda_theta = positive(lambda_theta_);
  solver.lambda_stretch = zeroOrMore(lambda_stretch_).value_or(solver.lambda_stretch);
  solver.prior_strength = zeroOrMore(prior_).value_or(solver.prior_strength);
  result.cell_size_m = positive(cell_size_, kCellSizeRange);
  result.limits.ok_m = positive(ok_m_).value_or(result.limits.ok_m);
  result.limits.ok_cells = positive(ok_cells_).value_or(result.limits.ok_cells);
  result.limits.look_m = positive(look_m_).value_or(result.limits.look_m);
  result.limits.look_cells = positive(look_cells_).value_or(result.limits.look_cells);
  return result;
}

Appearance SettingsDialog::appearance() const {
  return {static_cast<Theme>(theme_->currentIndex()), language_->currentData().toString()};
}

void SettingsDialog::refresh() {
  if (!language_ || !ok_) return;
  const bool stretch = model_->currentIndex() == 0;
  fixed_scale_->setEnabled(scale_rule_->currentIndex() == static_cast<int>(ScaleRule::kFixed));
  stiffness_->setEnabled(stretch);
  const bool given = stiffness() == Stiffness::kGiven;
  anchor_information_->setEnabled(!stretch || stiffness() != Stiffness::kLoose);
  lambda_x_->setEnabled(given || !stretch);
  lambda_y_->setEnabled(given || !stretch);
  lambda_stretch_->setEnabled(given && stretch);
  prior_->setEnabled(stretch);
  bool good = true;
  for (QLineEdit* field : findChildren<QLineEdit*>()) {
    const bool may_be_empty = field == cell_size_ || field == loss_width_ || field == lambda_theta_;
    const bool empty = field->text().trimmed().isEmpty();
    const NumberRange& range = field == cell_size_     ? kCellSizeRange
                               : field == fixed_scale_ ? kFixedScaleRange
                                                       : kWeightRange;
    // What cannot be typed into takes no part: a rigid mesh has neither stretch nor resistance to it.
    const bool valid = !field->isEnabledTo(this) || (may_be_empty && empty) || positive(field, range);
    field->setStyleSheet(valid ? QString() : QStringLiteral("QLineEdit { border: 2px solid #c2185b; }"));
    good = good && valid;
  }
  ok_->setEnabled(good);
  ok_->setToolTip(good ? QString() : tr("The fields with a frame need a number above zero that a project can hold"));
}

}  // namespace cad2slam
