// SPDX-FileCopyrightText: 2026 The CAD2SLAM authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/preview_panel.h"

#include <cmath>
#include <initializer_list>

#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QResizeEvent>
#include <QSlider>
#include <QTextEdit>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/views/icons.h"

namespace cad2slam {
namespace {

struct ModeRow {
  PreviewMode mode;
  const char* text;
  const char* icon;
};
constexpr ModeRow kModes[] = {
    {PreviewMode::kOverlay, QT_TRANSLATE_NOOP("cad2slam::PreviewPanel", "Overlay"), "overlay"},
    {PreviewMode::kTwoInk, QT_TRANSLATE_NOOP("cad2slam::PreviewPanel", "Two inks"), "two_ink"},
    {PreviewMode::kSwipe, QT_TRANSLATE_NOOP("cad2slam::PreviewPanel", "Swipe"), "swipe"},
    {PreviewMode::kBlink, QT_TRANSLATE_NOOP("cad2slam::PreviewPanel", "Blink"), "blink"},
    {PreviewMode::kLens, QT_TRANSLATE_NOOP("cad2slam::PreviewPanel", "Lens"), "lens"},
    {PreviewMode::kMesh, QT_TRANSLATE_NOOP("cad2slam::PreviewPanel", "Mesh"), "mesh"},
    {PreviewMode::kResiduals, QT_TRANSLATE_NOOP("cad2slam::PreviewPanel", "Residuals"), "residuals"},
    {PreviewMode::kStretch, QT_TRANSLATE_NOOP("cad2slam::PreviewPanel", "Local scale"), "heat_map"},
    {PreviewMode::kRotation, QT_TRANSLATE_NOOP("cad2slam::PreviewPanel", "Local turn"), "rotate_right"},
    {PreviewMode::kCoverage, QT_TRANSLATE_NOOP("cad2slam::PreviewPanel", "Distance to anchors"), "coverage"},
    {PreviewMode::kAllMaps, QT_TRANSLATE_NOOP("cad2slam::PreviewPanel", "All SLAM maps"), "all_maps"},
};
static_assert(std::size(kModes) == kPreviewModeCount);

constexpr int kLeastSlider_px = 70;

bool isTyping(const QWidget* focused) {
  return qobject_cast<const QLineEdit*>(focused) != nullptr || qobject_cast<const QTextEdit*>(focused) != nullptr ||
         qobject_cast<const QPlainTextEdit*>(focused) != nullptr ||
         qobject_cast<const QAbstractSpinBox*>(focused) != nullptr;
}

/// Docks that float are windows of their own; dialogs are left alone.
bool isSameProgramWindow(const QWidget* a, const QWidget* b) {
  if (qobject_cast<const QDialog*>(a->window())) return false;
  const auto root = [](const QWidget* widget) {
    while (widget->parentWidget()) widget = widget->parentWidget();
    return widget;
  };
  return root(a) == root(b);
}

}  // namespace

PreviewPanel::PreviewPanel(QWidget* parent)
    : QWidget(parent),
      view_(new PreviewView(this)),
      modes_(new QComboBox(this)),
      opacity_label_(new QLabel(tr("Opacity"), this)),
      opacity_(new QSlider(Qt::Horizontal, this)),
      direction_(new QToolButton(this)),
      auto_blink_(new QToolButton(this)) {
  for (const ModeRow& row : kModes) modes_->addItem(icon(QLatin1String(row.icon)), tr(row.text));
  modes_->setToolTip(tr("How the maps are compared (O)"));
  modes_->setAccessibleName(tr("Preview mode"));
  modes_->setFocusPolicy(Qt::StrongFocus);
  connect(modes_, &QComboBox::currentIndexChanged, this, [this](int index) {
    if (index >= 0) setMode(kModes[index].mode);
  });

  opacity_->setRange(0, 100);
  opacity_->setValue(static_cast<int>(std::lround(view_->opacity() * 100.0)));
  opacity_->setMinimumWidth(kLeastSlider_px);
  opacity_->setMaximumWidth(160);
  opacity_->setToolTip(tr("How opaque the upper map is ([ and ])"));
  opacity_->setAccessibleName(tr("Opacity"));
  opacity_label_->setBuddy(opacity_);
  connect(opacity_, &QSlider::valueChanged, this, [this](int value) { view_->setOpacity(value / 100.0); });
  connect(view_, &PreviewView::opacityChanged, this,
          [this](double value) { opacity_->setValue(static_cast<int>(std::lround(value * 100.0))); });

  direction_->setIcon(icon(QStringLiteral("direction")));
  direction_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  connect(direction_, &QToolButton::clicked, this, &PreviewPanel::swapDirection);

  auto_blink_->setIcon(icon(QStringLiteral("blink")));
  auto_blink_->setText(tr("Blink by itself"));
  auto_blink_->setToolTip(tr("Change between the maps three times a second"));
  auto_blink_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  auto_blink_->setCheckable(true);
  connect(auto_blink_, &QToolButton::toggled, view_, &PreviewView::setAutoBlink);

  fit_ = new QToolButton(this);
  fit_->setIcon(icon(QStringLiteral("fit")));
  fit_->setToolTip(tr("Show the whole map (F)"));
  fit_->setAccessibleName(fit_->toolTip());
  connect(fit_, &QToolButton::clicked, view_, &MapView::fit);

  auto* controls = new QHBoxLayout;
  controls->setContentsMargins(4, 4, 4, 0);
  controls->addWidget(modes_);
  controls->addWidget(direction_);
  controls->addWidget(opacity_label_);
  controls->addWidget(opacity_);
  controls->addWidget(auto_blink_);
  controls->addStretch(1);
  controls->addWidget(fit_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  layout->addLayout(controls);
  layout->addWidget(view_, 1);
  showControls();
  qApp->installEventFilter(this);
}

void PreviewPanel::showControls() {
  const PreviewMode now = mode();
  const bool fades = now == PreviewMode::kOverlay || now == PreviewMode::kMesh || now == PreviewMode::kResiduals;
  opacity_->setVisible(fades);
  opacity_label_->setVisible(fades);
  auto_blink_->setVisible(now == PreviewMode::kBlink);
  direction_->setText(blueprint_below_ ? tr("SLAM map on blueprint") : tr("Blueprint on SLAM map"));
  direction_->setEnabled(now != PreviewMode::kAllMaps);
  direction_words_px_ = 0;
  fitControls();
}

void PreviewPanel::fitControls() {
  if (direction_words_px_ == 0) {
    direction_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    direction_words_px_ = direction_->sizeHint().width();
  }
  const auto wanted = [](const QWidget* widget) { return widget->isHidden() ? 0 : widget->sizeHint().width() + 8; };
  int all = direction_words_px_ + 8;
  for (const QWidget* widget : std::initializer_list<QWidget*>{modes_, auto_blink_, opacity_label_, fit_})
    all += wanted(widget);
  if (!opacity_->isHidden()) all += kLeastSlider_px + 8;
  // Where there is no room for words, icons have to do; tool tips say the same.
  const Qt::ToolButtonStyle look = all > width() ? Qt::ToolButtonIconOnly : Qt::ToolButtonTextBesideIcon;
  if (direction_->toolButtonStyle() != look) direction_->setToolButtonStyle(look);
  direction_->setToolTip(direction_->text() + QLatin1Char('\n') + tr("Which map lies below (Shift+O)"));
}

void PreviewPanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fitControls();
}

void PreviewPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) direction_words_px_ = 0;
}

QSize PreviewPanel::minimumSizeHint() const {
  // Not that of the words: they give way.
  return {modes_->minimumSizeHint().width() + kLeastSlider_px + 120, QWidget::minimumSizeHint().height()};
}

void PreviewPanel::setMode(PreviewMode mode) {
  if (mode == view_->mode()) return;
  if (mode != PreviewMode::kBlink) auto_blink_->setChecked(false);
  if (mode == PreviewMode::kAllMaps) setBlueprintBelow(true);
  view_->setMode(mode);
  modes_->setCurrentIndex(static_cast<int>(mode));
  showControls();
  emit modeChanged(mode);
}

void PreviewPanel::nextMode() {
  setMode(static_cast<PreviewMode>((static_cast<int>(mode()) + 1) % kPreviewModeCount));
}

void PreviewPanel::changeOpacity(double by) {
  view_->setOpacity(view_->opacity() + by);
}

void PreviewPanel::setBlueprintBelow(bool below) {
  if (below == blueprint_below_) return;
  blueprint_below_ = below;
  showControls();
  emit directionChanged(below);
}

bool PreviewPanel::eventFilter(QObject* watched, QEvent* event) {
  // Another window gets the release: this one must not go on as if the key were held.
  if (event->type() == QEvent::WindowDeactivate) view_->setBlinkHeld(false);
  const bool press = event->type() == QEvent::KeyPress;
  if ((press || event->type() == QEvent::KeyRelease) && watched->isWidgetType()) {
    const auto* key = static_cast<QKeyEvent*>(event);
    const bool is_b = key->key() == Qt::Key_B && (!press || key->modifiers() == Qt::NoModifier);
    const auto* widget = static_cast<QWidget*>(watched);
    if (is_b && view_->isVisible() && isSameProgramWindow(widget, this) && !isTyping(widget)) {
      if (!key->isAutoRepeat()) view_->setBlinkHeld(press);
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace cad2slam
